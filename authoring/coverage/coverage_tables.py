"""The numbers of the dashboard as tables; every number leads to the list of what it counts."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from urllib.parse import urlencode

from django.urls import reverse
from django.utils.functional import Promise
from django.utils.translation import gettext as _

from authoring.coverage.coverage import (
    GAPS,
    KEYWORDS,
    LINKS,
    NAMES,
    OWN,
    SENTENCES,
    STEPS,
    Coverage,
    Culture,
    Numbers,
)
from authoring.topic_page.words import KINDS, LANGUAGE_NAMES, in_own_language
from languages.known import LANGUAGES

Words = str | Promise


@dataclass(frozen=True, slots=True)
class Cell:
    """A number with the list it leads to; `share` is a percentage, `tone` "", zero or bad."""

    text: str
    url: str
    share: str = ""
    tone: str = ""


@dataclass(frozen=True, slots=True)
class Row:
    """A row of cells with its name."""

    name: str
    url: str
    cells: tuple[Cell, ...]


@dataclass(frozen=True, slots=True)
class Table:
    """A table: `groups` are heads over several columns as (words, number of columns)."""

    name: str
    title: Words
    first: Words
    groups: tuple[tuple[Words, int], ...]
    heads: tuple[Words, ...]
    rows: tuple[Row, ...]
    total: Row | None = None


class Lists:
    """The addresses of the lists of topics, sentences and intents, narrowed."""

    def __init__(self) -> None:
        self._topics = reverse("admin:dialogue_topic_changelist")
        self._frames = reverse("admin:dialogue_frame_changelist")
        self._intents = reverse("admin:plans_intent_changelist")

    def topics(self, row: Numbers, **wanted: object) -> str:
        """Return the list of topics of a branch (all for the total)."""
        return _address(self._topics, {"branch": row.key, **wanted})

    def frames(self, row: Numbers, **wanted: object) -> str:
        """Return the list of sentences of a branch (all of topics for the total)."""
        where = {"branch": row.key} if row.key else {"of": "topics"}
        return _address(self._frames, {**where, **wanted})

    def intents(self, family: str) -> str:
        """Return the list of intents of a family."""
        return _address(self._intents, {"family__exact": family})


def _address(path: str, wanted: dict[str, object]) -> str:
    query = urlencode({name: value for name, value in wanted.items() if value != ""})
    return f"{path}?{query}" if query else path


def called(row: Numbers) -> str:
    """Return the name of a branch in the person's language."""
    return in_own_language(row.names, row.key)


def _sorted(found: Coverage) -> list[Numbers]:
    return sorted(found.branches, key=lambda row: called(row).casefold())


def _count(number: int, url: str, *, wanted: bool = True) -> Cell:
    """Return a number of which more is better (`wanted`), or none is best."""
    tone = ("" if number else "zero") if wanted else ("bad" if number else "")
    return Cell(str(number), url, tone=tone)


def _share(number: int, total: int, url: str) -> Cell:
    percent = 100 * number // total if total else 0
    return Cell(str(number), url, f"{percent} %", "" if number else "zero")


def language_table(found: Coverage) -> Table:
    """Return branch × language: topics with a name, with own sentences, sentences."""
    lists = Lists()

    def cells(row: Numbers) -> Iterable[Cell]:
        yield _count(row.topics, lists.topics(row))
        for code in LANGUAGES:
            yield _share(row.named[code], row.topics, lists.topics(row, named=code))
            yield _share(row.speaking[code], row.topics, lists.topics(row, speaking=code))
            yield _count(row.sentences(code), lists.frames(row, said=code))

    heads = (_("with a name"), _("with own sentences"), _("sentences"))
    return Table(
        "languages",
        _("Topics and sentences by language"),
        _("Branch"),
        (("", 1), *((LANGUAGE_NAMES[code], 3) for code in LANGUAGES)),
        (_("topics"), *heads * len(LANGUAGES)),
        *_rows(found, cells),
    )


def kind_table(found: Coverage, language: str) -> Table:
    """Return branch × kind of sentence in one language."""
    lists = Lists()

    def cells(row: Numbers) -> Iterable[Cell]:
        for letter in KINDS:
            url = lists.frames(row, said=language, type__exact=letter)
            yield _count(row.said[language, letter], url)
        yield _count(row.sentences(language), lists.frames(row, said=language))

    return Table(
        "kinds",
        _("Kinds of sentence in %s") % LANGUAGE_NAMES[language],
        _("Branch"),
        (),
        (*(kind.name for kind in KINDS.values()), _("all")),
        *_rows(found, cells),
    )


def culture_table(found: Coverage) -> Table:
    """Return branch × culture: sentences for it only, topics at home there, mean likeliness."""
    lists = Lists()

    def cells(row: Numbers) -> Iterable[Cell]:
        for culture in found.cultures:
            number = culture.number
            yield _count(row.only[number], lists.frames(row, only__id__exact=number))
            yield _count(row.homes[number], lists.topics(row, home__id__exact=number))
            mean = row.mean_liking(number)
            yield Cell("–" if mean is None else f"{mean:.2f}", lists.topics(row))

    heads = (_("sentences for it only"), _("topics at home there"), _("mean likeliness"))
    return Table(
        "cultures",
        _("Cultures"),
        _("Branch"),
        tuple((culture_name(culture), 3) for culture in found.cultures),
        heads * len(found.cultures),
        *_rows(found, cells),
    )


def culture_name(culture: Culture) -> str:
    """Return the name of a culture in the person's language."""
    return in_own_language(culture.names, culture.code)


#: By column of what is missing: the head and the filter of the list that shows it.
_MISSING = {
    NAMES: {"named": "incomplete"},
    SENTENCES: {"said": "incomplete"},
    KEYWORDS: {"words": "incomplete"},
    OWN: {"own": "no"},
    LINKS: {"links": "no"},
    GAPS: {"gap": "any"},
}


def missing_words() -> dict[str, str]:
    """Return what each column of missing things is called."""
    return {
        NAMES: _("topics without a name in some language"),
        SENTENCES: _("sentences missing in some language"),
        KEYWORDS: _("topics without words that lead to them in some language"),
        OWN: _("topics without sentences of their own"),
        LINKS: _("topics that lead to no other"),
        GAPS: _("topics that lack a kind of sentence their order asks for"),
    }


def missing_url(lists: Lists, row: Numbers, column: str) -> str:
    """Return the list of what is missing in a branch."""
    narrowed = lists.frames if column == SENTENCES else lists.topics
    return narrowed(row, **_MISSING[column])


def missing_table(found: Coverage) -> Table:
    """Return branch × what is missing."""
    lists = Lists()

    def cells(row: Numbers) -> Iterable[Cell]:
        for column in _MISSING:
            url = missing_url(lists, row, column)
            # Topics may well live on what they inherit: no fault of theirs.
            fault = column not in (OWN, LINKS)
            number = row.missing[column]
            yield _count(number, url, wanted=False) if fault else Cell(str(number), url)

    heads = tuple(missing_words().values())
    return Table("missing", _("What is missing"), _("Branch"), (), heads, *_rows(found, cells))


def _rows(found: Coverage, cells: object) -> tuple[tuple[Row, ...], Row]:
    tree = reverse("admin:tree")
    rows = tuple(
        Row(called(row), _address(tree, {"open": row.key}), tuple(cells(row)))  # type: ignore[operator]
        for row in _sorted(found)
    )
    return rows, Row(_("All branches"), tree, tuple(cells(found.total)))  # type: ignore[operator]


def liking_table(found: Coverage) -> Table:
    """Return step of likeliness × culture: how many topics."""
    lists, everything = Lists(), Numbers()
    rows = []
    for step in range(STEPS):
        counts = [found.topics_liking(one.number, step) for one in found.cultures]
        urls = [lists.topics(everything, liking=f"{one.code}-{step}") for one in found.cultures]
        rows.append(Row(step_name(step), "", tuple(map(_plain, counts, urls))))
    heads = tuple(culture_name(culture) for culture in found.cultures)
    title = _("Topics by likeliness")
    return Table("liking", title, _("Likeliness"), (), heads, tuple(rows))


def step_name(step: int) -> str:
    """Return a step of likeliness in figures."""
    return f"{step / STEPS:.1f}–{(step + 1) / STEPS:.1f}"


def depth_table(found: Coverage) -> Table:
    """Return depth × topics."""
    lists, everything = Lists(), Numbers()
    rows = tuple(
        Row(str(depth), "", (_plain(count, lists.topics(everything, depth=depth)),))
        for depth, count in sorted(found.depths.items())
    )
    heads = (_("topics"),)
    return Table("depth", _("Depth of the tree"), _("Steps below the root"), (), heads, rows)


def family_table(found: Coverage) -> Table:
    """Return family of intents × intents and triggers by language."""
    lists = Lists()
    rows = []
    for family in found.families:
        counts: Sequence[int] = (family.intents, *family.triggers.values())
        url = lists.intents(family.name)
        name = family.name or _("(no family)")
        rows.append(Row(name, url, tuple(_count(count, url) for count in counts)))
    words = _("ways to say it: %s")
    heads = (_("intents"), *(words % LANGUAGE_NAMES[code] for code in LANGUAGES))
    return Table("families", _("Intents by family"), _("Family"), (), heads, tuple(rows))


def _plain(count: int, url: str) -> Cell:
    return Cell(str(count), url)
