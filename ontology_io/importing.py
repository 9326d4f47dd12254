"""Bring an ontology into the draft: look first at what it would change, then write it.

Reading happens in a process of its own (ontology_io.owl.reading); writing in one transaction.
"""

from collections.abc import Callable
from dataclasses import dataclass, field

import msgspec
from django.conf import settings
from django.db import transaction

from dialogue.draft import draft_version
from dialogue.engine.findings import Finding
from dialogue.models import DraftVersion
from ontology_io.changes import Change, changes, counted
from ontology_io.check import check_base
from ontology_io.numbering import numbered
from ontology_io.owl.file_records import OwlFile, Problem
from ontology_io.owl.limits import Limits
from ontology_io.owl.names import individual_names, intent_name, pool_name
from ontology_io.owl.reading import read_owl
from ontology_io.owl.resolve import Resolved, resolve
from ontology_io.owl.resolve_identity import Renamed
from ontology_io.owl.vocabulary import RDF, VOCABULARY
from ontology_io.records import KnowledgeBase
from ontology_io.remainder import keep_remainder, remainder_text
from ontology_io.store import read_base, write_base

#: The steps of a preview, then of writing.
READING, COMPARING, WRITING = "reading", "comparing", "writing"
#: Findings about what the rows cannot hold: they stop an import, others only a publication.
STRUCTURE = frozenset(
    ("D001", "D002", "D003", "D004", "D005", "D006", "D007", "D008", "D009", "D014", "D016", "D020")
)


class DraftChangedError(RuntimeError):
    """The draft is no longer the one that the preview compared with; nothing was written."""

    def __init__(self) -> None:
        super().__init__(
            "The draft has changed since the comparison, so nothing was written. Import again."
        )


class HasErrorsError(ValueError):
    """The file has errors; nothing was written."""


class Plan(msgspec.Struct, frozen=True, kw_only=True):
    """What is to be written: the knowledge base, the highest numbers ever given, the remainder.

    `draft` is the version of the draft it was compared with.
    """

    draft: int
    base: KnowledgeBase
    last: dict[str, int] = {}
    remainder: str = ""


@dataclass(frozen=True, slots=True)
class Preview:
    """What a file would change; with `errors` it cannot be applied.

    `before` is the draft, `plan.base` what it would be: rows with the same number are the same.
    `findings` are to be mended before publishing. `kept` counts the lines of the remainder that
    come and go. `unknown` and `persons` are those of the file.
    """

    plan: Plan
    before: KnowledgeBase
    problems: tuple[Problem, ...] = ()
    changes: tuple[Change, ...] = ()
    renamed: tuple[Renamed, ...] = ()
    findings: tuple[Finding, ...] = ()
    kept: tuple[int, int] = (0, 0)
    unknown: dict[str, int] = field(default_factory=dict)
    persons: int = 0

    @property
    def errors(self) -> tuple[Problem, ...]:
        """Return the problems that stop the import."""
        return tuple(problem for problem in self.problems if problem.error)

    @property
    def counts(self) -> dict[str, dict[str, int]]:
        """Return the changes in numbers: kind → added, changed, removed, renamed → how many."""
        return counted(self.changes)

    def __bool__(self) -> bool:
        """Say whether anything would change."""
        return bool(self.changes) or any(self.kept)


def preview(
    data: bytes,
    *,
    keep: bool = False,
    limits: Limits | None = None,
    watch: Callable[[str], None] = lambda _step: None,
) -> Preview:
    """Return what the file would change. Writes nothing.

    `keep` keeps what the draft has and the file lacks; `watch` hears of each step.
    Raises OwlError where the file cannot be read.
    """
    watch(READING)
    content = f"{settings.CAIR_ONTOLOGY_IRI}#"
    file = read_owl(data, limits or Limits(), content=content)
    watch(COMPARING)
    return compared(file, keep=keep)


def compared(file: OwlFile, *, keep: bool = False) -> Preview:
    """Return what a file that was read would change."""
    with transaction.atomic():
        version, draft, remainder = draft_version(), read_base(), remainder_text()
        if any(problem.error for problem in file.problems):
            plan = Plan(draft=version, base=draft)
            return _preview(file, plan, draft, Resolved(base=draft))
        resolved = resolve(file, draft, keep=keep)
        base = numbered(resolved.base, draft)
    own, problems = _without_strays(file, base)
    resolved = msgspec.structs.replace(resolved, problems=(*resolved.problems, *problems))
    after = _joined(remainder, own) if keep else own
    plan = Plan(draft=version, base=base, last=resolved.last, remainder=after)
    return _preview(file, plan, draft, resolved, _kept(remainder, after))


def _preview(
    file: OwlFile,
    plan: Plan,
    draft: KnowledgeBase,
    resolved: Resolved,
    kept: tuple[int, int] = (0, 0),
) -> Preview:
    found = changes(draft, plan.base)
    findings = tuple(check_base(plan.base)) if found else ()
    problems = [*file.problems, *resolved.problems]
    problems += [
        Problem(where=one.where, text=one.message, hint=one.hint)
        for one in findings
        if one.code in STRUCTURE
    ]
    return Preview(
        plan=plan,
        before=draft,
        problems=tuple(sorted(problems, key=lambda one: not one.error)),
        changes=found,
        renamed=resolved.renamed,
        findings=tuple(one for one in findings if one.error and one.code not in STRUCTURE),
        kept=kept,
        unknown=file.unknown,
        persons=file.persons,
    )


def _without_strays(file: OwlFile, base: KnowledgeBase) -> tuple[str, list[Problem]]:
    """Return the remainder without what it says about individuals that had lost their class.

    The draft writes individuals of the same names again, which would then say two things.
    """
    known = {one.name for topic in file.topics for one in topic.individuals}
    known |= {*map(pool_name, file.pools), *(intent_name(one.intent.key) for one in file.intents)}
    names = {*individual_names(base.knowledge).values(), *map(pool_name, base.knowledge.pools)}
    names |= {intent_name(one.key) for one in base.library.intents}
    strange, begin = names - known, f"<{settings.CAIR_ONTOLOGY_IRI}#"
    kept, strays = [], set()
    for line in file.remainder.splitlines(keepends=True):
        subject, _, rest = line.partition(" ")
        name = subject.removeprefix(begin).removesuffix(">")
        stray = subject.startswith(begin) and name in strange
        if stray and rest.startswith((f"<{VOCABULARY}", f"<{RDF}type>")):
            strays.add(name)
        else:
            kept.append(line)
    text = "It is an individual of no class, so what it says is not taken."
    hint = "Give it the class it belongs to as type."
    return "".join(kept), [
        Problem(where=name, text=text, hint=hint, error=False) for name in sorted(strays)
    ]


def _joined(old: str, new: str) -> str:
    lines = sorted({*old.splitlines(), *new.splitlines()})
    return "".join(f"{line}\n" for line in lines)


def _kept(old: str, new: str) -> tuple[int, int]:
    """Return how many lines come and how many go."""
    before, after = {*old.splitlines()}, {*new.splitlines()}
    return len(after - before), len(before - after)


def apply(found: Preview, *, told: str) -> None:
    """Write what was previewed; the history gets one line, `told`.

    Raises HasErrorsError, or DraftChangedError where the draft is another one by now.
    """
    if found.errors:
        raise HasErrorsError("The file has errors, so nothing was written.")
    write(found.plan, told=told)


@transaction.atomic
def write(plan: Plan, *, told: str) -> None:
    """Write a plan, all of it or nothing. Raises DraftChangedError."""
    # Whoever changes the draft touches this row, so nobody comes between looking and writing.
    DraftVersion.objects.select_for_update().get_or_create(pk=1)
    if draft_version() != plan.draft:
        raise DraftChangedError
    write_base(plan.base, plan.last, told=told)
    keep_remainder(plan.remainder)
