"""Free words that have swallowed another request, and requests an error away from a sentence."""

import pytest

from plans.engine.catalogue import Catalogue, IntentMatch, compile_catalogue
from plans.engine.intents import Intent, Library, Phrase, Slot

SONG = Intent(
    number=1,
    key="song",
    slots=(Slot(name="title"),),
    triggers={
        "en": ("(play|put on|call) {title}",),
        "ja": ("{title} を (かけて|流して|聞かせて)",),
    },
    plan_sentences={},
)
FILM = Intent(
    number=2,
    key="film",
    triggers={
        "en": ("put on the movie", "can you put on a film for me", "are you happy"),
        "ja": ("映画 を かけて", "(ご機嫌いかがですか|ごきげんいかがですか)", "疲れた"),
    },
    plan_sentences={},
)
POLICE = Intent(
    number=3,
    key="police",
    priority=100,
    triggers={"en": ("call the (police|doctor)",), "ja": ("タイマー を [すぐ] かけて",)},
    plan_sentences={},
)
PHRASES = (
    Phrase(key="fillers", texts={"en": "maybe|well|just", "ja": "やっぱ|まあ"}),
    Phrase(key="skip_start", texts={"en": "could you|please"}),
    Phrase(key="not_in_topic", texts={"ja": "けど"}),
)
ROBOT: Catalogue = compile_catalogue(Library(intents=(SONG, FILM, POLICE), phrases=PHRASES))


def heard(sentence: str, language: str = "en") -> tuple[str, str]:
    match = ROBOT.match(sentence, language)
    return (match.intent.key, match.way) if match else ("", "")


def asked(sentence: str, language: str) -> str:
    assert ROBOT.match(sentence, language) is None
    found = ROBOT.suggest(sentence, language)
    return found.intent.key if found else ""


def of(sentence: str, language: str = "en") -> IntentMatch:
    match = ROBOT.match(sentence, language)
    assert match is not None
    return match


@pytest.mark.parametrize(
    ("sentence", "language", "wanted"),
    [
        ("put on the movie maybe", "en", ("film", "fillers")),
        ("call the police well", "en", ("police", "fillers")),
        ("put on the movei", "en", ("film", "spelling")),
        ("call the polce", "en", ("police", "spelling")),
        ("やっぱ映画をかけて", "ja", ("film", "fillers")),
    ],
)
def test_another_request_is_not_swallowed_by_free_words(
    sentence: str, language: str, wanted: tuple[str, str]
) -> None:
    assert heard(sentence, language) == wanted


@pytest.mark.parametrize(
    ("sentence", "title"),
    [
        ("play Call Me Maybe", "Call Me Maybe"),
        ("play Just the Way", "Just the Way"),
        ("play the movei", "the movei"),
        ("put on the moon", "the moon"),
    ],
)
def test_a_title_that_only_looks_wrong_stays_as_it_was_said(sentence: str, title: str) -> None:
    assert of(sentence).intent.key == "song"
    assert of(sentence).parameters == {"title": title}


def test_a_lost_blank_behind_a_skip_word_is_forgiven() -> None:
    assert heard("could youput on the movie") == ("film", "spelling")
    assert heard("pleaseplay Volare") == ("", "")


def test_a_short_word_is_mended_where_two_others_stand() -> None:
    assert heard("are you hapy") == ("film", "spelling")


@pytest.mark.parametrize(
    "sentence", ["ご機嫌いがですか", "ご機かいかがですか", "映画とかけて", "ご嫌いかがですか"]
)
def test_one_wrong_character_in_a_short_sentence_is_asked(sentence: str) -> None:
    assert asked(sentence, "ja") == "film"


def test_a_long_vowel_that_was_lost_is_forgiven() -> None:
    assert heard("タイマをかけて", "ja")[0] == "song"  # it is a title as well
    assert ROBOT.match("ご機嫌いーかがですか", "ja") is not None


def test_a_soft_ending_is_asked_about() -> None:
    assert asked("ご機嫌いかがですかなんだけど", "ja") == "film"
    assert asked("疲れたけど", "ja") == ""


def test_of_two_that_fit_equally_the_first_of_the_library_is_taken() -> None:
    twins = tuple(
        Intent(
            number=number,
            key=f"twin{number}",
            triggers={"en": ("good [old] evening",)},
            plan_sentences={},
        )
        for number in range(1, 9)
    )
    match = compile_catalogue(Library(intents=twins)).match("good evening", "en")
    assert match is not None
    assert match.intent.key == "twin1"
