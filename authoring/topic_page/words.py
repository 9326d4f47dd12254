"""What the pages call things: kinds of sentence, languages, cultures, likeliness."""

from collections.abc import Mapping
from typing import NamedTuple

from django.utils.functional import Promise
from django.utils.translation import get_language
from django.utils.translation import gettext_lazy as _

from languages.known import LANGUAGES


class Kind(NamedTuple):
    """One kind of sentence in an expert's words; `letter` is the one of patterns."""

    letter: str
    name: str | Promise
    told: str | Promise
    example: str


KINDS: Mapping[str, Kind] = {
    kind.letter: kind
    for kind in (
        Kind("q", _("yes/no question"), _("Opens the subject."), "Do you like $hasName?"),
        Kind("p", _("after a yes"), _("Said when the person agrees."), "Lovely choice."),
        Kind("n", _("after a no"), _("Said when the person disagrees."), "That is fine."),
        Kind("w", _("open question"), _("Lets the person talk."), "What do you like about it?"),
        Kind("c", _("remark"), _("Tells something, asks nothing."), "Many people love it."),
        Kind(
            "g", _("proposal"), _("Offers to do something."), "Shall I play a song about $hasName?"
        ),
        Kind("t", _("transition"), _("Leads to another topic."), "From $hasName to $toName."),
        Kind("e", _("hands over"), _("Lets the person lead."), "What would you like to tell me?"),
    )
}

LANGUAGE_NAMES: Mapping[str, str | Promise] = {
    "en": _("English"),
    "it": _("Italian"),
    "ja": _("Japanese"),
}

SCOPES: Mapping[str, str | Promise] = {
    "": _("this topic and everything below it"),
    "self": _("this topic only"),
    "below": _("only what is below this topic"),
}

_STEPS: tuple[tuple[float, str | Promise], ...] = (
    (0.15, _("dislikes it")),
    (0.35, _("does not care much for it")),
    (0.6, _("may like it or not")),
    (0.8, _("likes it")),
    (1.01, _("loves it")),
)


def liking(likeliness: float) -> str | Promise:
    """Return a likeliness in words; nothing for a number outside 0 to 1."""
    if not 0 <= likeliness <= 1:
        return ""
    return next(words for most, words in _STEPS if likeliness < most)


def liking_steps() -> list[dict[str, object]]:
    """Return the words with the likeliness they end below, for the page's script."""
    return [{"below": most, "words": str(words)} for most, words in _STEPS]


def own_language() -> str:
    """Return the language of the person at the page, as far as the robot speaks it."""
    code = (get_language() or "en").partition("-")[0]
    return code if code in LANGUAGES else "en"


def in_own_language(texts: Mapping[str, str], otherwise: str = "") -> str:
    """Return the text in the person's own language, else in English, else what is given."""
    return texts.get(own_language()) or texts.get("en") or otherwise
