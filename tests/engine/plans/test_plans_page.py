"""The page on plans shows what a client developer needs, and its code works."""

import re
from collections.abc import Callable

import pytest

from plans.engine.actions import ACTIONS, ACTIONS_BY_NAME
from plans.engine.client_advice import CLIENT_ADVICE
from plans.engine.fill import fill_actions, plan_string
from plans.engine.intents import SLOT_KINDS, ActionItem, Intent, Library, Slot
from plans.engine.kb_actions import KB_ACTIONS
from plans.engine.plans_page import plans_page
from tests.engine.plans.worlds import LIBRARY

PAGE = plans_page(LIBRARY)
Reader = Callable[[str], list[tuple[str, dict[str, str | None]]]]


@pytest.fixture
def read_plan() -> Reader:
    """Return the page's own function, knowing every action."""
    (code,) = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)
    names: dict[str, object] = {}
    exec(code, names)  # noqa: S102 - the page shows it
    names["PARAMETERS"] = {
        action.name: [parameter.name for parameter in action.parameters] for action in ACTIONS
    }
    reader: Reader = names["read_plan"]  # type: ignore[assignment]
    return reader


def section(key: str) -> str:
    return PAGE.partition(f"### {key}\n")[2].partition("\n### ")[0]


@pytest.mark.parametrize(
    "text", ["Hey Brother", "e=mc what=two level=up", "", "#action=rest", "千本桜"]
)
@pytest.mark.parametrize("action", ACTIONS, ids=lambda action: action.name)
def test_the_shown_code_reads_every_plan(action: object, text: str, read_plan: Reader) -> None:
    names = [parameter.name for parameter in ACTIONS_BY_NAME[action.name].parameters]
    item = ActionItem(action=action.name, parameters=tuple((name, text) for name in names))
    filled = fill_actions((item, ActionItem(action="rest")), {})
    expected = [(one.action, one.parameters) for one in filled]
    assert read_plan(plan_string(filled)) == expected


def test_the_shown_code_skips_actions_it_does_not_know(read_plan: Reader) -> None:
    assert read_plan("#action=juggle balls=3#action=hug") == [("hug", {})]
    assert read_plan("") == []


def test_every_action_is_in_a_table() -> None:
    named = {*(action.name for action in ACTIONS), *(action.name for action in KB_ACTIONS)}
    assert {name for name in named if f"\n| `{name}` |" not in PAGE} == set()


def test_advice_is_given_for_known_actions_only() -> None:
    assert set(CLIENT_ADVICE) <= set(ACTIONS_BY_NAME)


def test_an_intent_shows_its_plan_slots_and_triggers() -> None:
    volume = section("volume")
    assert "- Plan: `#action=volume level={level}`" in volume
    assert "| `level` | one of [volume_level](#list-volume_level) |" in volume
    assert "- `(talk|speak) {level} [{times} times]`" in volume
    assert "- `音 を {level} して`" in volume
    assert "| `title` | any words | yes | Which song? (en) |" in section("playsong")


def test_a_value_list_shows_its_words_by_language() -> None:
    assert "| `louder` | louder, up, more loudly | più forte | 大きく |" in section(
        "List volume_level"
    )


def test_the_most_pressing_family_comes_first() -> None:
    keys = re.findall(r"^### (alarm|playsong|likes)$", PAGE, re.MULTILINE)
    assert keys == ["alarm", "playsong", "likes"]


def test_every_link_inside_the_page_leads_somewhere() -> None:
    headings = re.findall(r"^#+ (.+)$", PAGE, re.MULTILINE)
    anchors = {re.sub(r"[^\w -]", "", one.lower()).replace(" ", "-") for one in headings}
    assert set(re.findall(r"\]\(#([^)]+)\)", PAGE)) - anchors == set()


def test_every_kind_of_slot_is_explained() -> None:
    slots = tuple(Slot(name=f"a_{kind}", kind=kind) for kind in SLOT_KINDS)
    intent = Intent(number=1, key="a", slots=slots, triggers={}, plan_sentences={})
    page = plans_page(Library(intents=(intent,)))
    assert all(re.search(rf"\| `a_{kind}` \| \S", page) for kind in SLOT_KINDS)
