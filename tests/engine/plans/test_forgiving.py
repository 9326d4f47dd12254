"""What is forgiven: fillers, hesitations, spelling, blanks; what is only asked; what is refused."""

from random import Random

import msgspec
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plans.engine.catalogue import Catalogue, IntentMatch, compile_catalogue
from plans.engine.intents import Intent, Library, Phrase, Slot
from tests.engine.growth import grows_like_a_line
from tests.engine.plans.worlds import LIBRARY

FILLERS = Phrase(
    key="fillers",
    texts={"en": "you know|kindly|just", "it": "cioè|diciamo", "ja": "まあ|なんか"},
)
SOUNDS = Phrase(key="hesitations", texts={"en": "um|uh", "it": "ehm", "ja": "えっと"})
DANCE = Intent(
    number=20,
    key="dance",
    slots=(Slot(name="style"),),
    triggers={
        "en": ("show me how people dance [in {style}]", "turn on the radio today"),
        "it": ("fammi vedere come si balla", "la musica è la mia passione"),
        "ja": ("ラジオたいそうを 見せて ほしい",),
    },
    plan_sentences={},
)


def robot(*intents: Intent) -> Catalogue:
    return compile_catalogue(
        Library(
            intents=(*LIBRARY.intents, DANCE, *intents),
            values=LIBRARY.values,
            phrases=(*LIBRARY.phrases, FILLERS, SOUNDS),
        )
    )


ROBOT = robot()


def acted(sentence: str, language: str = "en") -> tuple[str, str]:
    match = ROBOT.match(sentence, language)
    return (match.intent.key, match.way) if match else ("", "")


def asked(sentence: str, language: str = "en") -> str:
    assert ROBOT.match(sentence, language) is None
    match = ROBOT.suggest(sentence, language)
    assert match is None or match.way == "suggestion"
    return match.intent.key if match else ""


def matched(sentence: str, language: str = "en") -> IntentMatch:
    match = ROBOT.match(sentence, language)
    assert match is not None
    return match


def test_a_sentence_that_fits_is_understood_by_its_words() -> None:
    assert acted("play some music") == ("playsong", "words")


def test_a_clause_says_so() -> None:
    assert acted("oh no, help me") == ("alarm", "clause")


@pytest.mark.parametrize(
    ("sentence", "language"),
    [
        ("show me, you know, how people dance", "en"),
        ("kindly show me how you know people just dance", "en"),
        ("show me um how people uh dance", "en"),
        ("fammi vedere, cioè, come si balla", "it"),
        ("ラジオたいそうをなんか見せてほしい", "ja"),
        ("えっとラジオたいそうを見せてほしい", "ja"),
    ],
)
def test_listed_fillers_are_left_out_anywhere(sentence: str, language: str) -> None:
    assert acted(sentence, language) == ("dance", "fillers")


def test_a_filler_inside_captured_words_stays_in_them() -> None:
    match = matched("kindly play Just the Way You Are")
    assert match.parameters == {"title": "Just the Way You Are"}
    assert matched("play the um song").parameters == {"title": "the um song"}


def test_a_hesitation_at_the_edge_of_captured_words_is_not_theirs() -> None:
    assert matched("play um Volare uh").parameters == {"title": "Volare"}


def test_an_aside_at_the_edge_of_captured_words_is_not_theirs() -> None:
    assert matched("play, you know, Volare").parameters == {"title": "Volare"}
    assert matched("play Volare, you know").parameters == {"title": "Volare"}
    assert matched("play You Know").parameters == {"title": "You Know"}


def test_only_fillers_ask_for_nothing() -> None:
    assert acted("um") == ("", "")
    assert acted("kindly just") == ("", "")


@pytest.mark.parametrize(
    "sentence",
    [
        "show me how poeple dance",
        "show me how peple dance",
        "show me how peoplle dance",
        "show me how peogle dance",
        "show me howpeople dance",
        "turn onthe radio today",
        "turn on the radio to day",
        "show me how people dance in Itlay",
    ],
)
def test_one_wrong_word_is_mended_where_the_rest_is_proof(sentence: str) -> None:
    assert acted(sentence)[0] == "dance"


def test_a_mended_word_is_told() -> None:
    match = matched("turn onthe radio today")
    assert match.way == "spelling"
    assert "'onthe' was read as 'on the'" in match.why


def test_a_lost_accent_of_a_short_word_is_mended() -> None:
    assert acted("la musica e la mia passione", "it") == ("dance", "spelling")


def test_a_mended_sentence_keeps_the_persons_spelling_of_parameters() -> None:
    assert matched("show me how poeple dance in SPAIN").parameters == {"style": "SPAIN"}


@pytest.mark.parametrize(
    "sentence",
    [
        "plan the party",
        "I liked tea",
        "I lived music",
        "pay Volare",
        "show you how poeple danced",
        "shwo me how poeple dance",
    ],
)
def test_spelling_does_not_turn_talk_into_requests(sentence: str) -> None:
    assert acted(sentence) == ("", "")


@pytest.mark.parametrize("sentence", ["plan the party", "I liked tea", "We planted potatoes"])
def test_talk_is_not_even_asked_about(sentence: str) -> None:
    assert asked(sentence) == ""


@pytest.mark.parametrize(
    ("sentence", "key"),
    [
        ("pkay some music", "playsong"),
        ("hopefully play some music", "playsong"),
        ("play some music buddy boy", "playsong"),
        ("show me darling how people dance", "dance"),
        ("show me people dance", "dance"),
        ("hepl me", "alarm"),
    ],
)
def test_what_is_uncertain_is_asked(sentence: str, key: str) -> None:
    if ROBOT.match(sentence, "en") is None:
        assert asked(sentence) == key
    else:
        assert acted(sentence)[0] == key


@pytest.mark.parametrize(
    "sentence", ["we play some music every day", "she said help me", "because play some music"]
)
def test_a_statement_around_the_words_is_no_request(sentence: str) -> None:
    assert asked(sentence) == ""


@pytest.mark.parametrize(
    "sentence", ["ラジオたいそーうを見せてほしい", "ララジオたいそうを見せてほしい"]
)
def test_a_long_or_doubled_character_is_forgiven(sentence: str) -> None:
    assert acted(sentence, "ja") == ("dance", "spelling")


def test_another_character_in_japanese_is_asked() -> None:
    assert asked("ラジオたいそうと見せてほしい", "ja") == "dance"


def test_another_tense_in_japanese_is_another_sentence() -> None:
    assert asked("ラジオたいそうを見せてほしく", "ja") == ""


def test_an_unknown_language_suggests_nothing() -> None:
    assert ROBOT.suggest("pkay some music", "xx") is None


@given(st.text(max_size=80), st.sampled_from(["en", "it", "ja"]))
@settings(max_examples=200, deadline=None)
def test_any_text_can_be_suggested_for(sentence: str, language: str) -> None:
    for text in (sentence, "show me how " + sentence, "ラジオたいそう" + sentence):
        ROBOT.suggest(text, language)


@given(st.integers(0, 10_000), st.sampled_from(["um", "kindly", "you know"]))
@settings(max_examples=60, deadline=None)
def test_a_filler_never_changes_the_intent(seed: int, filler: str) -> None:
    words = Random(seed).choice(["play some music", "show me how people dance"]).split()
    place = Random(seed + 1).randint(0, len(words))
    heard = " ".join([*words[:place], filler, *words[place:]])
    assert acted(heard)[0] == acted(" ".join(words))[0] == matched(heard).intent.key


HOSTILE = Intent(
    number=30,
    key="hostile",
    slots=(Slot(name="x"), Slot(name="y")),
    triggers={
        "en": (
            "[a [a [a [a] a] a] a] [a [a [a [a] a] a] a] {x} b [a [a] a] {y} c",
            f"({'|'.join(f'w{number} a' for number in range(60))}) [a|a a|a a a] {{x}} d",
            "a b c d e f g h",
        ),
        "ja": ("[ああ|あ] [ああ|あ] い {x} い [ああ|あああ] う",),
    },
    plan_sentences={},
)
#: Letters from which a sentence is no longer read the quick way.
LONG = 2_600
ENDLESS = [
    "a ",
    "a b ",
    "um ",
    "kindly you know ",
    "pleese ",
    "abcd ",
    "\U0001f600 ",
    "a\u0301\u0302 ",
    "\u200b",
    "あ",
    "いう",
    "x",
    "ラジオたいそう",
    "show me how ",
]


@pytest.mark.parametrize("piece", ENDLESS)
@pytest.mark.parametrize("language", ["en", "ja"])
def test_hostile_sentences_take_linear_time(piece: str, language: str) -> None:
    catalogue = robot(HOSTILE)

    def listen(size: int) -> None:
        for sentence in (piece * size, "a b " + piece * size + " c", "い" + piece * size + "う"):
            forget(catalogue)
            catalogue.match(sentence, language)
            catalogue.suggest(sentence, language)

    listen(7)
    assert grows_like_a_line(listen, 7)
    assert grows_like_a_line(listen, LONG // len(piece) + 300)


def forget(catalogue: Catalogue) -> None:
    for matchers in catalogue.matchers.values():
        for matcher in matchers:
            matcher._heard.clear()  # type: ignore[attr-defined]


def test_what_is_remembered_changes_nothing_and_is_bounded() -> None:
    for number in range(100):
        assert acted(f"play song {number}") == ("playsong", "words")
    (matcher,) = ROBOT.matchers["en"]
    assert len(matcher._heard) <= 16  # type: ignore[attr-defined]
    assert acted("show me how poeple dance") == acted("show me how poeple dance")


def test_a_library_without_fillers_works() -> None:
    plain = compile_catalogue(msgspec.structs.replace(LIBRARY, phrases=()))
    assert plain.match("play some music", "en") is not None
