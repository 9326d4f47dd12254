"""What the checks find in the draft: run, kept for all workers, and looked up for badges."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from datetime import datetime

import msgspec
from msgspec.structs import replace

from authoring.checks.findings_lints import LintRemarks
from authoring.checks.findings_places import Places
from authoring.checks.findings_words import language_of
from authoring.models import CheckRun
from dialogue.content import read_knowledge
from dialogue.draft import draft_version
from dialogue.garbage import collected_later
from dialogue.publishing import check
from dialogue.snapshot import Snapshot
from plans.content import read_library
from plans.engine.catalogue import LibraryError, compile_catalogue
from plans.engine.intents import Library
from plans.engine.library_lint import lint
from plans.engine.stored_tests import run_stored_tests

TEST_FAILED = "T001"
#: So many findings are kept, errors first; the others are counted.
MOST_KEPT = 5000
_ONLY = 1


class Found(msgspec.Struct, frozen=True):
    """One finding. `where` is the key of a topic, sentence, pool, intent, phrase or list.

    `row` ("dialogue.frame", …) and `number` name the row to edit, "" and 0 where there is none;
    `branch` is the key of a topic below the root, "" elsewhere; `blocks` stops publishing.
    """

    code: str
    where: str
    message: str
    hint: str = ""
    blocks: bool = False
    language: str = ""
    branch: str = ""
    row: str = ""
    number: int = 0


@dataclass(frozen=True, slots=True)
class Checked:
    """The last check: the version of the draft it saw, when, and what it found."""

    draft: int
    when: datetime
    found: tuple[Found, ...]
    total: int

    @property
    def errors(self) -> int:
        """Return how many findings stop publishing."""
        return sum(one.blocks for one in self.found)

    @property
    def warnings(self) -> int:
        """Return how many findings are worth a look; those that were not kept count too."""
        return self.total - self.errors


def last_check() -> Checked | None:
    """Return the last check, None before the first one; one query."""
    row = CheckRun.objects.filter(pk=_ONLY).first()
    if row is None:
        return None
    found = msgspec.json.decode(row.findings, type=tuple[Found, ...])
    return Checked(row.draft, row.created, found, row.total)


@collected_later()
def check_now() -> Checked:
    """Check the draft as it is, and keep the result for everybody."""
    version = draft_version()
    snapshot = Snapshot(knowledge=read_knowledge(), library=read_library())
    found = sorted(findings(snapshot), key=lambda one: (not one.blocks, one.code))
    kept = tuple(found[:MOST_KEPT])
    row, _new = CheckRun.objects.update_or_create(
        pk=_ONLY,
        defaults={
            "draft": version,
            "total": len(found),
            "findings": msgspec.json.encode(kept).decode(),
        },
    )
    return Checked(version, row.created, kept, len(found))


def findings_for(keys: Iterable[str], checked: Checked | None = None) -> dict[str, list[Found]]:
    """Return what the last check found about topics, sentences and intents, by their keys.

    What was found in a sentence belongs to its topic too. Keys without findings are left out.
    """
    checked = checked or last_check()
    wanted = frozenset(keys)
    about: dict[str, list[Found]] = {}
    for one in checked.found if checked else ():
        for key in {one.where, one.where.partition(".")[0]} & wanted:
            about.setdefault(key, []).append(one)
    return about


def findings(snapshot: Snapshot) -> list[Found]:
    """Return what all checks find in a knowledge base with its intents."""
    places = Places(snapshot)
    found = [*_errors(snapshot, places), *_remarks(snapshot, places)]
    if not any(one.blocks for one in found):
        found += _lints(snapshot, places)
    return found


def _errors(snapshot: Snapshot, places: Places) -> Iterator[Found]:
    for one in check(snapshot):
        yield Found(
            one.code,
            one.where,
            one.message,
            one.hint,
            one.error,
            language_of(one.code, one.message),
            *places.of(one.where),
        )


def _remarks(snapshot: Snapshot, places: Places) -> list[Found]:
    """Return failed tests and conflicts of the intents; none where they cannot be compiled."""
    return [
        replace(one, **dict(zip(("branch", "row", "number"), places.of(one.where), strict=True)))
        for one in _kept.of(snapshot.library)
    ]


def _lints(snapshot: Snapshot, places: Places) -> Iterator[Found]:
    """Yield what falls short of the quality bars, but for K2, which takes longest."""
    for one in _linted.of(snapshot.knowledge):
        at = places.of(one.where)
        yield Found(one.code, one.where, one.message, one.hint, False, one.language, *at)


class _LibraryFindings:
    """What was found in the intents last time: they change seldom and take long to try."""

    def __init__(self) -> None:
        self._last: tuple[Library, tuple[Found, ...]] | None = None

    def of(self, library: Library) -> tuple[Found, ...]:
        """Return what is found in a library, without places."""
        last = self._last
        if last is None or last[0] != library:
            last = self._last = (library, tuple(_tried(library)))
        return last[1]


_kept = _LibraryFindings()
_linted = LintRemarks()


def _tried(library: Library) -> Iterator[Found]:
    try:
        catalogue = compile_catalogue(library)
    except LibraryError:  # P001 says so.
        return
    for tested in run_stored_tests(library, catalogue):
        for one in tested.failures:
            message = f"‘{one.sentence}’: {one.reason}."
            yield Found(TEST_FAILED, one.intent, message, language=one.language)
    for remark in lint(library, catalogue):
        where = remark.where.strip("<>")
        yield Found(remark.code, where, remark.text, language=remark.language)


def counts_by(found: Iterable[Found], name: str) -> Mapping[str, int]:
    """Return how many findings there are for each value of a field, e.g. "branch"."""
    counts: dict[str, int] = {}
    for one in found:
        value = str(getattr(one, name))
        counts[value] = counts.get(value, 0) + 1
    return counts
