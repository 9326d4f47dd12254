"""Which topics a sentence is about."""

import re
import time
from dataclasses import dataclass, field

import pytest
from hypothesis import given, settings
from hypothesis import strategies as some

from dialogue.engine.keywords import KeywordRow, build_index
from languages.known import LANGUAGES
from languages.language import Token

TEA, GREEN_TEA, ORANGE, JUICE, MUSIC, JAZZ, COFFEE, FRUIT = range(1, 9)


@dataclass(frozen=True)
class SmallLanguage:
    """Words with the few inflections that a test names."""

    inflected: dict[str, set[str]] = field(default_factory=dict)
    spaced: bool = True

    def tokens(self, sentence: str) -> tuple[Token, ...]:
        words = re.finditer(r"\w+", sentence.casefold())
        return tuple(Token(word.group(), word.start(), word.end()) for word in words)

    def inflections(self, word: str) -> frozenset[str]:
        return frozenset(self.inflected.get(word, set()) | {word})

    def fold(self, text: str) -> str:
        return text.translate(str.maketrans("èéà", "eea"))


ENGLISH = SmallLanguage({"biscuit": {"biscuits"}, "cat": {"cats"}, "house": {"houses"}})


def topics(index, sentence):
    """Return the topics a sentence matches, best first."""
    return [match.topic for match in index.search(sentence)]


def small(*rows, language=ENGLISH):
    """Return an index of rows written as (topic, "one|other / third")."""
    written = []
    for topic, sets in rows:
        first, second = (tuple(part.strip().split("|")) for part in sets.split("/"))
        written.append(KeywordRow(topic, first, second))
    return build_index(language, written)


def japanese(*rows):
    """Return an index of rows in real Japanese."""
    return small(*rows, language=LANGUAGES["ja"])


DRINKS = small(
    (TEA, "tea / *"), (GREEN_TEA, "green / tea"), (COFFEE, "coffee|espresso / cup|drink")
)


def test_green_tea_comes_before_tea():
    matches = DRINKS.search("I love my Green TEA!")
    assert [match.topic for match in matches] == [GREEN_TEA, TEA]
    assert matches[0].words == ("Green", "TEA")
    assert not matches[0].wildcard
    assert matches[1].wildcard
    assert matches[0].rank > matches[1].rank


def test_one_of_two_sets_is_not_enough():
    assert topics(DRINKS, "I like coffee") == []
    assert topics(DRINKS, "I drink coffee") == [COFFEE]
    assert topics(DRINKS, "an espresso in a small cup") == [COFFEE]


@pytest.mark.parametrize("sentence", ["", "   ", "?!", "I like teapots and steam", "teas"])
def test_a_keyword_is_never_found_inside_other_words(sentence):
    assert topics(DRINKS, sentence) == []


def test_both_sets_need_words_of_their_own():
    index = small((GREEN_TEA, "tea / tea|green"))
    assert topics(index, "tea") == []
    assert topics(index, "tea, tea") == [GREEN_TEA]
    assert topics(index, "green tea") == [GREEN_TEA]


def test_overlapping_phrases_are_not_two_places():
    index = small((JUICE, "orange juice / juice bar"))
    assert topics(index, "orange juice bar") == []
    assert topics(index, "orange juice at the juice bar") == [JUICE]


def test_a_wildcard_may_stand_in_either_set():
    index = small((TEA, "* / tea"), (JAZZ, "jazz|* / music"))
    assert topics(index, "tea") == [TEA]
    assert [match.wildcard for match in index.search("jazz music")] == [False]
    assert [match.wildcard for match in index.search("some music")] == [True]


def test_a_set_without_words_never_matches():
    index = build_index(
        ENGLISH, [KeywordRow(TEA, ("tea",), ()), KeywordRow(COFFEE, ("*",), ("*",))]
    )
    assert topics(index, "tea and coffee") == []


def test_the_longer_wildcard_keyword_comes_first():
    index = small((ORANGE, "orange / *"), (JUICE, "orange juice / *"))
    assert topics(index, "I drink orange juice") == [JUICE, ORANGE]


def test_words_inside_a_longer_keyword_of_another_topic_rank_below_it():
    index = small((FRUIT, "orange / juice"), (JUICE, "orange juice / *"))
    assert topics(index, "orange juice") == [JUICE, FRUIT]
    assert topics(index, "juice of an orange") == [FRUIT]


def test_a_longer_keyword_of_a_topic_that_does_not_match_takes_nothing_away():
    index = small((ORANGE, "orange / *"), (JUICE, "orange juice / breakfast"))
    assert topics(index, "orange juice") == [ORANGE]


def test_inflected_forms_match_in_every_word_of_a_phrase():
    index = small((ORANGE, "biscuit / *"), (JAZZ, "cat house / *"))
    assert topics(index, "two biscuits") == [ORANGE]
    assert topics(index, "cats houses") == [JAZZ]


def test_a_topic_with_several_rows_comes_once_with_its_best():
    index = small((TEA, "tea / *"), (TEA, "tea / cup"))
    (match,) = index.search("a cup of tea")
    assert match.words == ("tea", "cup")


def test_a_missing_or_an_extra_accent_is_forgiven_in_long_words():
    index = small((COFFEE, "caffè / *"), (MUSIC, "melodia / *"), (TEA, "tè / *"))
    assert topics(index, "un caffe") == [COFFEE]
    assert topics(index, "una mèlodia") == [MUSIC]
    assert topics(index, "un tè") == [TEA]
    assert topics(index, "con te") == []


def test_the_exact_word_comes_before_the_one_with_other_accents():
    index = small((TEA, "papà / *"), (COFFEE, "papa / *"))
    assert topics(index, "il papa") == [COFFEE]
    assert topics(index, "il papà") == [TEA]


def test_a_common_second_word_does_not_look_at_its_hundred_topics():
    index = small(*((number, f"kind{number} / music") for number in range(100)))
    assert topics(index, "kind7 music") == [7]
    music = [rows for rows in index.rows.values() if len(rows) > 1]
    assert music == []


def test_a_phrase_of_many_words_is_inflected_at_its_end_only():
    words = {name: {f"{name}{number}" for number in range(9)} for name in ("cat", "house", "tea")}
    index = small((TEA, "cat house tea / *"), language=SmallLanguage(words))
    assert topics(index, "cat house tea8") == [TEA]
    assert topics(index, "cat1 house tea8") == []


def test_a_keyword_without_letters_is_refused_with_its_topic():
    with pytest.raises(ValueError, match="Keyword '!!' of topic 1"):
        small((TEA, "!! / *"))


@pytest.mark.parametrize(
    ("sentence", "found"),
    [
        ("緑茶が好きです", [GREEN_TEA]),
        ("緑の茶碗", [GREEN_TEA, TEA]),
        ("お茶を飲みます", [TEA]),
        ("こんにちは", []),
    ],
)
def test_japanese_words_inside_longer_ones_count_for_two_sets_only(sentence, found):
    index = japanese((GREEN_TEA, "緑 / 茶"), (TEA, "茶|お茶 / *"), (COFFEE, "緑茶 / コーヒー"))
    assert topics(index, sentence) == found


@pytest.mark.parametrize("sentence", ["パンダが好き", "シャンパン", "ﾊﾟﾝﾀﾞ", "フライパンで焼く"])
def test_a_katakana_keyword_is_not_found_inside_a_longer_run(sentence):
    assert topics(japanese((FRUIT, "パン / *")), sentence) == []


@pytest.mark.parametrize(
    "sentence", ["パンが好き", "ﾊﾟﾝを食べる", "朝はパン", "菓子パン", "パン・ケーキ"]
)
def test_a_katakana_keyword_is_found_as_a_run_of_its_own(sentence):
    assert topics(japanese((FRUIT, "パン / *")), sentence) == [FRUIT]


def test_a_name_of_two_katakana_words_is_found_with_and_without_its_dot():
    index = japanese((MUSIC, "トム・ハンクス / *"))
    (match,) = index.search("俳優のトム・ハンクスさん")
    assert match.words == ("トム・ハンクス",)
    assert topics(index, "トムハンクスの映画") == [MUSIC]


def test_a_latin_keyword_in_japanese_is_a_whole_word():
    index = japanese((MUSIC, "jazz / *"))
    assert topics(index, "JAZZを聴く") == [MUSIC]
    assert topics(index, "Jazzyな曲") == []


def test_the_other_kana_is_a_second_chance():
    index = japanese((ORANGE, "ねこ / *"), (FRUIT, "バス / *"), (JUICE, "オレンジ / *"))
    assert topics(index, "ネコが好き") == [ORANGE]
    assert topics(index, "おれんじのジュース") == [JUICE]
    assert topics(index, "鳥を飛ばす") == []


def test_japanese_words_are_given_as_the_person_wrote_them():
    index = japanese((GREEN_TEA, "緑茶|茶 / jazz"))
    (match,) = index.search("毎朝、ＪＡＺＺと緑茶。")
    assert match.words == ("緑茶", "ＪＡＺＺ")


@settings(max_examples=150, deadline=None)
@given(some.text(max_size=60), some.sampled_from(list(LANGUAGES)))
def test_any_sentence_is_searched_and_words_come_from_it(sentence, code):
    rows = [KeywordRow(1, ("a", "パ", "e 1"), ("*",)), KeywordRow(2, ("パン", "é"), ("a", "茶"))]
    for match in build_index(LANGUAGES[code], rows).search(sentence):
        assert all(word and word in sentence for word in match.words)


@settings(max_examples=100, deadline=None)
@given(some.lists(some.sampled_from(["green", "tea", "orange", "juice", "and", "cup"]), max_size=9))
def test_the_index_finds_what_a_plain_scan_over_topics_finds(words):
    rows = {1: ("green", "tea"), 2: ("tea", "cup"), 3: ("orange", "juice"), 4: ("cup", "*")}
    index = build_index(ENGLISH, [KeywordRow(n, (a,), (b,)) for n, (a, b) in rows.items()])
    expected = {n for n, (a, b) in rows.items() if a in words and (b == "*" or b in words)}
    assert set(topics(index, " ".join(words))) == expected


@pytest.mark.parametrize("code", ["en", "ja"])
@pytest.mark.parametrize("unit", ["green tea ", "tea", "パン", "茶", "パ・", "é "])
def test_a_long_hostile_sentence_costs_in_proportion_to_its_length(code, unit):
    rows = [
        KeywordRow(n, ("green", "tea", "茶", "パン" * n), ("tea", "パン", "茶"))
        for n in range(1, 20)
    ]
    index = build_index(LANGUAGES[code], rows)

    def quickest(sentence):
        times = []
        for _ in range(5):
            begin = time.process_time_ns()
            index.search(sentence)
            times.append(time.process_time_ns() - begin)
        return min(times)

    short, long = unit * (240 // len(unit)), unit * (1_920 // len(unit))
    assert quickest(long) < 8 * 3 * quickest(short) + 1_000_000


def test_a_japanese_keyword_does_not_reach_over_a_pause():
    index = japanese((MUSIC, "たいくつ / *"), (TEA, "お茶 / *"))
    assert topics(index, "あんた、いくつなん") == []
    assert set(topics(index, "たいくつ、お茶でも")) == {MUSIC, TEA}
