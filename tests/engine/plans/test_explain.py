"""The explanation of a sentence, and a second way of matching beside the triggers."""

from dataclasses import replace
from types import MappingProxyType

import msgspec

from plans.engine.catalogue import Catalogue, compile_catalogue
from plans.engine.explain import Near, Parameter, explain
from plans.engine.intents import Intent
from plans.engine.matchers.matcher import Candidate, Matcher, Way
from tests.engine.plans.worlds import LIBRARY, PLAYSONG, robot

ROBOT = robot()


def near(sentence: str, intent: str, language: str = "en") -> tuple[str, ...]:
    found = explain(ROBOT, sentence, language).near
    return next((each.faults for each in found if each.intent == intent), ())


def test_the_winner_is_told_with_the_words_of_its_parameters() -> None:
    told = explain(ROBOT, "Talk more loudly 3 times", "en")
    assert told.winner is not None
    assert (told.winner.intent, told.winner.way) == ("volume", "words")
    assert told.winner.parameters == (
        Parameter("level", "louder", "more loudly"),
        Parameter("times", "3", "3"),
    )
    assert told.words == ("talk", "more", "loudly", "3", "times")


def test_the_words_are_those_the_triggers_know() -> None:
    assert "perché" in explain(ROBOT, "la musica è perche vivo", "it").words


def test_the_losers_are_told_with_the_reason() -> None:
    rival = msgspec.structs.replace(PLAYSONG, number=9, key="rival", priority=90)
    both = compile_catalogue(msgspec.structs.replace(LIBRARY, intents=(PLAYSONG, rival)))
    told = explain(both, "play some music", "en")
    assert told.winner is not None
    assert told.winner.intent == "rival"
    reasons = {(each.intent, each.trigger): each.why for each in told.losers}
    assert reasons["playsong", "play some music"] == "has a lower priority"
    own = reasons["rival", "(play|put on) [the song] {title}"]
    assert own == "has fewer words of its own in the sentence"


def test_a_missing_word_is_named() -> None:
    assert "the word 'charge' is missing" in near("go and", "charge")


def test_an_empty_slot_is_named() -> None:
    assert "{level} is empty" in near("talk", "volume")


def test_a_word_in_the_way_is_named() -> None:
    assert near("go and charge yesterday", "charge") == ("'yesterday' stands in the way",)


def test_words_that_cannot_fill_a_slot_are_named() -> None:
    assert near("I love it", "likes") == ("'it' cannot be a {topic}",)


def test_at_most_five_are_near_and_none_of_them_fitted() -> None:
    told = explain(ROBOT, "play some music", "en")
    assert told.winner is not None
    fitted = {told.winner.trigger, *(each.trigger for each in told.losers)}
    assert len(told.near) <= 5
    assert not fitted & {each.trigger for each in told.near}


def test_a_clause_explains_the_clause() -> None:
    told = explain(ROBOT, "oh dear me, help me", "en")
    assert told.winner is not None
    assert (told.winner.intent, told.winner.way, told.losers) == ("alarm", "clause", ())


def test_talk_and_unknown_languages_have_no_winner() -> None:
    assert explain(ROBOT, "", "en").winner is None
    assert explain(ROBOT, "play Volare", "xx") == explain(ROBOT, "", "xx")


class Table:
    """A toy: whole sentences, looked up; it knows one way only and explains nothing."""

    def __init__(self, rows: dict[str, Intent]) -> None:
        self.rows = rows

    def find(self, sentence: str, way: Way = Way.WORDS) -> tuple[Candidate, ...]:
        intent = self.rows.get(sentence) if way == Way.WORDS else None
        return (Candidate(intent, sentence, {}, (9, 0, 0, 0, 0), {}),) if intent else ()

    def forget(self) -> None:
        """Nothing is kept."""

    def prepare(self) -> None:
        """There is nothing to build."""


def with_table() -> Catalogue:
    table: Matcher = Table({"abracadabra": LIBRARY.intents[4], "play some music": PLAYSONG})
    more = {code: (*matchers, table) for code, matchers in ROBOT.matchers.items()}
    return replace(ROBOT, matchers=MappingProxyType(more))


def test_a_second_way_of_matching_is_asked_where_the_first_finds_nothing() -> None:
    both = with_table()
    found = both.match("abracadabra", "en")
    assert found is not None
    assert (found.intent.key, found.way) == ("alarm", "words")
    assert both.match("abracadabr", "en") is None
    first = both.match("play some music", "en")
    assert first is not None
    assert first.score[1] == 3


def test_a_matcher_that_explains_nothing_is_explained_all_the_same() -> None:
    told = explain(with_table(), "abracadabra", "en")
    assert told.winner is not None
    assert told.winner.intent == "alarm"
    assert told.words == ("abracadabra",)
    assert all(isinstance(each, Near) for each in told.near)
