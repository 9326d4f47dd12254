"""numbers.tsv: which number is whose, and up to where numbers are taken."""

import pytest

from ontology_io.files.nodes import Problems
from ontology_io.files.numbers import Ledger, read_ledger, write_ledger


def read(text: str) -> tuple[Ledger, list[str]]:
    problems = Problems("numbers.tsv")
    return read_ledger(text, problems), list(map(str, problems.found))


NUMBERS = """\
last\ttopic\t9
last\tframe\t5
last\tintent\t0
topic\tTea\t2
topic\tMilk\t7
frame\tTea.q1\t3\t12
frame\tTea.c1\t5
"""


def test_a_ledger_is_written_as_it_was_read() -> None:
    ledger, problems = read(NUMBERS)
    assert problems == []
    rows = {
        kind: [(key, number, ledger.slots.get(key, -1)) for key, number in numbers.items()]
        for kind, numbers in ledger.numbers.items()
    }
    assert write_ledger(rows, ledger.last) == NUMBERS


def test_the_last_number_is_at_least_the_highest_one() -> None:
    ledger, _ = read("last\ttopic\t2\ntopic\tTea\t40\nlast\ttopic\t3\n")
    assert ledger.last == {"topic": 40, "frame": 0, "intent": 0}


@pytest.mark.parametrize(
    "row",
    [
        "topic Tea 2",
        "topic\tTea",
        "topic\tTea\t0",
        "topic\tTea\t-2",
        "topic\tTea\t٣",
        "topic\tTea\t131072",
        "topic\tTea\t2\t3",
        "frame\tTea.q1\t2\t128",
        "frame\tTea.q1\t2\t",
        "intent\tplay\t99999999999",
        "flower\tRose\t2",
        "last\tflower\t2",
        "last\ttopic\t2\t3",
        "",
        "topic\tTea\t" + "9" * 5000,
    ],
)
def test_a_row_that_cannot_be_read_is_a_problem(row: str) -> None:
    _, problems = read(f"last\ttopic\t1\n{row}\n")
    assert len(problems) == 1
    assert problems[0].startswith("numbers.tsv:2: ")
    assert problems[0].endswith(" must be kind, key and number, apart by tabs.")


@pytest.mark.parametrize(
    ("rows", "expected"),
    [
        ("topic\tTea\t2\ntopic\tMilk\t2\n", "numbers.tsv:2: The topic 2 stands here twice."),
        ("topic\tTea\t2\ntopic\tTea\t3\n", "numbers.tsv:2: The topic Tea stands here twice."),
        ("last\ttopic\t2\nlast\ttopic\t3\n", "numbers.tsv:2: The last topic stands here twice."),
    ],
)
def test_a_number_or_a_key_given_twice_is_a_problem(rows: str, expected: str) -> None:
    assert read(rows)[1] == [expected]


def test_kinds_have_numbers_of_their_own() -> None:
    assert read("topic\tTea\t2\nframe\tTea.q1\t2\nintent\ttea\t2\n")[1] == []
