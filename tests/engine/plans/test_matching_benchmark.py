"""The noise of the benchmark of matching, and its verdicts."""

from random import Random

import pytest

from benchmarks.matching.measure import percent, spread
from benchmarks.matching.noise import (
    as_recognised,
    with_filler,
    with_typo,
    without_a_space,
    without_accents,
)
from benchmarks.matching.targets import Target


@pytest.mark.parametrize("seed", range(40))
def test_a_typo_changes_one_word_and_never_a_value(seed: int) -> None:
    sentence = "Please play Yesterday loudly"
    typed = with_typo(sentence, Random(seed), "en", kept=("yesterday",))
    assert typed is not None
    assert typed != sentence
    words = zip(typed.split(), sentence.split(), strict=True)
    assert sum(one != two for one, two in words) == 1
    assert "Yesterday" in typed


def test_short_words_are_not_mistyped() -> None:
    assert with_typo("I do so", Random(1), "en") is None
    assert with_typo("歌って", Random(1), "ja") is None


def test_a_typo_in_japanese_is_one_character() -> None:
    for seed in range(20):
        typed = with_typo("明かりを消してください", Random(seed), "ja", kept=("明かり",))
        assert typed is not None
        assert typed.startswith("明かり")
        assert len(typed) in (10, 11)
        assert typed != "明かりを消してください"


def test_the_same_seed_makes_the_same_noise() -> None:
    made = [with_typo("turn everything around", Random(7), "en") for _ in range(2)]
    assert made[0] == made[1]


def test_fillers_stand_at_the_edges() -> None:
    found = {with_filler("Stop!", Random(seed), ("um",), ("honey",), " ") for seed in range(40)}
    assert found == {"um Stop!", "Stop honey"}
    assert with_filler("Stop", Random(1), (), (), " ") is None


def test_accents_are_lost_only_where_there_are_some() -> None:
    assert without_accents("Perché è così?", "it") == "Perche e cosi?"
    assert without_accents("Vai", "it") is None
    assert without_accents("がんばって", "ja") is None


def test_a_space_is_lost_between_two_words_that_are_not_values() -> None:
    found = {without_a_space("go to bed now", Random(n), "en", kept=("bed",)) for n in range(20)}
    assert found == {"goto bed now"}
    assert without_a_space("go", Random(1), "en") is None


def test_a_recogniser_writes_small_letters_and_no_punctuation() -> None:
    assert as_recognised("What's up, Pepper?") == "what's up pepper"
    assert as_recognised("明かりを消して。") == "明かりを消して"
    assert as_recognised("A half-hour timer at 19:30.") == "a half hour timer at 19:30"
    assert as_recognised("stop") is None


def test_a_spread_is_over_sentences() -> None:
    heard: list[str] = []
    times = spread(heard.append, ["a", "b"], rounds=3)
    assert heard == ["a", "b"] * 3
    assert 0 <= times.p50 <= times.p95


def test_a_target_is_met_on_its_side() -> None:
    assert Target("right", 99.5, "%", at_least=True).met(99.5)
    assert not Target("right", 99.5, "%", at_least=True).met(99.4)
    assert Target("time", 30, "µs").met(29)
    assert not Target("time", 30, "µs").met(31)
    assert percent(1, 0) == "–"
