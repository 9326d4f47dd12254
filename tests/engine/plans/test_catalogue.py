"""Matching: whole sentences, skip words, slots, ranking, refusals and linear time."""

from random import Random

import msgspec
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plans.engine.catalogue import LibraryError, compile_catalogue
from plans.engine.intents import Intent, Library, Phrase, Slot
from plans.engine.patterns import parse_pattern, sample
from plans.engine.plan_text import parse_plan
from plans.engine.wordings import wordings
from tests.engine.growth import grows_like_a_line
from tests.engine.plans.worlds import LIBRARY, LIKES, PLAYSONG, VOLUME, robot

ROBOT = robot()


def heard(sentence: str, language: str = "en") -> tuple[str, dict[str, str]] | None:
    match = ROBOT.match(sentence, language)
    return (match.intent.key, match.parameters) if match else None


def test_parameters_keep_the_persons_spelling() -> None:
    assert heard("PLAY the song 'Hey Brother'!") == ("playsong", {"title": "Hey Brother"})


def test_skip_words_are_removed_at_the_edges_only() -> None:
    assert heard("Could you please play Please Please Me, thank you?") == (
        "playsong",
        {"title": "Please Please Me"},
    )


def test_literal_words_win_over_free_text() -> None:
    assert heard("play some music") == ("playsong", {})


def test_a_trigger_must_fit_the_whole_sentence() -> None:
    assert heard("we play some music every day") is None


def test_articles_and_elisions_leave_a_topic() -> None:
    assert heard("I love the music very much") == ("likes", {"topic": "music"})
    assert heard("mi piace molto l'arte", "it") == ("likes", {"topic": "arte"})


@pytest.mark.parametrize(
    "sentence", ["I love it", "I love you", "I love the", "I like tea because it is hot"]
)
def test_pronouns_and_clauses_are_no_topics(sentence: str) -> None:
    assert heard(sentence) is None


def test_a_long_topic_is_left_to_the_dialogue() -> None:
    assert heard("I love my old house near the lake in summer") is None


def test_a_value_comes_back_canonical() -> None:
    assert heard("talk more loudly") == ("volume", {"level": "louder"})
    assert heard("parla piu forte", "it") == ("volume", {"level": "louder"})
    assert heard("音を小さくして", "ja") == ("volume", {"level": "quieter"})


def test_numbers_are_heard_as_digits_and_words() -> None:
    assert heard("speak up 2 times") == ("volume", {"level": "louder", "times": "2"})
    assert heard("volume twenty") == ("volume", {"times": "20"})


def test_lost_accents_are_forgiven_but_short_words_stay_apart() -> None:
    assert heard("la musica è perche vivo", "it") == ("likes", {"topic": "musica"})
    assert heard("mi piace il tè", "it") == ("likes", {"topic": "tè"})


def test_japanese_slots_are_cut_between_characters() -> None:
    assert heard("「ふるさと」をかけてください", "ja") == ("playsong", {"title": "ふるさと"})
    assert heard("それが好きです", "ja") is None


def test_the_match_explains_itself() -> None:
    match = ROBOT.match("play some music", "en")
    assert match is not None
    assert "fits with 3 words of its own" in match.why
    assert match.runner_up == ""


def test_the_higher_priority_wins_and_the_other_is_runner_up() -> None:
    rival = msgspec.structs.replace(PLAYSONG, number=9, key="rival", priority=90)
    both = compile_catalogue(msgspec.structs.replace(LIBRARY, intents=(PLAYSONG, rival)))
    match = both.match("play Volare", "en")
    assert match is not None
    assert (match.intent.key, match.runner_up) == ("rival", "playsong")


def test_an_unknown_language_and_an_empty_sentence_match_nothing() -> None:
    assert heard("play Volare", "xx") is None
    assert heard("") is None
    assert heard("!!!") is None


def test_intents_are_found_by_key_and_number() -> None:
    assert ROBOT.intents["likes"] == ROBOT.by_number[2] == LIKES


@given(st.integers(0, 10_000))
@settings(max_examples=60, deadline=None)
def test_samples_of_a_trigger_match_its_intent(seed: int) -> None:
    chance = Random(seed)
    trigger = chance.choice(PLAYSONG.triggers["en"])
    words = sample(parse_pattern(trigger), chance, {}, lambda _: "Volare")
    found = heard(" ".join(words))
    assert found is not None
    assert found[0] == "playsong"


@given(st.text(max_size=80), st.sampled_from(["en", "it", "ja"]))
@settings(max_examples=200, deadline=None)
def test_any_text_can_be_heard(sentence: str, language: str) -> None:
    heard(sentence, language)
    heard("play " + sentence, language)


@pytest.mark.parametrize(
    "trigger",
    [
        "[a] [a] [a] [a] [a] [a] [a] [a] [a] [a] [a] [a] {x} b {y} c",
        "(a|a a|a a a) (a|a a|a a a) (a|a a|a a a) {x} a (a|a a) {y} a c",
        "{x} a [a|a a|a a a] [a|a a|a a a] [a|a a|a a a] {y} c",
    ],
)
def test_a_hostile_trigger_and_sentence_take_linear_time(trigger: str) -> None:
    slots = (Slot(name="x"), Slot(name="y"))
    intent = Intent(number=1, key="a", slots=slots, triggers={"en": (trigger,)}, plan_sentences={})
    catalogue = compile_catalogue(Library(intents=(intent,)))
    catalogue.match("a " * 58 + "c", "en")
    assert grows_like_a_line(lambda size: catalogue.match("a " * size + "c", "en"), 7)
    assert grows_like_a_line(lambda size: catalogue.match("a b " * size + "d c", "en"), 3)
    assert grows_like_a_line(lambda size: catalogue.match("a " * size + "c", "en"), 1_000)


@pytest.mark.parametrize(
    ("trigger", "message"),
    [
        ("play {x", "without '}'"),
        ("play {other}", "not declared"),
        ("<nothing> {x}", "no phrase 'nothing'"),
        ("[play] {x}", "without any word"),
        ("play {x} {y}", "without a word between"),
        ("play {x} [softly] {y}", "without a word between"),
        ("play {x} by {x}", "twice"),
        ("!!! {x}", "signs only"),
        ("play {x} a {y} b {z}", "More than 2 free slots"),
        ("a " + "(a|b|c|d|e|f|g) " * 5, "wordings, more than"),
    ],
)
def test_a_trigger_that_breaks_a_rule_is_refused(trigger: str, message: str) -> None:
    slots = (Slot(name="x"), Slot(name="y"), Slot(name="z"))
    intent = Intent(number=1, key="a", slots=slots, triggers={"en": (trigger,)}, plan_sentences={})
    with pytest.raises(LibraryError, match="a \\(en\\)") as refused:
        compile_catalogue(Library(intents=(intent,)))
    assert message in str(refused.value)


def test_all_problems_are_listed_with_their_places() -> None:
    bad = msgspec.structs.replace(PLAYSONG, triggers={"en": ("play {title", "x ]"), "it": ("{",)})
    with pytest.raises(LibraryError) as refused:
        compile_catalogue(Library(intents=(bad,)))
    places = [(each.language, each.position) for each in refused.value.problems]
    assert places == [("en", 5), ("en", 2), ("it", 0)]


@pytest.mark.parametrize("text", ["a {x}", "a <b>", "(a", "a ||", "(a|b|c|d|e) " * 6])
def test_a_wrong_phrase_is_a_problem_of_the_library(text: str) -> None:
    with pytest.raises(LibraryError, match="<bad>"):
        compile_catalogue(Library(phrases=(Phrase(key="bad", texts={"en": text}),)))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"slots": (Slot(name="title", kind="colour"),)}, "no known kind"),
        ({"slots": (Slot(name="title", kind="value:none"),)}, "does not exist"),
        ({"slots": (Slot(name="title"), Slot(name="title"))}, "2 times"),
        ({"slots": (), "triggers": {}}, "not declared"),
        ({"triggers": {"xx": ("hello",)}}, "unknown language"),
        ({"plan": parse_plan("#action=fly")}, "no such action"),
        ({"plan": parse_plan("#action=rest where={title}")}, "no such parameter"),
        ({"plan": parse_plan("#action=playsong title={song}")}, "not declared"),
    ],
)
def test_a_wrong_intent_is_refused(change: dict[str, object], message: str) -> None:
    bad = msgspec.structs.replace(PLAYSONG, **change)
    with pytest.raises(LibraryError, match=message):
        compile_catalogue(Library(intents=(bad,)))


def test_a_phrase_counts_for_the_index() -> None:
    phrases = (Phrase(key="play", texts={"en": "play|put on"}),)
    intent = Intent(
        number=1,
        key="a",
        slots=(Slot(name="x"),),
        triggers={"en": ("<play> {x}",)},
        plan_sentences={},
    )
    catalogue = compile_catalogue(Library(intents=(intent,), phrases=phrases))
    assert catalogue.match("put on Volare", "en") is not None


def test_a_phrase_with_a_slot_has_no_list_of_wordings() -> None:
    assert wordings(parse_pattern("hey {name}"), lambda text: (text,)) == frozenset()
    found = wordings(parse_pattern("[my] (dear|good) robot"), lambda text: (text,))
    assert ("my", "dear", "robot") in found
    assert len(found) == 4


@pytest.mark.parametrize("sentence", ["thank you", "please", "please please", "thank you please"])
def test_skip_words_alone_ask_for_nothing(sentence: str) -> None:
    assert heard(sentence) is None


def test_endless_skip_words_are_given_up() -> None:
    assert heard("please " * 20 + "play Volare") is None
    assert heard("play Volare " + "thank you " * 8) is not None


@pytest.mark.parametrize("sentence", ["play Volare, help me", "Play me a song and help me"])
def test_a_cry_for_help_wins_over_the_request_that_swallowed_it(sentence: str) -> None:
    match = robot().match(sentence, "en")
    assert match is not None
    assert (match.intent.key, match.way) == ("alarm", "clause")


def test_a_title_with_a_comma_stays_whole() -> None:
    match = robot().match("play Tom, Dick and Harry", "en")
    assert match is not None
    assert match.parameters == {"title": "Tom, Dick and Harry"}


def test_a_listed_value_alone_is_a_request_where_its_author_says_so() -> None:
    bare = msgspec.structs.replace(VOLUME, triggers={"en": ("{level}",), "ja": ("{level}",)})
    alone = compile_catalogue(msgspec.structs.replace(LIBRARY, intents=(bare,)))
    for sentence, language in (("More loudly, please", "en"), ("大きく", "ja")):
        match = alone.match(sentence, language)
        assert match is not None
        assert match.parameters == {"level": "louder"}


def test_a_prepared_catalogue_builds_nothing_while_it_matches(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    sentences = (("play Yesterday", "en"), ("pplay Yesterday", "en"), ("音楽をかけて", "ja"))
    expected = [(ROBOT.match(*said), ROBOT.suggest(*said)) for said in sentences]
    prepared = robot()
    prepared.prepare()
    monkeypatch.setattr("plans.engine.templates.Automaton", None)
    monkeypatch.setattr("plans.engine.matchers.patterns_near.TriggerIndex", None)
    assert [(prepared.match(*said), prepared.suggest(*said)) for said in sentences] == expected
    assert any(match for match, _ in expected)
