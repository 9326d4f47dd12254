"""Sentences into words, with the way back to the person's own spelling."""

from unicodedata import normalize

import pytest
from hypothesis import given, settings
from hypothesis import strategies as some

from languages.known import LANGUAGES
from languages.tokens import normalise
from tests.engine.growth import grows_like_a_line

SENTENCES = some.text(
    some.one_of(some.characters(), some.sampled_from("aZ9'’ èÈe\u0300ﬁ½ｶﾞ茶かー。？\u00ad")),
    max_size=40,
)


def words(language: str, sentence: str) -> list[str]:
    return [token.text for token in LANGUAGES[language].tokens(sentence)]


@pytest.mark.parametrize(
    ("sentence", "expected"),
    [
        ("Don't STOP!", ["don", "t", "stop"]),
        ("Don’t stop", ["don", "t", "stop"]),
        ("at 7pm, room12", ["at", "7", "pm", "room", "12"]),
        ("one-way  street", ["one", "way", "street"]),
        ("snake_case", ["snake", "case"]),
        ("", []),
        ("?!…", []),
    ],
)
def test_english_words_lose_case_and_punctuation(sentence: str, expected: list[str]) -> None:
    assert words("en", sentence) == expected


def test_an_italian_apostrophe_ends_a_word() -> None:
    assert words("it", "L'arte dell'Ottocento, perché no?") == [
        "l", "arte", "dell", "ottocento", "perché", "no",
    ]  # fmt: skip


def test_a_decomposed_accent_is_the_same_word() -> None:
    assert words("it", normalize("NFD", "Il caffè è così")) == ["il", "caffè", "è", "così"]


def test_japanese_kana_and_kanji_stand_alone_and_latin_words_whole() -> None:
    assert words("ja", "緑茶とＣＤ１２枚") == ["緑", "茶", "と", "cd", "12", "枚"]


def test_the_middle_dot_and_half_width_katakana_do_not_matter() -> None:
    assert words("ja", "ﾗ・ｽﾍﾟﾂｨｱ") == words("ja", "ラスペツィア")


@pytest.mark.parametrize(
    ("sentence", "own"),
    [
        ("Play ﬁne MUSIC", ["Play", "ﬁne", "MUSIC"]),
        ("perche\u0300 no", ["perche\u0300", "no"]),
        ("½ cup", ["½", "½", "cup"]),
        ("ca\u00adfé", ["ca\u00adfé"]),
    ],
)
def test_offsets_give_the_persons_own_spelling(sentence: str, own: list[str]) -> None:
    tokens = LANGUAGES["en"].tokens(sentence)
    assert [sentence[token.start : token.end] for token in tokens] == own


@given(SENTENCES, some.sampled_from(list(LANGUAGES)))
def test_every_word_is_found_again_in_the_sentence(sentence: str, language: str) -> None:
    end = 0
    for token in LANGUAGES[language].tokens(sentence):
        assert token.text in normalise(sentence[token.start : token.end])
        assert end <= token.end <= len(sentence)
        end = token.end


@given(SENTENCES, some.sampled_from(list(LANGUAGES)))
def test_normalised_words_stay_as_they_are(sentence: str, language: str) -> None:
    found = words(language, sentence)
    again = words(language, " ".join(found))
    assert [word for word in again if word in found] == again


@settings(max_examples=8, deadline=None)
@given(some.sampled_from(list(LANGUAGES)), some.text(min_size=1, max_size=3))
def test_tokenising_is_linear(language: str, piece: str) -> None:
    tokens = LANGUAGES[language].tokens
    assert grows_like_a_line(lambda size: tokens(piece * size), 4_000)


def test_a_thousand_accents_on_one_letter_are_harmless() -> None:
    tokens = LANGUAGES["it"].tokens
    assert grows_like_a_line(lambda size: tokens("e" + "\u0323\u0300" * size), 2_000)


@pytest.mark.parametrize(
    ("language", "text", "folded"),
    [
        ("it", "Però CAFFÈ", "pero caffe"),
        ("en", "Zoë’s smørrebrød", "zoe’s smorrebrod"),
        ("en", "plain", "plain"),
        ("ja", "コーヒーとヶ", "こーひーとけ"),
    ],
)
def test_folding_takes_accents_away(language: str, text: str, folded: str) -> None:
    assert LANGUAGES[language].fold(text) == folded


@given(SENTENCES)
def test_folding_japanese_keeps_every_position(sentence: str) -> None:
    assert len(LANGUAGES["ja"].fold(sentence)) == len(sentence)
