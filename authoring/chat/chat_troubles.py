"""What can go wrong in the test chat, in plain words with links to what must be mended."""

from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import NoReturn

import msgspec
from django.core.exceptions import ValidationError
from django.http import JsonResponse
from django.urls import reverse
from django.utils.functional import Promise
from django.utils.translation import gettext as _
from django.utils.translation import gettext_lazy, ngettext

from authoring.chat.chat_contents import UnknownContentError
from authoring.chat.replaying import UnknownTopicError
from dialogue.engine.codec import StateError
from dialogue.engine.findings import Finding
from dialogue.models import Frame, Topic
from dialogue.publishing import NothingPublishedError, NotPublishableError
from dialogue.snapshot import SnapshotError
from dialogue.turns import UnknownChoiceError
from plans.models import Intent

Json = dict[str, object]
#: So many findings are looked at, so many rows to mend are shown.
MOST_READ, MOST_FINDINGS = 2000, 50


class TroubleError(Exception):
    """A refusal: its HTTP status, a code for the page, a sentence."""

    def __init__(self, status: int, code: str, message: str) -> None:
        super().__init__(message)
        self.status, self.code, self.message = status, code, message


@dataclass(frozen=True, slots=True)
class _Words:
    status: int
    code: str
    message: str | Promise


_KNOWN: tuple[tuple[type[Exception], _Words], ...] = (
    (
        NothingPublishedError,
        _Words(503, "unpublished", gettext_lazy("Nothing is published yet. Choose the draft.")),
    ),
    (
        SnapshotError,
        _Words(
            409,
            "damaged",
            gettext_lazy("This release is damaged. Choose another one or the draft."),
        ),
    ),
    (
        UnknownContentError,
        _Words(400, "content", gettext_lazy("There is no such release. Choose another one.")),
    ),
    (
        UnknownTopicError,
        _Words(
            400,
            "topic",
            gettext_lazy("There is no such topic to begin with. Write its name in the ontology."),
        ),
    ),
    (
        UnknownChoiceError,
        _Words(
            400, "choice", gettext_lazy("There is no such language or culture. Choose another one.")
        ),
    ),
    (
        StateError,
        _Words(400, "state", gettext_lazy("The talk cannot go on from here. Begin it again.")),
    ),
    (
        msgspec.DecodeError,
        _Words(
            400,
            "message",
            gettext_lazy("What the page sent cannot be read. Load the page again and begin anew."),
        ),
    ),
    (
        RecursionError,
        _Words(
            400,
            "message",
            gettext_lazy("What the page sent cannot be read. Load the page again and begin anew."),
        ),
    ),
)


def answered(work: Callable[[], Json]) -> JsonResponse:
    """Return the answer of some work, or what went wrong; what is no known trouble is raised."""
    try:
        return JsonResponse(work())
    except NotPublishableError as error:
        return JsonResponse({"error": _unbuilt(error.findings)}, status=409)
    except ValidationError as error:
        return _refused(400, "invalid", " ".join(error.messages))
    except TroubleError as error:
        return _refused(error.status, error.code, error.message)
    except tuple(kind for kind, _words in _KNOWN) as error:
        words = next(words for kind, words in _KNOWN if isinstance(error, kind))
        return _refused(words.status, words.code, str(words.message))


def refuse(status: int, code: str, message: str) -> NoReturn:
    """Raise a refusal."""
    raise TroubleError(status, code, message)


def _refused(status: int, code: str, message: str) -> JsonResponse:
    return JsonResponse({"error": {"code": code, "message": message}}, status=status)


def _unbuilt(findings: list[Finding]) -> Json:
    return {
        "code": "draft",
        "message": _("The draft cannot be tried yet: these errors must be mended first."),
        "findings": findings_json(findings),
    }


def findings_json(findings: Iterable[Finding]) -> list[Json]:
    """Return what must be mended, one a row to edit, with its address; three queries.

    `more` says of how many further topics the same is found: one sentence is heard below many.
    """
    read = list(findings)[:MOST_READ]
    urls = _addresses({key for one in read for key in _keys(one)})
    rows: dict[str, Json] = {}
    alike: Counter[str] = Counter()
    for one in read:
        key = next((key for key in _keys(one) if key in urls), one.where)
        place = f"{one.code} {key}"
        words = {"where": key, "message": one.message, "hint": one.hint}
        rows.setdefault(place, {**words, "url": urls.get(key, "")})
        alike[place] += 1
    shown = list(rows.items())[:MOST_FINDINGS]
    return [{**row, "more": _more(alike[place] - 1)} for place, row in shown]


def _more(count: int) -> str:
    if not count:
        return ""
    words = ngettext("And %(n)s more like it.", "And %(n)s more like it.", count)
    return words % {"n": count}


def _keys(finding: Finding) -> tuple[str, ...]:
    """Return the keys a finding may be about, the nearest first: GreenTea.q1, GreenTea.

    What cannot be said of a topic begins with the sentence that cannot.
    """
    said, word = finding.message.partition(" ")[0], finding.where.partition(" ")[0]
    sentence = (said,) if "." in said[:-1] else ()
    return (*sentence, finding.where, word, word.partition(".")[0])


def _addresses(keys: set[str]) -> dict[str, str]:
    rows = (
        ("plans_intent", Intent.objects.filter(key__in=keys)),
        ("dialogue_topic", Topic.objects.filter(key__in=keys)),
        ("dialogue_frame", Frame.objects.filter(key__in=keys)),
    )
    return {
        key: reverse(f"admin:{name}_change", args=[number])
        for name, found in rows
        for key, number in found.values_list("key", "pk")
    }
