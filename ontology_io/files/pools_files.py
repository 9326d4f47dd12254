"""Read and write cultures.yaml and pools.yaml."""

from collections.abc import Iterable, Mapping

from dialogue.engine.concepts import Culture, Frame
from dialogue.engine.pools import POOLS
from languages.known import LANGUAGES
from ontology_io.files.emit import flow_list, flow_map, raw_map, scalar
from ontology_io.files.nodes import Problems, Value, each, parse

CULTURE_KEYS = frozenset(("code", "language", "names"))
POOL_KEYS = frozenset(("id", "s"))
LINE_KEYS = frozenset(("only",)) | frozenset(LANGUAGES)


def read_cultures(text: str, problems: Problems) -> tuple[Culture, ...]:
    """Return the cultures of cultures.yaml."""
    cultures = []
    for value in each(parse(text, problems, ("cultures",)), "cultures"):
        entries = value.known_entries(CULTURE_KEYS)
        if entries.keys() != CULTURE_KEYS:
            problems.add(value.line, "A culture needs code, language and names.")
            continue
        cultures.append(
            Culture(
                code=entries["code"].text(),
                language=entries["language"].text(),
                names=entries["names"].text_entries(),
            )
        )
    return tuple(cultures)


def write_cultures(cultures: Iterable[Culture]) -> str:
    """Return the text of cultures.yaml."""
    rows = [
        "- "
        + raw_map(
            {
                "code": culture.code,
                "language": culture.language,
                "names": flow_map(culture.names),
            }
        )
        for culture in cultures
    ]
    return "\n".join(["cultures:", *rows]) + "\n"


def read_pools(text: str, problems: Problems) -> dict[str, tuple[Frame, ...]]:
    """Return the pools of pools.yaml."""
    pools: dict[str, tuple[Frame, ...]] = {}
    for value in each(parse(text, problems, ("pools",)), "pools"):
        entries = value.known_entries(POOL_KEYS)
        name = entries["id"].text() if "id" in entries else ""
        if name not in POOLS:
            problems.add(value.line, f"{name!r} is no pool; use {', '.join(POOLS)}.")
        if name in pools:
            problems.add(value.line, f"The pool {name} stands in this file twice.")
        lines = entries["s"].entries() if "s" in entries else {}
        pools[name] = tuple(_frame(name, local, line) for local, line in lines.items())
    return pools


def _frame(pool: str, local: str, value: Value) -> Frame:
    entries = value.known_entries(LINE_KEYS)
    if not local.isdecimal():
        value.problems.add(value.line, f"{local!r} must be a number.")
    return Frame(
        key=f"{pool}.{local}",
        type=pool,
        texts={code: entries[code].text() for code in LANGUAGES if code in entries},
        only=entries["only"].texts() if "only" in entries else (),
    )


def write_pools(pools: Mapping[str, tuple[Frame, ...]]) -> str:
    """Return the text of pools.yaml, pools in the order of the table."""
    lines = ["pools:"]
    for name in POOLS:
        if pools.get(name):
            lines += [f"- id: {name}", "  s:"]
        for frame in pools.get(name, ()):
            lines.append(f"    {frame.key.partition('.')[2]}:")
            if frame.only:
                lines.append(f"      only: {flow_list(frame.only)}")
            lines += [f"      {code}: {scalar(text)}" for code, text in frame.texts.items()]
    return "\n".join(lines) + "\n"
