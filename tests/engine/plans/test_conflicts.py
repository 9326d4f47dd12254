"""Intents that take each other's sentences are found."""

import pytest

from languages.known import LANGUAGES
from plans.engine.accepted import Accepted
from plans.engine.conflicts import conflicts
from plans.engine.intents import SLOT_KINDS, Intent, Library, Phrase, Slot
from plans.engine.library_lint import lint
from plans.engine.remarks import CODES, Remark
from tests.engine.plans.lint_worlds import PLAY, compiled, intent, stored, world


def found(*intents: Intent, only: tuple[str, ...] = ()) -> list[Remark]:
    library = world(*intents)
    return conflicts(library, compiled(library), intents=only, languages=("en",))


def codes(remarks: list[Remark]) -> list[tuple[str, str, str]]:
    return [(remark.code, remark.where, remark.other) for remark in remarks]


def test_intents_that_leave_each_other_alone_have_no_conflict() -> None:
    assert found(PLAY, intent("stop", "stop [it]", "be quiet")) == []


def test_a_trigger_whose_sentences_all_go_elsewhere_never_wins() -> None:
    safe = intent("safe", "play {title}", priority=100)
    loser = intent("loser", "play [me] a song", "stop")
    (remark,) = [each for each in found(loser, safe) if each.code == "C002"]
    assert (remark.where, remark.other, remark.error) == ("loser", "safe", True)
    assert "goes to safe by 'play {title}', which wins by priority" in remark.text


def test_a_trigger_that_loses_some_sentences_is_a_warning() -> None:
    safe = intent("safe", "(help|come) quickly", priority=100)
    loser = intent("loser", "(come|run|walk) {title}", tests=stored("run quickly -> title=quickly"))
    (remark,) = found(loser, safe)
    assert codes([remark]) == [("C001", "loser", "safe")]
    assert "'come quickly' goes to safe" in remark.text
    assert not remark.error


def test_more_literal_words_are_named_as_the_reason() -> None:
    exact = intent("exact", "play (some|more) music")
    loose = intent("loose", "play {title}", tests=stored("play some music -> title=some music"))
    (remark,) = found(loose, exact)
    assert "which wins by literal words" in remark.text


def test_a_draw_that_only_the_order_decides_is_an_error() -> None:
    first = intent("first", "(open|close) {title}")
    second = intent("second", "(close|lift) {title}")
    remarks = found(first, second)
    assert ("C005", "first", "second") in codes(remarks)
    assert all(remark.error for remark in remarks)


def test_a_draw_in_a_trigger_with_many_wordings_is_found_by_trying() -> None:
    many = " ".join(f"[w{number}]" for number in range(10))
    first = intent("first", f"(open|close) {{title}} {many}")
    second = intent("second", f"(close|lift) {{title}} {many}")
    assert ("C003", "second", "first") in codes(found(first, second))


@pytest.mark.parametrize(("priority", "error"), [(50, True), (60, False)])
def test_a_shared_wording_is_an_error_at_the_same_priority(priority: int, error: bool) -> None:
    one, two = intent("one", "(stop|end) it"), intent("two", "[please] end it", priority=priority)
    (remark,) = [each for each in found(one, two) if each.code == "C005"]
    assert (remark.where, remark.other, remark.error) == ("one", "two", error)
    assert "'end it' is a wording of '(stop|end) it' and of '[please] end it' of two" in remark.text


def test_a_shared_wording_is_not_told_again_as_a_lost_sentence() -> None:
    one, two = intent("one", "(stop|end) it"), intent("two", "end it", priority=60)
    assert [remark.code for remark in found(one, two)] == ["C005"]


def test_slots_of_different_names_make_the_same_wording() -> None:
    other = intent("other", "play {song}", slots=(Slot(name="song"),))
    assert ("C005", "play", "other") in codes(found(PLAY, other))


def test_a_slot_that_refuses_its_words_is_told() -> None:
    slots = (Slot(name="topic", kind="topic"),)
    lines = stored("I like tea -> topic=tea", "I like it -> topic=it")
    likes = intent("likes", "I like {topic}", slots=slots, tests=lines)
    phrase = Phrase(key="not_a_topic", texts={"en": "it"})
    library = Library(intents=(likes,), phrases=(phrase,))
    (remark,) = conflicts(library, compiled(library), languages=("en",))
    assert remark.code == "C004"
    assert "'I like it' (is topic=it refused, or cut off as skip words?)" in remark.text


def test_only_the_intents_that_are_wanted_are_tried() -> None:
    safe = intent("safe", "play {title}", priority=100)
    loser = intent("loser", "play [me] a song")
    assert found(loser, safe, PLAY, only=("safe",)) != []
    assert {each.where for each in found(loser, safe, only=("loser",))} == {"loser"}


def test_the_same_library_gives_the_same_remarks() -> None:
    safe = intent("safe", "(help|come) quickly", priority=100)
    loser = intent("loser", "(come|run|walk) (quickly|slowly|now|then)")
    assert found(loser, safe) == found(loser, safe)


def test_an_accepted_conflict_is_not_told() -> None:
    one, two = intent("one", "(stop|end) it"), intent("two", "end it", priority=60)
    library = world(one, two)
    accepted = Accepted("C005", "one", "two", "two ends the talk, one the song")
    remarks = lint(library, compiled(library), accepted=(accepted,))
    assert "C005" not in {remark.code for remark in remarks}
    assert "C005" in {remark.code for remark in lint(library, compiled(library), accepted=())}


def test_an_acceptance_of_nothing_is_told() -> None:
    library = world(PLAY)
    accepted = Accepted("C001", "play", "gone", "It was so once.", language="en")
    idle = [
        each
        for each in lint(library, compiled(library), accepted=(accepted,))
        if each.code == "C015"
    ]
    assert [(each.where, each.error) for each in idle] == [("play", False)]


def test_an_acceptance_holds_for_its_language_and_trigger_only() -> None:
    remark = Remark("C001", "a", "en", "…", other="b", near="x")
    assert Accepted("C001", "a", "b", "why").covers(remark)
    assert not Accepted("C001", "a", "b", "why", language="it").covers(remark)
    assert not Accepted("C001", "a", "b", "why", near="y").covers(remark)
    assert not Accepted("C001", "a", "", "why").covers(remark)


def test_errors_come_first_and_every_code_is_explained() -> None:
    library = world(PLAY, intent("one", "stop"), intent("two", "stop"))
    remarks = lint(library, compiled(library))
    errors = [remark.error for remark in remarks]
    assert errors == sorted(errors, reverse=True)
    assert {remark.code for remark in remarks} <= set(CODES)


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("kind", [kind for kind in SLOT_KINDS if kind not in ("text", "topic")])
def test_slots_of_every_kind_are_filled_with_words_they_take(kind: str, language: str) -> None:
    slots = (Slot(name="said", kind=kind),)
    triggers = {language: ("xyz {said}",)}
    asks = Intent(number=1, key="a", slots=slots, triggers=triggers, plan_sentences={})
    library = Library(intents=(asks,))
    assert conflicts(library, compiled(library), languages=(language,)) == []
