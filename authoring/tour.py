"""The quick tour: small steps that point at places of the menu, one sentence each."""

from collections.abc import Container
from dataclasses import dataclass

from django.urls import reverse
from django.utils.functional import Promise
from django.utils.translation import gettext_lazy as _


@dataclass(frozen=True, slots=True)
class Step:
    """A step: its title, what it says, and the address in the menu that it points at ("": none)."""

    title: str | Promise
    words: str | Promise
    url: str = ""


#: The name of a page in the menu ("" for none), the title and the sentence of its step.
_STEPS: tuple[tuple[str, str | Promise, str | Promise], ...] = (
    (
        "",
        _("Welcome!"),
        _("Here you decide what the robot says. This short tour shows where things are."),
    ),
    (
        "tree",
        _("Find a topic"),
        _("Search the tree for a word such as tea, open the topic, and see what the robot says."),
    ),
    (
        "chat",
        _("Try it"),
        _("Talk with what you have just written, and open “Why this reply?” below any answer."),
    ),
    (
        "checks",
        _("Let it be checked"),
        _("See what is missing or wrong, with a link to the place where it can be mended."),
    ),
    (
        "publish",
        _("Publish"),
        _("Nothing you write reaches a robot before somebody has published it on this page."),
    ),
    (
        "releases",
        _("Take it back"),
        _("Every release is kept: if something went wrong, go back to an earlier one."),
    ),
)


def tour_steps(menu: Container[str]) -> list[Step]:
    """Return the steps for somebody whose menu holds these addresses, none for an empty menu."""
    steps = [
        Step(title, words, reverse(f"admin:{name}") if name else "")
        for name, title, words in _STEPS
    ]
    shown = [step for step in steps if not step.url or step.url in menu]
    return shown if any(step.url for step in shown) else []
