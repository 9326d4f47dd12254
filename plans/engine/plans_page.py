"""The page docs/plans.md for developers of clients, written from a library."""

from collections.abc import Iterable, Iterator

from languages.known import LANGUAGES
from plans.engine.actions import ACTIONS, ClientAction, Parameter
from plans.engine.client_advice import CLIENT_ADVICE
from plans.engine.fill import fill_actions, kbplan_string, plan_string
from plans.engine.intents import Intent, IntentTest, Library, Slot, ValueList
from plans.engine.kb_actions import KB_ACTIONS
from plans.engine.plan_text import print_plan
from plans.engine.plans_page_prose import ACTIONS_INTRO, HEAD, INTENTS_INTRO, KB_INTRO, READING
from plans.engine.sayings import is_saying

_KINDS = {
    "text": "any words",
    "topic": "a topic, any words",
    "number": "a number, in digits",
    "duration": "a length of time: seconds, in digits",
    "time": "a time of day: four digits, `0730`",
    "date": "a day: `today`, `tomorrow`, `in_2_days`, `monday` or month and day, `1225`",
    "yes_no": "`yes` or `no`",
}
_WRITTEN = tuple(LANGUAGES)


def plans_page(library: Library) -> str:
    """Return the page as markdown; the same library gives the same text."""
    lines = [HEAD, READING, ACTIONS_INTRO, *_actions(), KB_INTRO, *_kb_actions(), INTENTS_INTRO]
    families = _families(library)
    lines += [f"- {name}: {_links(intents)}" for name, intents in families.items()]
    for name, intents in families.items():
        lines += ["", f"## Intents: {name}"]
        for intent in intents:
            lines += ["", *_intent(intent)]
    lines += ["", "## Value lists", *_value_lists(library.values)]
    lines += ["", "## Phrases", "", *_phrases(library)]
    return "\n".join(lines) + "\n"


def _table(head: Iterable[str], rows: Iterable[Iterable[str]]) -> Iterator[str]:
    """Yield a table; a `|` inside a cell is escaped."""
    cells = list(head)
    yield f"| {' | '.join(cells)} |"
    yield f"|{' --- |' * len(cells)}"
    for row in rows:
        yield f"| {' | '.join(cell.replace('|', '&#124;') for cell in row)} |"


def _actions() -> Iterator[str]:
    for common in (True, False):
        if not common:
            yield ""
            yield "Only for clients that name them in `capabilities`:"
            yield ""
        rows = (
            (f"`{one.name}`", _parameters(one.parameters), _meaning(one))
            for one in ACTIONS
            if one.common is common
        )
        yield from _table(("action", "parameters", "what the client does"), rows)


def _parameters(parameters: Iterable[Parameter]) -> str:
    return "; ".join(
        f"`{one.name}` ({one.kind.value}{': ' if one.values else ''}{', '.join(one.values)})"
        for one in parameters
    )


def _meaning(action: ClientAction) -> str:
    return f"{action.meaning} {CLIENT_ADVICE.get(action.name, '')}".rstrip()


def _kb_actions() -> Iterator[str]:
    rows = (
        (f"`{one.name}`", ", ".join(f"`{name}`" for name in one.parameters), one.meaning)
        for one in KB_ACTIONS
    )
    return _table(("KBplan action", "parameters", "what the Dialogue Manager does"), rows)


def _families(library: Library) -> dict[str, list[Intent]]:
    """Return the intents by family: the most pressing first, then by name."""
    families: dict[str, list[Intent]] = {}
    for intent in sorted(library.intents, key=lambda one: (-one.priority, one.key)):
        families.setdefault(intent.family or "other", []).append(intent)
    pressing = sorted(families, key=lambda name: (-families[name][0].priority, name))
    return {name: families[name] for name in pressing}


def _links(intents: Iterable[Intent]) -> str:
    return ", ".join(f"[{intent.key}](#{intent.key})" for intent in intents)


def _intent(intent: Intent) -> Iterator[str]:
    yield f"### {intent.key}"
    yield ""
    if intent.note:
        yield intent.note
        yield ""
    for title, plan in (("Plan", intent.plan), ("KBplan", intent.kbplan)):
        if plan:
            yield f"- {title}: `{print_plan(plan)}`"
    if intent.abilities:
        yield f"- The agent can: {_in_languages(intent.abilities)}"
    yield f"- Priority: {intent.priority}"
    if intent.slots:
        yield ""
        yield from _slots(intent)
    yield ""
    yield from _examples(intent)
    yield from _folded("Triggers", _triggers(intent))


def _in_languages(texts: dict[str, str]) -> str:
    return ", ".join(f"{texts[code]} ({code})" for code in _WRITTEN if texts.get(code))


def _slots(intent: Intent) -> Iterator[str]:
    rows = (
        (
            f"`{slot.name}`",
            _kind(slot),
            "yes" if slot.required else "",
            _in_languages(slot.questions),
        )
        for slot in intent.slots
    )
    return _table(("parameter", "what it holds", "required", "the question that asks for it"), rows)


def _kind(slot: Slot) -> str:
    return (
        f"one of [{slot.list_key}](#list-{slot.list_key})" if slot.list_key else _KINDS[slot.kind]
    )


def _examples(intent: Intent) -> Iterator[str]:
    rows = []
    for code in _WRITTEN:
        test = _first_test(intent, code)
        if test is not None:
            values = test.parameters or {}
            plans = (
                plan_string(fill_actions(intent.plan, values)),
                kbplan_string(fill_actions(intent.kbplan, values)),
            )
            rows.append((code, test.sentence, "<br>".join(f"`{plan}`" for plan in plans if plan)))
    if rows:
        yield from _table(("", "a person says", "plan or KBplan"), rows)
        yield ""


def _first_test(intent: Intent, code: str) -> IntentTest | None:
    """Return the first positive test, one with parameters where there is one."""
    positive = [test for test in intent.tests.get(code, ()) if test.parameters is not None]
    return next((test for test in positive if test.parameters), next(iter(positive), None))


def _triggers(intent: Intent) -> Iterator[str]:
    for code in _WRITTEN:
        if code in intent.triggers:
            yield f"{LANGUAGES[code].own_name}:"
            yield ""
            yield from (f"- `{text}`" for text in intent.triggers[code])
            yield ""


def _folded(title: str, lines: Iterable[str]) -> Iterator[str]:
    """Yield lines that a reader opens with a click."""
    yield f"<details><summary>{title}</summary>"
    yield ""
    yield from lines
    yield "</details>"


def _value_lists(lists: Iterable[ValueList]) -> Iterator[str]:
    for listed in sorted(lists, key=lambda one: one.key):
        names = sorted({name for values in listed.values.values() for name in values})
        rows = (
            (
                f"`{name}`",
                *(", ".join(listed.values.get(code, {}).get(name, ())) for code in _WRITTEN),
            )
            for name in names
        )
        yield ""
        yield f"### List {listed.key}"
        yield ""
        yield from _table(("value", *_WRITTEN), rows)


def _phrases(library: Library) -> Iterator[str]:
    lines = [
        f"- `<{phrase.key}>` {code}: {', '.join(phrase.texts[code].split('|'))}"
        for phrase in sorted(library.phrases, key=lambda one: one.key)
        if not is_saying(phrase.key)
        for code in _WRITTEN
        if phrase.texts.get(code)
    ]
    return _folded("What stands for `<phrase>` in triggers", [*lines, ""])
