"""Where rows stand in the tree: the filter by branch, and an order in which people look."""

from collections.abc import Iterable, Iterator

from django.utils.translation import gettext as _

from authoring.sheets.columns import Choice
from authoring.topic_page.neighbours import names_of
from authoring.topic_page.shape import Shape, read_shape
from languages.known import LANGUAGES

EVERYTHING = ""


def branch_choices() -> Iterator[Choice]:
    """Yield the branches by name, after "everything"."""
    shape = read_shape()
    called = names_of(shape, shape.branches)
    yield Choice(EVERYTHING, _("All branches"))
    for number in shape.branches:
        yield Choice(shape.keys[number], f"{called[number]} ({shape.keys[number]})")


def language_choices() -> Iterator[Choice]:
    """Yield the languages, after "everything"."""
    yield Choice(EVERYTHING, _("All languages"))
    for code, language in LANGUAGES.items():
        yield Choice(code, language.own_name)


def numbers_of(shape: Shape, branch: str) -> tuple[int, ...]:
    """Return the topics of a branch in the order of the tree; all for ""; none for no branch."""
    if branch == EVERYTHING:
        return tuple(in_order(shape, shape.branches))
    tops = [number for number, key in shape.keys.items() if key == branch]
    return tuple(in_order(shape, tops))


def in_order(shape: Shape, tops: Iterable[int]) -> Iterator[int]:
    """Yield topics with all below them, each before those below it."""
    waiting, seen = [*tops][::-1], set()
    while waiting:
        number = waiting.pop()
        if number not in seen:
            seen.add(number)
            yield number
            waiting += shape.children.get(number, ())[::-1]
