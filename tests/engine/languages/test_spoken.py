"""Numbers, lengths, clock times and days are read as people say them."""

from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from languages.known import LANGUAGES
from languages.language import Attitude
from languages.spoken.known import SPOKEN
from languages.spoken.shape import yes_or_no
from tests.engine.languages import spellers

KINDS = ("number", "duration", "time", "date")


def units(phrase: str, language: str) -> tuple[str, ...]:
    return tuple(token.text for token in LANGUAGES[language].tokens(phrase))


def meaning(phrase: str, language: str, kind: str) -> str | None:
    return SPOKEN[language].kinds[kind].parse(units(phrase, language))


def rows() -> list[tuple[str, str, str, str | None]]:
    found: list[tuple[str, str, str, str | None]] = []
    for line in Path(__file__).with_name("spoken.txt").read_text("utf-8").splitlines():
        if not line.startswith("#"):
            head, rest = line.split(": ", 1)
            phrase, value = rest.rsplit(" = ", 1)
            language, kind = head.split()
            found.append((language, kind, phrase, None if value == "-" else value))
    return found


@pytest.mark.parametrize(("language", "kind", "phrase", "value"), rows())
def test_a_phrase_means_what_the_table_says(
    language: str, kind: str, phrase: str, value: str | None
) -> None:
    assert meaning(phrase, language, kind) == value


@pytest.mark.parametrize(("language", "kind", "phrase", "value"), rows())
def test_the_words_of_a_kind_are_listed(
    language: str, kind: str, phrase: str, value: str | None
) -> None:
    read = SPOKEN[language].kinds[kind]
    if value is not None:
        assert all(map(read.may_read, units(phrase, language)))
        assert len(units(phrase, language)) <= SPOKEN[language].most_units


@pytest.mark.parametrize(
    ("language", "spell"),
    [("en", spellers.english), ("it", spellers.italian), ("ja", spellers.japanese)],
)
def test_every_number_below_ten_thousand_is_read(
    language: str, spell: Callable[[int], str]
) -> None:
    wrong = [
        (number, spell(number))
        for number in range(10_000)
        if meaning(spell(number), language, "number") != str(number)
    ]
    assert wrong == []


def test_every_minute_of_the_day_is_read() -> None:
    for hour in range(24):
        for minute in range(60):
            said = {"en": f"{hour}:{minute:02}", "it": f"le {hour}:{minute:02}"}
            said["ja"] = f"{hour}時{minute}分"
            for language, phrase in said.items():
                assert meaning(phrase, language, "time") == f"{hour:02}{minute:02}"


@pytest.mark.parametrize("language", SPOKEN)
def test_every_example_is_read(language: str) -> None:
    for kind, phrases in SPOKEN[language].examples.items():
        for phrase in phrases:
            if kind == "yes_no":
                assert yes_or_no(LANGUAGES[language].attitude(phrase)) in ("yes", "no")
            else:
                assert meaning(phrase, language, kind) is not None, phrase


def test_only_what_leans_to_one_side_is_yes_or_no() -> None:
    sides = {attitude: yes_or_no(attitude) for attitude in Attitude}
    assert sides[Attitude.A_LITTLE] == "yes"
    assert sides[Attitude.NOT_REALLY] == "no"
    assert sides[Attitude.DEPENDS] is None
    assert sides[Attitude.UNCLEAR] is None


def test_every_language_knows_every_kind() -> None:
    assert SPOKEN.keys() == LANGUAGES.keys()
    assert all(tuple(spoken.kinds) == KINDS for spoken in SPOKEN.values())


@given(st.data(), st.sampled_from(tuple(SPOKEN)), st.sampled_from(KINDS))
@settings(max_examples=1_500, deadline=None)
def test_any_words_have_one_word_of_meaning_or_none(
    data: st.DataObject, language: str, kind: str
) -> None:
    read = SPOKEN[language].kinds[kind]
    known = st.sampled_from(sorted(read.words | read.openers))
    word = st.one_of(known, st.integers(0, 10**20).map(str), st.text("a#é時1(", min_size=1))
    said = data.draw(st.lists(word, min_size=1, max_size=SPOKEN[language].most_units))
    value = read.parse(tuple(said))
    assert value is None or (value.isascii() and value.replace("_", "").isalnum())


@pytest.mark.parametrize("language", SPOKEN)
@pytest.mark.parametrize("unit", ["#", "1 2", "1" * 5_000, "cento" * 1_000, "二" * 5_000, "٣", "²"])
def test_endless_and_strange_numbers_are_refused_or_read(language: str, unit: str) -> None:
    for kind in KINDS:
        assert len(SPOKEN[language].kinds[kind].parse((unit,) * 3) or "") < 20
        assert len(SPOKEN[language].kinds[kind].parse((unit,)) or "") < 20
