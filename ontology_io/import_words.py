"""What an import finds, as lines of text for a terminal."""

from collections.abc import Iterator, Mapping
from typing import Any

MOST_SHOWN = 40
_LONGEST = 200


def lines(result: Mapping[str, Any]) -> Iterator[str]:
    """Yield what import_runs.result_of returns: errors first, then what would change."""
    yield from _problems(result)
    if "counts" not in result:
        return
    yield from _unknown(result)
    if not result["changes"] and not any(result["kept"]):
        yield "0 changes."
        return
    for kind, counts in result["counts"].items():
        yield f"{kind}: {', '.join(f'{n} {what}' for what, n in counts.items())}"
    yield from _changes(result)
    for finding in _first(result["findings"]):
        told = "{code} {where}: {text} {hint}".format_map(finding)
        yield f"To mend before publishing: {told}"
    if result["findings_total"] > MOST_SHOWN:
        yield f"... and {result['findings_total'] - MOST_SHOWN} more to mend."


def _problems(result: Mapping[str, Any]) -> Iterator[str]:
    for problem in _first(result.get("problems", [])):
        word = "ERROR" if problem["error"] else "note"
        yield f"{word} {problem['where']}: {problem['text']} {problem['hint']}".rstrip()
    more = result.get("problems_total", 0) - MOST_SHOWN
    if more > 0:
        yield f"... and {more} more problems and notes."


def _unknown(result: Mapping[str, Any]) -> Iterator[str]:
    if result["persons"]:
        yield f"{result['persons']} person-specific individuals were left out."
    if result["unknown"]:
        told = ", ".join(f"{n} {what}" for what, n in sorted(result["unknown"].items()))
        yield f"Kept beyond the vocabulary, to go out again with exports: {told}"
    come, go = result["kept"]
    if come or go:
        yield f"Kept beyond the vocabulary: {come} statements new, {go} gone."


def _changes(result: Mapping[str, Any]) -> Iterator[str]:
    for change in _first(result["changes"]):
        yield f"{change['kind']}: {change['key']} {change['what']}"
        for detail in change["details"]:
            yield f"    {detail if len(detail) <= _LONGEST else detail[:_LONGEST] + '…'}"
    more = result["changes_total"] - MOST_SHOWN
    if more > 0:
        yield f"... and {more} more changes."


def _first(rows: list[Any]) -> list[Any]:
    return rows[:MOST_SHOWN]
