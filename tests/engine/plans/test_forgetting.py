"""Nothing that a person said stays in the matcher."""

import gc

from plans.engine.catalogue import compile_catalogue
from plans.engine.explain import explain
from plans.engine.matchers.patterns_hearing import Hearing
from tests.engine.plans.worlds import LIBRARY

SAID = ("play Volare to my Aunt Hilda", "Aunt Hilda's name was George", "go quickly and charge")


def test_nothing_that_was_said_is_kept_after_the_turn() -> None:
    robot = compile_catalogue(LIBRARY)
    for sentence in SAID:
        if robot.match(sentence, "en") is None:
            robot.suggest(sentence, "en")
    explain(robot, SAID[0], "en")
    heard = [one.reading.sentence for one in gc.get_objects() if isinstance(one, Hearing)]
    assert [sentence for sentence in heard if sentence in SAID] == []
