"""How imports are told of in words."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, NamedTuple

from django.utils.formats import date_format
from django.utils.functional import Promise
from django.utils.timezone import localtime
from django.utils.translation import gettext, ngettext
from django.utils.translation import gettext_lazy as _

from ontology_io import import_runs as runs

if TYPE_CHECKING:
    from authoring.ontology.imports import Run

#: The steps until something can be seen, then the one that writes.
READING: Mapping[str, Promise] = {
    runs.WAITING: _("Waiting for its turn"),
    runs.SCANNING: _("Looking the file through"),
    runs.READING: _("Reading it"),
    runs.COMPARING: _("Comparing it with the draft"),
}
WRITING: Mapping[str, Promise] = {
    runs.WAITING: _("Waiting for its turn"),
    runs.WRITING: _("Writing it into the draft"),
}

END_WORDS: Mapping[str, Promise] = {
    runs.DONE: _("It is in the draft. Robots say it once you publish."),
    runs.REFUSED: _("Not brought in: the file has errors, and nothing was written."),
    runs.CHANGED: _(
        "Not brought in: the draft has changed since the comparison, and nothing was written. "
        "Bring the file again to see what it changes now."
    ),
    runs.FAILED: _(
        "Not brought in: something unforeseen went wrong, and nothing was written. Try again; if "
        "it stays so, ask your administrator to look into the log."
    ),
    runs.LOST: _(
        "Not brought in: the server stopped in between, and nothing was written. Bring the file "
        "again."
    ),
    runs.CANCELLED: _("Discarded: nothing was written."),
}
#: How the list tells it: a few words, and the colour of their badge.
SHORT: Mapping[str, tuple[Promise, str]] = {
    runs.READY: (_("can be looked at"), "warn"),
    runs.DONE: (_("in the draft"), "good"),
    runs.REFUSED: (_("has errors"), "bad"),
    runs.CHANGED: (_("draft changed meanwhile"), "warn"),
    runs.FAILED: (_("went wrong"), "bad"),
    runs.LOST: (_("interrupted"), "bad"),
    runs.CANCELLED: (_("discarded"), "count"),
}
KINDS = ("topics", "sentences", "intents", "cultures", "other")
MOODS = {"removed": "bad", "renamed": "warn", "changed": "", "added": "good"}
NOTHING = (_("changes nothing"), "good")
GOING_ON = (_("goes on"), "warn")


def too_large(longest: int) -> str:
    """Say that a file is too large, and what to do."""
    return _(
        "The file has more than %(n)d MB. Compress it with gzip, or ask your administrator."
    ) % {"n": longest // 1_000_000}


def busy(run: "Run | None") -> str:
    """Return who is bringing a file in."""
    who = run.who if run else ""
    if not who:
        return gettext(
            "Somebody else is bringing in an ontology right now. Wait until it has ended."
        )
    words = gettext("%(who)s is bringing in an ontology, since %(when)s. Wait until it has ended.")
    when = date_format(localtime(run.started), "TIME_FORMAT") if run else ""
    return words % {"who": who, "when": when}


class Step(NamedTuple):
    """A step as the page lists it; `state` is "over", "now" or ""."""

    name: str
    words: Promise
    state: str


def steps(run: "Run") -> list[Step]:
    """Return the steps of what goes on, those that are over and the one of now marked."""
    texts = WRITING if run.writing else READING
    here = list(texts).index(run.step)
    states = ["over"] * here + ["now"] + [""] * (len(texts) - here - 1)
    return [
        Step(name, text, state) for (name, text), state in zip(texts.items(), states, strict=True)
    ]


def short(run: "Run") -> Promise:
    """Return how an import ended in two or three words."""
    return _ended(run)[0]


def mood(run: "Run") -> str:
    """Return the colour of the badge that says how it ended."""
    return _ended(run)[1]


def _ended(run: "Run") -> tuple[Promise, str]:
    if run.ready and not sums(run):
        return NOTHING
    return SHORT.get(run.step, GOING_ON)


def sums(run: "Run") -> list[tuple[str, str]]:
    """Return what changes in numbers, each with the colour of its badge; empty for nothing."""
    told = [
        (_sum(kind, what, run.counts[kind][what]), MOODS[what])
        for kind in KINDS
        for what in MOODS
        if run.counts.get(kind, {}).get(what)
    ]
    come, gone = run.result.get("kept", (0, 0))
    if come:
        words = ngettext("%(n)s unknown statement kept", "%(n)s unknown statements kept", come)
        told.append((words % {"n": come}, ""))
    if gone:
        words = ngettext(
            "%(n)s unknown statement dropped", "%(n)s unknown statements dropped", gone
        )
        told.append((words % {"n": gone}, "warn"))
    return told


def _sum(kind: str, what: str, n: int) -> str:
    told = {
        "topics removed": ngettext("%(n)s topic removed", "%(n)s topics removed", n),
        "topics renamed": ngettext("%(n)s topic renamed", "%(n)s topics renamed", n),
        "topics changed": ngettext("%(n)s topic changed", "%(n)s topics changed", n),
        "topics added": ngettext("%(n)s topic added", "%(n)s topics added", n),
        "sentences removed": ngettext("%(n)s sentence removed", "%(n)s sentences removed", n),
        "sentences renamed": ngettext("%(n)s sentence renamed", "%(n)s sentences renamed", n),
        "sentences changed": ngettext("%(n)s sentence changed", "%(n)s sentences changed", n),
        "sentences added": ngettext("%(n)s sentence added", "%(n)s sentences added", n),
        "intents removed": ngettext("%(n)s intent removed", "%(n)s intents removed", n),
        "intents renamed": ngettext("%(n)s intent renamed", "%(n)s intents renamed", n),
        "intents changed": ngettext("%(n)s intent changed", "%(n)s intents changed", n),
        "intents added": ngettext("%(n)s intent added", "%(n)s intents added", n),
        "cultures removed": ngettext("%(n)s culture removed", "%(n)s cultures removed", n),
        "cultures changed": ngettext("%(n)s culture changed", "%(n)s cultures changed", n),
        "cultures added": ngettext("%(n)s culture added", "%(n)s cultures added", n),
    }
    other = ngettext("%(n)s other change", "%(n)s other changes", n)
    return told.get(f"{kind} {what}", other) % {"n": n}
