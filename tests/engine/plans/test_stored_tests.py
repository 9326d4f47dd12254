"""The stored tests are run, and a failure says why."""

from plans.engine.intents import Intent, Library
from plans.engine.stored_tests import TestedSpeech, run_stored_tests
from tests.engine.plans.lint_worlds import PLAY, compiled, intent, stored, world
from tests.engine.plans.shipped import library as shipped


def ran(library: Library) -> list[TestedSpeech]:
    return list(run_stored_tests(library, compiled(library), languages=("en",)))


def reason(tested: Intent, *others: Intent) -> str:
    failures = ran(world(tested, *others))[0].failures
    assert len(failures) == 1
    return failures[0].reason


def test_what_is_written_and_what_passed_is_counted() -> None:
    play = ran(world(PLAY))[0]
    assert (play.triggers, play.plan_sentences) == (2, 1)
    assert (play.positive, play.must_not_match, play.passed) == (2, 1, 3)
    assert play.failures == ()


def test_a_sentence_that_another_intent_takes_is_a_failure() -> None:
    rival = intent("rival", "play {title}", priority=90)
    tested = intent("a", "play {title}", tests=stored("play Volare -> title=Volare"))
    assert reason(tested, rival).startswith("matched rival by 'play {title}' instead (")


def test_a_wrong_parameter_is_told_with_the_right_one() -> None:
    tested = intent("a", "play {title}", tests=stored("play Volare now -> title=Volare"))
    expected = "captured title=Volare now, expected title=Volare (by 'play {title}')"
    assert reason(tested) == expected


def test_a_parameter_too_many_is_a_failure() -> None:
    tested = intent("a", "play {title}", tests=stored("play Volare"))
    assert reason(tested).startswith("captured title=Volare, expected nothing")


def test_where_nothing_matches_the_nearest_trigger_is_named() -> None:
    tested = intent("a", "stop it", "put on a song", tests=stored("put a record on"))
    assert reason(tested) == "nothing matched; nearest is 'put on a song'"


def test_a_sentence_with_no_word_of_a_trigger_has_no_nearest_one() -> None:
    assert reason(intent("a", "stop it", tests=stored("hello"))) == "nothing matched"


def test_a_sentence_that_must_not_match_may_match_another_intent() -> None:
    tested = intent("a", "stop it", tests=stored("play Volare -> no"))
    assert ran(world(tested, PLAY))[0].failures == ()


def test_a_sentence_that_must_not_match_but_does_is_a_failure() -> None:
    tested = intent("a", "stop it", tests=stored("stop it -> no"))
    assert reason(tested) == "matched by 'stop it', must not match"


def test_only_the_intents_and_languages_that_are_wanted_are_run() -> None:
    library = world(PLAY, intent("a", "stop it"))
    found = run_stored_tests(library, compiled(library), intents=("a",), languages=("it", "en"))
    assert [(each.intent.key, each.language) for each in found] == [("a", "en"), ("a", "it")]


def test_japanese_has_nearest_triggers_too() -> None:
    spoken = {"triggers": {"ja": ("音楽をかけて",)}, "tests": {"ja": stored("音楽がいい")["en"]}}
    tested = Intent(number=1, key="a", plan_sentences={}, **spoken)
    library = Library(intents=(tested,))
    found = run_stored_tests(library, compiled(library), languages=("ja",))
    assert found[0].failures[0].reason == "nothing matched; nearest is '音楽をかけて'"


def test_every_test_of_the_shipped_intents_is_run() -> None:
    library = shipped()
    found = run_stored_tests(library, compiled(library))
    written = sum(len(lines) for one in library.intents for lines in one.tests.values())
    assert sum(each.positive + each.must_not_match for each in found) == written
