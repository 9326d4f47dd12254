"""What stands on the start page: how things are, what to do first, what I wrote last."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from django.urls import NoReverseMatch, reverse
from django.utils.translation import gettext as _
from django.utils.translation import ngettext

from authoring.checks.findings import Checked, last_check
from authoring.coverage.coverage import GAPS, KEYWORDS, NAMES, SENTENCES, Coverage, coverage
from authoring.coverage.coverage_tables import Lists, missing_url, missing_words
from authoring.history.history import Change, Wanted, changes, count
from authoring.roles import PUBLISH
from authoring.topic_page.words import LANGUAGE_NAMES
from dialogue.draft import draft_version
from dialogue.models import Publication
from languages.known import LANGUAGES

#: What is worth doing something about, the most urgent first.
_FAULTS = (NAMES, SENTENCES, KEYWORDS, GAPS)
MOST_CHANGES = 5


@dataclass(frozen=True, slots=True)
class Step:
    """Something to do next, with the page for it; `tone` bad, warn or good."""

    words: str
    url: str
    tone: str = "warn"


@dataclass(frozen=True, slots=True)
class Figure:
    """A number with what it counts and where it leads."""

    number: int
    words: str
    url: str


@dataclass(frozen=True, slots=True)
class StartPage:
    """All of it. `mine` counts this person's changes since the last release."""

    figures: tuple[Figure, ...]
    steps: tuple[Step, ...]
    mine: int
    latest: tuple[Change, ...]
    released: Any


def start_page(user: Any) -> StartPage:
    """Return what a person finds who may see the content; about six queries when warm."""
    found = coverage()
    released = Publication.objects.order_by("-pk").values("pk", "created", "note").first()
    since = released["created"] if released else None
    mine, latest = Wanted(person=user.pk, since=since), []
    number = count(mine)
    if number:
        latest = changes(mine, 0, MOST_CHANGES)
    return StartPage(
        figures=tuple(_figures(found)),
        steps=tuple(_steps(found, user)),
        mine=number,
        latest=tuple(latest),
        released=released,
    )


def page_url(name: str) -> str:
    """Return the address of a page of the admin, "" where there is none of that name."""
    try:
        return reverse(f"admin:{name}")
    except NoReverseMatch:
        return ""


def _figures(found: Coverage) -> Iterator[Figure]:
    lists, total = Lists(), found.total
    yield Figure(total.topics, ngettext("topic", "topics", total.topics), lists.topics(total))
    for code in LANGUAGES:
        words = _("sentences in %s") % LANGUAGE_NAMES[code]
        yield Figure(total.sentences(code), words, lists.frames(total, said=code))
    intents = sum(family.intents for family in found.families)
    yield Figure(
        intents, ngettext("intent", "intents", intents), page_url("plans_intent_changelist")
    )


def _steps(found: Coverage, user: Any) -> Iterator[Step]:
    checked, version = last_check(), draft_version()
    yield from _checks(checked, version)
    lists, words = Lists(), missing_words()
    for column in _FAULTS:
        number = found.total.missing[column]
        if number:
            yield Step(
                f"{words[column][0].upper()}{words[column][1:]}: {number}",
                missing_url(lists, found.total, column),
            )
    if not found.total.topics:
        yield Step(_("Add the first topic"), page_url("dialogue_topic_add"))
    if user.has_perm(f"dialogue.{PUBLISH}") and (url := page_url("publish")):
        yield Step(_("Look at what has changed, and publish it"), url, "good")


def _checks(checked: Checked | None, version: int) -> Iterator[Step]:
    url = page_url("checks")
    if not url:
        return
    if checked is None:
        yield Step(_("Check the draft for the first time"), url)
        return
    if checked.errors:
        words = ngettext(
            "%(number)d fault stops publishing", "%(number)d faults stop publishing", checked.errors
        )
        yield Step(words % {"number": checked.errors}, url, "bad")
    if version > checked.draft:
        yield Step(_("Check again what has changed since the last check"), url)
