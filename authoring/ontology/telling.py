"""An import as programs are told of it."""

from typing import Any

from authoring.ontology.imports import Problem, Run


def told(run: Run) -> dict[str, Any]:
    """Return an import as JSON can hold it (docs/api.md); `*_total` count what is left out too."""
    result = run.result
    return {
        "number": run.number,
        "step": run.step,
        "ended": not run.going_on,
        "applied": run.applied,
        "problems": [_problem(one) for one in run.problems()],
        "problems_total": result.get("problems_total", len(result.get("problems", ()))),
        "differences": run.counts,
        "changes": result.get("changes", []),
        "changes_total": result.get("changes_total", 0),
        "renamed": result.get("renamed", []),
        "unknown": result.get("unknown", {}),
        "persons": result.get("persons", 0),
        "to_mend": [_problem(one) for one in run.findings()],
        "to_mend_total": result.get("findings_total", 0),
    }


def _problem(one: Problem) -> dict[str, object]:
    return {"error": one.error, "where": one.where, "text": one.text, "hint": one.hint}
