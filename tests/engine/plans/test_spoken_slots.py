"""Slots of spoken kinds in triggers, and their values in bare answers."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from languages.spoken.known import SPOKEN
from plans.engine.bare_answer import bare_value
from plans.engine.catalogue import LibraryError, compile_catalogue
from plans.engine.intents import SLOT_KINDS, Intent, Library, Phrase, Slot
from tests.engine.growth import grows_like_a_line
from tests.engine.plans.worlds import LEVELS, PHRASES

LENGTH, WHEN, DAY = (
    Slot(name="length", kind="duration"),
    Slot(name="when", kind="time"),
    Slot(name="day", kind="date"),
)
WHAT, OTHER, COUNT = Slot(name="what"), Slot(name="other"), Slot(name="count", kind="number")
SURE, LEVEL = Slot(name="sure", kind="yes_no"), Slot(name="level", kind="value:volume_level")
TOPIC = Slot(name="topic", kind="topic")
SLOTS = (LENGTH, WHEN, DAY, WHAT, OTHER, COUNT, SURE, LEVEL, TOPIC)


def intent(number: int, key: str, **triggers: tuple[str, ...]) -> Intent:
    return Intent(number=number, key=key, slots=SLOTS, triggers=triggers, plan_sentences={})


TIMER = intent(
    1,
    "timer",
    en=("set a timer (for|of) {length}", "set a {length} timer"),
    it=("(metti|imposta) un timer di {length}",),
    ja=("{length} の タイマー を [かけて|セットして]",),
)
WAKE = intent(
    2,
    "wake",
    en=("wake me up [at] {when}", "wake me up {day} {when}", "wake me up {when} {day}"),
    it=("svegliami [alle] {when}", "svegliami {day} {when}"),
    ja=("{when} に 起こして", "{day} [の] {when} に 起こして"),
)
REMIND = intent(
    3,
    "remind",
    en=("remind me to {what} in {length}", "remind me in {length} to {what}"),
    it=("(fra|tra) {length} ricordami di {what}", "ricordami di {what} (fra|tra) {length}"),
    ja=("{length} 後 に {what} を 教えて",),
)
VOLUME = intent(
    4,
    "volume",
    en=("set the volume to {count}",),
    it=("volume {count}",),
    ja=("音量 を {count} に",),
)
SAYS = intent(5, "says", en=("my answer is {sure}",), it=("la mia risposta è {sure}",))
WALK = intent(6, "walk", en=("walk {count} steps to {other}",))
CATALOGUE = compile_catalogue(
    Library(
        intents=(TIMER, WAKE, REMIND, VOLUME, SAYS, WALK),
        values=(LEVELS,),
        phrases=(*PHRASES, Phrase(key="x", texts={"en": "x"})),
    )
)


def heard(sentence: str, language: str) -> tuple[str, dict[str, str]] | None:
    match = CATALOGUE.match(sentence, language)
    return (match.intent.key, match.parameters) if match else None


@pytest.mark.parametrize(
    ("language", "sentence", "key", "parameters"),
    [
        ("en", "Set a timer for twenty minutes, please", "timer", {"length": "1200"}),
        ("en", "set a timer of an hour and a half", "timer", {"length": "5400"}),
        ("en", "set a twenty-five minute timer", "timer", {"length": "1500"}),
        ("en", "Wake me up at half past seven", "wake", {"when": "0730"}),
        ("en", "wake me up at 7.30 pm", "wake", {"when": "1930"}),
        ("en", "wake me up seven", "wake", {"when": "0700"}),
        ("en", "wake me up tomorrow at seven", "wake", {"day": "tomorrow", "when": "0700"}),
        ("en", "wake me up tomorrow evening at 7", "wake", {"day": "tomorrow", "when": "1900"}),
        ("en", "wake me up at seven tomorrow", "wake", {"day": "tomorrow", "when": "0700"}),
        (
            "en",
            "wake me up on December 25 at a quarter to eight",
            "wake",
            {"day": "1225", "when": "0745"},
        ),
        (
            "en",
            "wake me up at 8 in the morning on the 25th of December",
            "wake",
            {"day": "1225", "when": "0800"},
        ),
        (
            "en",
            "remind me to put the cake in the oven in half an hour",
            "remind",
            {"what": "put the cake in the oven", "length": "1800"},
        ),
        (
            "en",
            "remind me in two hours and ten minutes to call my 2 sisters in Rome",
            "remind",
            {"length": "7800", "what": "call my 2 sisters in Rome"},
        ),
        ("en", "set the volume to a hundred and five", "volume", {"count": "105"}),
        ("en", "my answer is of course", "says", {"sure": "yes"}),
        ("en", "my answer is not really", "says", {"sure": "no"}),
        ("en", "walk twenty one steps to Anna", "walk", {"count": "21", "other": "Anna"}),
        ("it", "Imposta un timer di venti minuti", "timer", {"length": "1200"}),
        ("it", "metti un timer di centoventi minuti", "timer", {"length": "7200"}),
        ("it", "svegliami alle sette e mezza", "wake", {"when": "0730"}),
        ("it", "svegliami all'una", "wake", {"when": "0100"}),
        ("it", "svegliami domani alle 7", "wake", {"day": "tomorrow", "when": "0700"}),
        ("it", "svegliami il 25 dicembre alle 7", "wake", {"day": "1225", "when": "0700"}),
        ("it", "svegliami domani sera alle 8", "wake", {"day": "tomorrow", "when": "2000"}),
        ("it", "svegliami lunedi alle sette", "wake", {"day": "monday", "when": "0700"}),
        (
            "it",
            "Fra mezz'ora ricordami di spegnere il forno",
            "remind",
            {"length": "1800", "what": "spegnere il forno"},
        ),
        (
            "it",
            "ricordami di chiamare Anna fra duecentoquaranta minuti",
            "remind",
            {"length": "14400", "what": "chiamare Anna"},
        ),
        ("it", "volume quarantadue", "volume", {"count": "42"}),
        ("it", "volume trecentoquarantadue", "volume", {"count": "342"}),
        ("ja", "二十分のタイマーをセットして", "timer", {"length": "1200"}),
        ("ja", "７時半に起こして", "wake", {"when": "0730"}),
        ("ja", "明日の朝7時に起こして", "wake", {"day": "tomorrow", "when": "0700"}),
        ("ja", "12月25日午後3時に起こして", "wake", {"day": "1225", "when": "1500"}),
        ("ja", "1時間半後に薬を教えて", "remind", {"length": "5400", "what": "薬"}),
        ("ja", "音量をにじゅうに", "volume", {"count": "20"}),
    ],
)
def test_a_spoken_slot_is_captured_whole(
    language: str, sentence: str, key: str, parameters: dict[str, str]
) -> None:
    assert heard(sentence, language) == (key, parameters)


@pytest.mark.parametrize(
    ("language", "sentence"),
    [
        ("en", "set a timer for a lot of minutes"),
        ("en", "set a timer for twenty"),
        ("en", "set a timer for seven cats"),
        ("en", "set a timer for twenty minutes two hours"),
        ("en", "set the volume to seven cats"),
        ("en", "set the volume to " + "twenty " * 20),
        ("en", "my answer is the blue one in the garden"),
        ("it", "metti un timer di molti minuti"),
        ("it", "volume altissimo"),
        ("ja", "猫のタイマーをかけて"),
    ],
)
def test_words_without_a_meaning_do_not_fit(language: str, sentence: str) -> None:
    assert heard(sentence, language) is None


@pytest.mark.parametrize("kind", ["number", "duration", "time", "date"])
@pytest.mark.parametrize("language", ["en", "it", "ja"])
def test_every_example_fits_a_trigger(kind: str, language: str) -> None:
    slot = Slot(name="x", kind=kind)
    one = Intent(
        number=1, key="a", slots=(slot,), triggers={language: ("zzz {x}",)}, plan_sentences={}
    )
    catalogue = compile_catalogue(Library(intents=(one,)))
    for phrase in SPOKEN[language].examples[kind]:
        assert catalogue.match(f"zzz {phrase}", language) is not None, phrase


def test_a_spoken_slot_ranks_above_free_text() -> None:
    free = intent(7, "free", en=("set a timer for {what}",))
    both = compile_catalogue(Library(intents=(free, TIMER), values=(LEVELS,)))
    match = both.match("set a timer for twenty minutes", "en")
    assert match is not None
    assert (match.intent.key, match.runner_up) == ("timer", "free")


@pytest.mark.parametrize(
    "trigger", ["say {what} {sure}", "say {sure} {what}", "say {sure} {topic}"]
)
def test_two_slots_that_do_not_tell_their_ends_cannot_meet(trigger: str) -> None:
    bad = intent(1, "a", en=(trigger,))
    with pytest.raises(LibraryError, match="without a word between"):
        compile_catalogue(Library(intents=(bad,), values=(LEVELS,)))


def test_a_spoken_slot_may_stand_beside_free_text() -> None:
    good = intent(1, "a", en=("remind me to {what} {when}",), it=("ricordami di {what} {length}",))
    catalogue = compile_catalogue(Library(intents=(good,), values=(LEVELS,)))
    match = catalogue.match("remind me to call the seven dwarfs at seven", "en")
    assert match is not None
    assert match.parameters == {"what": "call the seven dwarfs", "when": "0700"}
    match = catalogue.match("ricordami di chiamare Anna centoventi minuti", "it")
    assert match is not None
    assert match.parameters == {"what": "chiamare Anna", "length": "7200"}


def test_a_long_sentence_of_numbers_takes_linear_time() -> None:
    slots = (COUNT, LENGTH, WHEN, DAY)
    hostile = Intent(
        number=1,
        key="a",
        slots=slots,
        triggers={"en": ("go {count} [and] {length} [and] {when} [and] {day} now",)},
        plan_sentences={},
    )
    catalogue = compile_catalogue(Library(intents=(hostile,)))
    catalogue.match("go " + "seven and " * 28 + "now", "en")
    assert grows_like_a_line(
        lambda size: catalogue.match("go " + "seven and " * size + "now", "en"), 7
    )


@pytest.mark.parametrize(
    ("language", "slot", "answer", "value"),
    [
        ("en", LENGTH, "twenty minutes", "1200"),
        ("en", LENGTH, "In twenty minutes, please", "1200"),
        ("en", LENGTH, "let's say an hour and a half or so", "5400"),
        ("en", LENGTH, "I don't know", None),
        ("en", LENGTH, "two hours or three hours", None),
        ("en", WHEN, "at half past seven, thank you", "0730"),
        ("en", WHEN, "I get up at 8 in the morning usually", "0800"),
        ("en", DAY, "on Monday", "monday"),
        ("en", DAY, "the day after tomorrow I think", "in_2_days"),
        ("en", COUNT, "I have two cats", "2"),
        ("en", COUNT, "a lot", None),
        ("en", LEVEL, "louder please", "louder"),
        ("en", LEVEL, "a bit more loudly, up", "louder"),
        ("en", LEVEL, "louder or quieter", None),
        ("en", LEVEL, "hello", None),
        ("en", SURE, "oh yes, very much", "yes"),
        ("en", SURE, "no thanks", "no"),
        ("en", SURE, "maybe", None),
        ("en", WHAT, "the song Hey Jude", "the song Hey Jude"),
        ("en", WHAT, "It's Hey Jude, please", "Hey Jude"),
        ("en", WHAT, "please please please", "please please please"),
        ("en", WHAT, "thank you", None),
        ("en", WHAT, "", None),
        ("en", TOPIC, "the music", "music"),
        ("en", TOPIC, "it", None),
        ("it", LENGTH, "fra venti minuti, per favore", "1200"),
        ("it", LENGTH, "mezz'ora", "1800"),
        ("it", LENGTH, "centoventi minuti", "7200"),
        ("it", WHEN, "facciamo alle sette di sera", "1900"),
        ("it", DAY, "direi lunedi", "monday"),
        ("it", LEVEL, "un po' più forte", "louder"),
        ("it", SURE, "sì, certo", "yes"),
        ("it", WHAT, "È Volare", "Volare"),
        ("ja", LENGTH, "二十分でお願いします", "1200"),
        ("ja", LENGTH, "1時間半くらい", "5400"),
        ("ja", WHEN, "朝の七時がいいです", "0700"),
        ("ja", DAY, "あしたです", "tomorrow"),
        ("ja", COUNT, "20でお願いします", "20"),
        ("ja", COUNT, "にじゅうです", "20"),
        ("ja", COUNT, "わかりました", None),
        ("ja", LEVEL, "もっと大きく", "louder"),
        ("ja", SURE, "はい", "yes"),
        ("ja", WHAT, "ふるさとです", "ふるさと"),
    ],
)
def test_a_bare_answer_fills_a_slot(
    language: str, slot: Slot, answer: str, value: str | None
) -> None:
    assert bare_value(CATALOGUE, slot, answer, language) == value


def test_an_unknown_language_fills_nothing() -> None:
    assert bare_value(CATALOGUE, LENGTH, "twenty minutes", "xx") is None


@given(
    st.text(max_size=60), st.sampled_from(SLOTS), st.sampled_from(["en", "it", "ja"]), st.integers()
)
@settings(max_examples=300, deadline=None)
def test_any_answer_can_be_heard(sentence: str, slot: Slot, language: str, number: int) -> None:
    assert slot.kind in SLOT_KINDS or slot.list_key
    bare_value(CATALOGUE, slot, sentence, language)
    bare_value(CATALOGUE, slot, f"{sentence} {number} minutes", language)


def test_an_answer_of_numbers_only_is_read_in_linear_time() -> None:
    assert grows_like_a_line(lambda size: bare_value(CATALOGUE, LENGTH, "seven " * size, "en"), 7)
