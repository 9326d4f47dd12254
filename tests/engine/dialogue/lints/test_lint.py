"""All lints together: what is accepted, and the table of the bars."""

from dialogue.engine.content import build_content
from dialogue.engine.lints.accepted import ACCEPTED, STALE, Accepted, without_accepted
from dialogue.engine.lints.bars import Bar, bars, markdown
from dialogue.engine.lints.lint import findings_of, lint, lint_content
from dialogue.engine.lints.remarks import Remark, some
from plans.engine.intents import Library
from tests.engine.dialogue.lints.good import (
    corpus,
    found_by_one_word,
    saying,
    with_own_lines,
)

REMARK = Remark("C2", "Tea", "It has 3 different sentences.", "Write more.", "it")


def test_the_good_knowledge_base_has_no_remark_at_all():
    assert list(lint(corpus(with_own_lines()))) == []
    wildcards = lint_content(build_content(found_by_one_word(), Library()), ())
    assert {one.code for one in wildcards} == {"K1", "L1"}


def test_an_accepted_remark_is_left_out_in_its_language_only():
    accepted = Accepted("C2", "Tea", "It is new.", language="it")
    assert without_accepted([REMARK], (accepted,)) == []
    other = REMARK._replace(language="en")
    assert without_accepted([REMARK, other], (accepted,)) == [other]
    everywhere = Accepted("C2", "Tea", "It is new.")
    assert without_accepted([REMARK, other], (everywhere,)) == []


def test_what_is_accepted_for_nothing_is_a_remark_itself():
    stale = Accepted("G4", "Tea.c1", "It is short.")
    kept = without_accepted([REMARK], (stale,))
    assert [(one.code, one.where) for one in kept] == [("C2", "Tea"), (STALE, "Tea.c1")]


def test_everything_accepted_has_its_reason():
    assert all(one.reason.endswith(".") for one in ACCEPTED)


def test_lints_are_advice_with_their_language():
    (finding,) = findings_of([REMARK])
    assert str(finding) == "C2 Tea: It has 3 different sentences (it). Hint: Write more."
    assert not finding.error


def test_many_topics_are_named_by_three():
    assert some(["a"]) == "a"
    assert some(["a", "b", "c", "d", "e"]) == "a, b, c and 2 more"


def bar(rows: list[Bar], id_: str, what: str) -> Bar:
    (row,) = [one for one in rows if one.id == id_ and one.what.startswith(what)]
    return row


def test_the_bars_count_and_compare_with_their_targets():
    rows = bars(build_content(found_by_one_word(), Library()))
    assert (bar(rows, "", "leaves").figure, bar(rows, "", "classes").figure) == ("6", "1")
    assert bar(rows, "", "groups").figure == "1"
    assert bar(rows, "C1", "leaves")[2:] == (">= 3000", "6", False)
    assert bar(rows, "C2", "leaves with 12 sentences, gentle ones 7 (ja)")[3:] == ("6 of 6", True)
    assert bar(rows, "C3", "classes")[3:] == ("2 of 2", True)
    assert bar(rows, "L1", "sentences for EN alone")[3:] == ("0", False)
    assert bar(rows, "K2", "topics found by their own names (it)").met
    assert bar(rows, "P1", "remarks: words a robot avoids (en)").met
    worse = bars(build_content(saying("HotDrink", "c", "I eat $hasName."), Library()))
    assert bar(worse, "P1", "remarks: words a robot avoids (en)")[3:] == ("1", False)


def test_the_bars_are_a_table_in_markdown():
    table = markdown([Bar("", "topics", "", "9"), Bar("K2", "found", ">= 98 %", "97 %", met=False)])
    assert table.splitlines()[2:] == [
        "|  | topics |  | 9 |  |",
        "| K2 | found | >= 98 % | 97 % | **no** |",
    ]
