"""Imports as people see them: one at a time, step by step, with a status all workers can read."""

import logging
import zlib
from datetime import timedelta
from types import SimpleNamespace
from typing import Any

import msgspec
from django.db import IntegrityError, transaction
from django.utils import timezone

from ontology_io import importing
from ontology_io.importing import DraftChangedError, Plan, Preview
from ontology_io.models import ImportRun
from ontology_io.owl.file_records import Problem
from ontology_io.owl.limits import Limits, OwlError
from plans.recording import recorded_for

logger = logging.getLogger(__name__)

#: The steps of a run: until it can be looked at, then the one that writes.
WAITING, SCANNING, READING, COMPARING, WRITING = STEPS = (
    "waiting",
    "scanning",
    importing.READING,
    importing.COMPARING,
    importing.WRITING,
)
#: How a run comes to rest: to be looked at and decided; written; the file has errors; the draft
#: has changed meanwhile; an unforeseen error; its process is gone; given up by a person.
READY, DONE, REFUSED, CHANGED, FAILED, LOST, CANCELLED = ENDS = (
    "ready",
    "done",
    "refused",
    "changed",
    "failed",
    "lost",
    "cancelled",
)
#: A run of which nothing is heard for so long has lost its process; reading may take 3 minutes.
LOST_AFTER = timedelta(minutes=5)
#: So many runs are remembered, and so long one that is ready waits for somebody to decide.
REMEMBERED, DECIDED_WITHIN = 50, timedelta(days=7)
#: So many problems, changes and findings are kept of a run; the rest is counted.
MOST_KEPT = 300
MOST_DETAILS, LONGEST_DETAIL = 60, 500


class BusyError(RuntimeError):
    """An import is going on; `run` says who and since when."""

    def __init__(self, run: ImportRun | None) -> None:
        since = f" since {timezone.localtime(run.started):%H:%M}" if run else ""
        who = str(run.author or "Somebody") if run else "Somebody"
        super().__init__(f"{who} is importing an ontology{since}. Wait until it has ended.")
        self.run = run


class NotReadyError(RuntimeError):
    """The run cannot be applied (any more): it is not waiting for a decision."""


class _GivenUpError(RuntimeError):
    """The run was taken for lost, or cancelled, meanwhile."""


def running() -> ImportRun | None:
    """Return the run that is going on; one query."""
    oldest = timezone.now() - LOST_AFTER
    rows = ImportRun.objects.select_related("author").defer("data")
    return rows.filter(running=True, beat__gte=oldest).first()


def begin(author: int | None, file_name: str, data: bytes, *, keep: bool = False) -> ImportRun:
    """Start a run for a file. Raises BusyError where another one is going on."""
    _free_lost()
    _tidy()
    try:
        with transaction.atomic():
            return ImportRun.objects.create(
                running=True,
                author_id=author,
                file_name=file_name[-200:],
                keep=keep,
                data=data,
                step=WAITING,
            )
    except IntegrityError as error:
        raise BusyError(running()) from error


def resume(number: int) -> ImportRun:
    """Start writing what was found ready. Raises NotReadyError or BusyError."""
    _free_lost()
    rows = ImportRun.objects.filter(pk=number, running=None, step=READY)
    try:
        with transaction.atomic():
            found = rows.update(running=True, step=WAITING, beat=timezone.now())
    except IntegrityError as error:
        raise BusyError(running()) from error
    if not found:
        raise NotReadyError(f"Import {number} does not wait for a decision.")
    return ImportRun.objects.get(pk=number)


def discard(number: int) -> bool:
    """Give a run up, whether it is going on or ready; say whether it could be."""
    rows = ImportRun.objects.filter(pk=number, step__in=(READY, *STEPS[:-1]))
    return bool(rows.update(running=None, step=CANCELLED, data=b"", ended=timezone.now()))


def _free_lost() -> None:
    now = timezone.now()
    lost = ImportRun.objects.filter(running=True, beat__lt=now - LOST_AFTER)
    lost.update(running=None, step=LOST, data=b"", ended=now)


def _tidy() -> None:
    """Forget old runs, and empty those about which nobody has decided."""
    now = timezone.now()
    old = ImportRun.objects.filter(running=None, step=READY, started__lt=now - DECIDED_WITHIN)
    old.update(step=CANCELLED, data=b"", ended=now)
    kept = ImportRun.objects.values_list("pk", flat=True)[:REMEMBERED]
    ImportRun.objects.filter(running=None).exclude(pk__in=list(kept)).delete()


def plan_of(run: ImportRun) -> Plan:
    """Return what a run that is ready would write. Raises NotReadyError."""
    if not run.data or "counts" not in run.result:
        raise NotReadyError(f"Import {run.pk} has nothing to write.")
    return msgspec.msgpack.decode(zlib.decompress(bytes(run.data)), type=Plan)


def _packed(plan: Plan) -> bytes:
    return zlib.compress(msgspec.msgpack.encode(plan), 6)


def carry_out(run: ImportRun, *, apply: bool = False, limits: Limits | None = None) -> ImportRun:
    """Compare the file with the draft; with `apply` write it, or what was ready. Return the run.

    An import with errors is not written. Nothing is written where anything fails.
    """
    try:
        if "counts" not in run.result:
            _look(run, apply=apply, limits=limits)
        if apply and run.step not in ENDS:
            _write(run)
    except OwlError as error:
        _end(run, REFUSED, {"problems": _problems(error.problems)})
    except DraftChangedError:
        _end(run, CHANGED)
    except _GivenUpError:
        run.refresh_from_db()
    except Exception:
        logger.exception("An import failed.")
        _end(run, FAILED)
    return run


def _look(run: ImportRun, *, apply: bool, limits: Limits | None) -> None:
    def watch(step: str) -> None:
        _step(run, step)

    watch(SCANNING)
    found = importing.preview(bytes(run.data), keep=run.keep, limits=limits, watch=watch)
    result, draft = result_of(found), found.plan.draft
    if found.errors:
        _end(run, REFUSED, result, draft=draft)
        return
    run.result, run.draft, run.data = result, draft, _packed(found.plan)
    if apply:
        _step(run, COMPARING, result=result, draft=draft, data=run.data)
    else:
        _rest(run, READY, result=result, draft=draft, data=run.data)


def _write(run: ImportRun) -> None:
    plan = plan_of(run)
    _step(run, WRITING)
    request = SimpleNamespace(user=run.author)
    with transaction.atomic(), recorded_for(request):
        importing.write(plan, told=f"ontology imported from {run.file_name or 'a program'}")
        _rest(run, DONE, applied=True, data=b"", ended=timezone.now())


def _step(run: ImportRun, step: str, **fields: Any) -> None:
    """Write the step; a run that was given up meanwhile ends here."""
    _update(run, step=step, beat=timezone.now(), **fields)


def _rest(run: ImportRun, step: str, **fields: Any) -> None:
    _update(run, step=step, running=None, **fields)


def _update(run: ImportRun, **fields: Any) -> None:
    if not ImportRun.objects.filter(pk=run.pk, running=True).update(**fields):
        raise _GivenUpError
    for name, value in fields.items():
        setattr(run, name, value)


def _end(run: ImportRun, step: str, result: dict[str, Any] | None = None, draft: int = 0) -> None:
    """End a run without writing; one that was given up meanwhile stays so."""
    try:
        fields: dict[str, Any] = {"data": b"", "ended": timezone.now()}
        if result is not None:
            fields["result"] = result
        if draft:
            fields["draft"] = draft
        _rest(run, step, **fields)
    except _GivenUpError:
        run.refresh_from_db()


def _problems(problems: tuple[Problem, ...]) -> list[dict[str, Any]]:
    return [msgspec.to_builtins(problem) for problem in problems[:MOST_KEPT]]


def result_of(found: Preview) -> dict[str, Any]:
    """Return a preview as JSON can hold it, bounded.

    `problems` (where, text, hint, error; errors first), `problems_total`, `counts` (kind → what →
    how many), `changes` (kind, what, key, details), `changes_total`, `renamed` (kind, old, new),
    `unknown` (what → how many), `persons`, `kept` (lines of the remainder that come, that go),
    `findings` (code, where, text, hint), `findings_total`.
    """
    return {
        "problems": _problems(found.problems),
        "problems_total": len(found.problems),
        "counts": found.counts,
        "changes": [
            {
                "kind": one.kind,
                "what": one.what,
                "key": one.key,
                "details": [text[:LONGEST_DETAIL] for text in one.details[:MOST_DETAILS]],
            }
            for one in found.changes[:MOST_KEPT]
        ],
        "changes_total": len(found.changes),
        "renamed": [list(one) for one in found.renamed],
        "unknown": found.unknown,
        "persons": found.persons,
        "kept": list(found.kept),
        "findings": [
            {"code": one.code, "where": one.where, "text": one.message, "hint": one.hint}
            for one in found.findings[:MOST_KEPT]
        ],
        "findings_total": len(found.findings),
    }
