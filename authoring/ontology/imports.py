"""Imports as pages and programs see them: started here, carried out by a process of their own."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from datetime import datetime
from typing import Any

from django.conf import settings
from django.utils import timezone

from authoring.models.api_key import ApiKey
from authoring.ontology import process
from dialogue.draft import draft_version
from dialogue.models import Topic
from ontology_io import import_runs
from ontology_io.bounded_file import inflated
from ontology_io.models import ImportRun

MOST_LISTED = 10
#: Above this number no row can have it.
HIGHEST = 2**31


class BusyError(RuntimeError):
    """Somebody else is bringing a file in; `run` says who and since when."""

    def __init__(self, run: "Run | None") -> None:
        super().__init__("An import is going on.")
        self.run = run


@dataclass(frozen=True, slots=True)
class Problem:
    """Something wrong with a file: its place, what it is, what to do."""

    where: str
    text: str
    hint: str = ""
    error: bool = True


@dataclass(frozen=True, slots=True)
class Run:
    """One import: who brought which file, how it goes on, what it found."""

    number: int
    file: str
    who: str
    keep: bool
    step: str
    started: datetime
    draft: int
    applied: bool
    result: Mapping[str, Any]

    @property
    def going_on(self) -> bool:
        """Say whether something is being done; it waits for nobody."""
        return self.step in import_runs.STEPS

    @property
    def ready(self) -> bool:
        """Say whether it waits for somebody to decide."""
        return self.step == import_runs.READY

    @property
    def writing(self) -> bool:
        """Say whether it is, or is about to be, written into the draft."""
        waiting = self.step == import_runs.WAITING and "counts" in self.result
        return waiting or self.step == import_runs.WRITING

    @property
    def stale(self) -> bool:
        """Say whether the draft has changed since the comparison; one query."""
        return self.ready and self.draft != draft_version()

    @property
    def counts(self) -> Mapping[str, Mapping[str, int]]:
        """Return the changes in numbers: kind → added, changed, removed, renamed → how many."""
        counts: Mapping[str, Mapping[str, int]] = self.result.get("counts", {})
        return counts

    @property
    def removed(self) -> int:
        """Return how many topics would be removed."""
        return self.counts.get("topics", {}).get("removed", 0)

    def problems(self) -> Iterator[Problem]:
        """Yield what is wrong with the file, errors first, then what is good to know."""
        for one in self.result.get("problems", ()):
            hint, error = one.get("hint", ""), one.get("error", True)
            yield Problem(one["where"], one["text"], hint, error)

    def findings(self) -> Iterator[Problem]:
        """Yield what must be mended before the result can be published."""
        for one in self.result.get("findings", ()):
            yield Problem(one["where"], one["text"], one["hint"])

    def names(self, kind: str, what: str) -> list[str]:
        """Return the keys of the rows of a kind that are added, changed or removed."""
        changes = self.result.get("changes", ())
        return [one["key"] for one in changes if (one["kind"], one["what"]) == (kind, what)]


def _told(row: ImportRun) -> Run:
    user = row.author
    lost = row.running and row.beat < timezone.now() - import_runs.LOST_AFTER
    return Run(
        number=row.pk,
        file=row.file_name,
        who=(user.get_full_name() or user.get_username()) if user else "",
        keep=row.keep,
        step=import_runs.LOST if lost else row.step,
        started=row.started,
        draft=row.draft,
        applied=row.applied,
        result=row.result,
    )


def run(number: int) -> Run | None:
    """Return an import by its number, None where there is none; one query."""
    rows = ImportRun.objects.select_related("author").defer("data")
    row = rows.filter(pk=number).first() if number < HIGHEST else None
    return _told(row) if row else None


def busy() -> Run | None:
    """Return the import that is going on."""
    row = import_runs.running()
    return _told(row) if row else None


def last_runs() -> list[Run]:
    """Return the last imports, the newest first; one query."""
    rows = ImportRun.objects.select_related("author").defer("data")[:MOST_LISTED]
    return [_told(row) for row in rows]


def topics() -> int:
    """Return how many topics the draft has."""
    return Topic.objects.count()


def begin(
    author: int | None, file: str, data: bytes, *, keep: bool = False, apply: bool = False
) -> int:
    """Start an import and return its number; with `apply` it is written where it has no errors.

    Raises BusyError, or OwlError where a compressed file is damaged or becomes too large.
    """
    data = inflated(data, settings.CAIR_LONGEST_ONTOLOGY)
    try:
        row = import_runs.begin(author, file, data, keep=keep)
    except import_runs.BusyError as error:
        raise BusyError(_told(error.run) if error.run else None) from error
    process.start(row.pk, *(["--apply"] if apply else []))
    return row.pk


def begin_for_program(key: int, data: bytes, *, keep: bool, apply: bool) -> int:
    """Start an import for the program that has this key. Raises as `begin` does."""
    label = ApiKey.objects.values_list("label", flat=True).get(pk=key)
    return begin(None, f"{label} (API)", data, keep=keep, apply=apply)


def apply(number: int) -> None:
    """Start writing what was found ready; nothing where it is not (any more). Raises BusyError."""
    try:
        import_runs.resume(number)
    except import_runs.NotReadyError:
        return
    except import_runs.BusyError as error:
        raise BusyError(_told(error.run) if error.run else None) from error
    process.start(number, "--apply")


def discard(number: int) -> bool:
    """Give an import up; say whether it could be."""
    return import_runs.discard(number)
