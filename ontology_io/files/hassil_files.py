"""Read the YAML of hassil and of Home Assistant's intents: sentences, rules and lists."""

from collections.abc import Iterable, Iterator, Mapping

from ontology_io.files.nodes import Problems, Value, each, parse
from plans.engine.hassil.data import Block, HassilFile, HassilList, ListValue, Template

LARGEST_FILE = 2_000_000
SECTIONS = (
    "language",
    "intents",
    "lists",
    "expansion_rules",
    "skip_words",
    "settings",
    "responses",
)
CONTEXTS = ("requires_context", "excludes_context")


def read_hassil(text: str, problems: Problems, language: str) -> HassilFile:
    """Return what one file says; what is only for other programs (responses) is passed over."""
    if len(text) > LARGEST_FILE:
        problems.add(1, f"This file has {len(text):,} characters; {LARGEST_FILE:,} at most.")
        return HassilFile(intents={})
    entries = parse(text, problems, SECTIONS)
    if "language" in entries:
        written = entries["language"].text()
        if written.lower().replace("_", "-").split("-")[0] != language:
            problems.add(entries["language"].line, f"This file is in {written!r}.")
    return HassilFile(
        intents={name: _blocks(value) for name, value in _entries(entries, "intents").items()},
        rules=_rules(entries),
        lists=_lists(entries),
        skip_words=tuple(map(_template, each(entries, "skip_words"))),
    )


def together(files: Iterable[HassilFile]) -> HassilFile:
    """Return several files as one: Home Assistant keeps rules and lists in a file of their own."""
    intents: dict[str, tuple[Block, ...]] = {}
    rules: dict[str, Template] = {}
    lists: dict[str, HassilList] = {}
    skip_words: dict[str, Template] = {}
    for file in files:
        for name, blocks in file.intents.items():
            intents[name] = (*intents.get(name, ()), *blocks)
        rules |= file.rules
        lists |= file.lists
        skip_words |= {word.text: word for word in file.skip_words}
    return HassilFile(intents, rules, lists, tuple(skip_words.values()))


def _entries(entries: Mapping[str, Value], key: str) -> dict[str, Value]:
    return entries[key].entries() if key in entries else {}


def _template(value: Value) -> Template:
    return Template(value.text(), value.line, value.problems.file)


def _rules(entries: Mapping[str, Value]) -> dict[str, Template]:
    rules = _entries(entries, "expansion_rules")
    return {name: _template(value) for name, value in rules.items()}


def _lists(entries: Mapping[str, Value]) -> dict[str, HassilList]:
    return {name: _list(value) for name, value in _entries(entries, "lists").items()}


def _blocks(value: Value) -> tuple[Block, ...]:
    data = value.entries()
    if "data" not in data:
        value.problems.add(value.line, "Write the sentences of an intent under `data:`.")
    return tuple(_block(one.entries()) for one in each(data, "data"))


def _block(entries: Mapping[str, Value]) -> Block:
    return Block(
        templates=tuple(map(_template, each(entries, "sentences"))),
        fixed={name: _fixed(value) for name, value in _entries(entries, "slots").items()},
        rules=_rules(entries),
        lists=_lists(entries),
        in_context=any(key in entries for key in CONTEXTS),
    )


def _fixed(value: Value) -> str:
    return value.text() if value.is_text else "/".join(value.texts())


def _list(value: Value) -> HassilList:
    entries = value.entries()
    if not entries.keys() & {"values", "range", "wildcard"}:
        value.problems.add(value.line, "A list has `values`, a `range`, or is a `wildcard`.")
    return HassilList(
        values=tuple(_values(each(entries, "values"))),
        number="range" in entries,
        wildcard="wildcard" in entries and entries["wildcard"].text().lower() == "true",
    )


def _values(values: Iterator[Value]) -> Iterator[ListValue]:
    for value in values:
        if value.is_text:
            yield ListValue(_template(value), value.text())
            continue
        entries = value.entries()
        if "in" not in entries:
            value.problems.add(value.line, "A value is a text, or has `in` and `out`.")
            continue
        said = _template(entries["in"])
        yield ListValue(said, entries["out"].text() if "out" in entries else said.text)
