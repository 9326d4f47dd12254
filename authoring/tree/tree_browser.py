"""The nodes that the tree browser shows: read for many topics at once, in a few queries."""

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass

from django.db.models import Count, FloatField, Q
from django.db.models.functions import Cast
from django.utils.functional import Promise
from django.utils.translation import gettext as _

from authoring.checks.findings import findings_for, last_check
from authoring.topic_page.shape import Shape
from authoring.topic_page.words import LANGUAGE_NAMES, in_own_language, liking, own_language
from dialogue.models import Frame, Sentence, Topic, TopicInstance, TopicName
from languages.known import LANGUAGES


@dataclass(frozen=True, slots=True)
class Hint:
    """The likeliness of a topic in one culture, from 0 to 1; `percent` for a small bar."""

    code: str
    culture: str
    value: float
    words: str | Promise

    @property
    def percent(self) -> int:
        """Return it out of a hundred."""
        return round(self.value * 100)


@dataclass(frozen=True, slots=True)
class Badge:
    """A word beside a topic: `kind` good, warn, bad or plain."""

    kind: str
    words: str


@dataclass(frozen=True, slots=True)
class TreeNode:
    """A topic as the browser shows it. `below` counts all topics below, `children` the nearest.

    `own` counts its own sentences; `opened` holds the children's nodes where they are shown,
    None where they are loaded on opening.
    """

    number: int
    key: str
    name: str
    own: int
    below: int
    children: int
    likeliness: tuple[Hint, ...]
    badges: tuple[Badge, ...]
    place: int = 1
    size: int = 1
    level: int = 1
    opened: tuple["TreeNode", ...] | None = None

    @property
    def width(self) -> int:
        """Return the width of the small picture of likeliness; its height is 100."""
        return 10 * len(self.likeliness)

    @property
    def full(self) -> str:
        """Return the grounds of its bars, as the path of an SVG."""
        return "".join(f"M{10 * place} 0v100h7v-100z" for place in range(len(self.likeliness)))

    @property
    def bars(self) -> str:
        """Return its bars, as the path of an SVG."""
        hints = enumerate(self.likeliness)
        return "".join(
            f"M{10 * place} 100v-{hint.percent}h7v{hint.percent}z" for place, hint in hints
        )


def children_of(shape: Shape, number: int | None, open_: Collection[int] = ()) -> list[TreeNode]:
    """Return the nodes below a topic (None: the branches), with those below `open_` ones.

    Five queries, whatever the number of nodes.
    """
    wanted = list(shape.children.get(number, ()))
    for place in open_:
        wanted += shape.children.get(place, ())
    read = _Nodes(shape, wanted)
    level = 1 if number is None else len(shape.above(number)) + 2
    return read.level(number, level, frozenset(open_))


_NOTHING = (0, 0)


class _Nodes:
    """Everything about some topics that their nodes show."""

    def __init__(self, shape: Shape, numbers: Collection[int]) -> None:
        self.shape = shape
        self.rows = Topic.objects.select_related("home").in_bulk(list(numbers))
        self.names = _names(numbers)
        self.said = _said(numbers)
        self.liking = _liking(numbers)
        checked = last_check()
        keys = [row.key for row in self.rows.values()]
        self.found = findings_for(keys, checked) if checked else {}

    def level(self, number: int | None, level: int, open_: frozenset[int]) -> list[TreeNode]:
        below = [one for one in self.shape.children.get(number, ()) if one in self.rows]
        return [
            self.node(one, place, len(below), level, open_)
            for place, one in enumerate(below, start=1)
        ]

    def node(
        self, number: int, place: int, size: int, level: int, open_: frozenset[int]
    ) -> TreeNode:
        row, names = self.rows[number], self.names.get(number, {})
        children = self.shape.children.get(number, ())
        opened = None
        if children and number in open_:
            opened = tuple(self.level(number, level + 1, open_))
        return TreeNode(
            number=number,
            key=row.key,
            name=names.get(own_language()) or row.key,
            own=self.said.get(number, _NOTHING)[0],
            below=len(self.shape.below(number)),
            children=len(children),
            likeliness=self.liking.get(number, ()),
            badges=tuple(self.badges(row, names)),
            place=place,
            size=size,
            level=level,
            opened=opened,
        )

    def badges(self, row: Topic, names: Mapping[str, str]) -> Iterable[Badge]:
        for code, language in LANGUAGE_NAMES.items():
            if code not in names:
                yield Badge("bad", _("no name in %s") % language)
        frames, texts = self.said.get(row.pk, _NOTHING)
        silent = frames * len(LANGUAGES) - texts
        if silent > 0:
            yield Badge("bad", _("translations missing: %d") % silent)
        found = self.found.get(row.key, [])
        blocking = sum(one.blocks for one in found)
        if blocking:
            yield Badge("bad", _("%d to correct") % blocking)
        if len(found) > blocking:
            yield Badge("warn", _("%d to look at") % (len(found) - blocking))
        if row.gentle:
            yield Badge("plain", _("gentle"))
        if row.home:
            yield Badge("plain", in_own_language(row.home.names, row.home.code))


def _names(numbers: Collection[int]) -> dict[int, dict[str, str]]:
    found: dict[int, dict[str, str]] = {}
    rows = TopicName.objects.filter(topic__in=numbers).values_list("topic_id", "language", "name")
    for number, language, name in rows:
        found.setdefault(number, {})[language] = name
    return found


def _said(numbers: Collection[int]) -> dict[int, tuple[int, int]]:
    """Return by topic how many sentences it has, and how many texts in all languages together."""
    known = Q(sentences__language__in=LANGUAGES)
    rows = Frame.objects.filter(topic__in=numbers).order_by().values_list("topic")
    counted = rows.annotate(
        frames=Count("pk", distinct=True), texts=Count("sentences", filter=known)
    )
    return {number: (frames, texts) for number, frames, texts in counted}


def _liking(numbers: Collection[int]) -> dict[int, tuple[Hint, ...]]:
    rows = (
        TopicInstance.objects.filter(topic__in=numbers)
        .annotate(value=Cast("likeliness", FloatField()))
        .order_by("culture__position", "culture")
        .values_list("topic_id", "culture__code", "culture__names", "value")
    )
    found: dict[int, tuple[Hint, ...]] = {}
    for number, code, names, value in rows:
        hint = Hint(code, in_own_language(names, code), value, liking(value))
        found[number] = (*found.get(number, ()), hint)
    return found


@dataclass(frozen=True, slots=True)
class Summary:
    """What the side panel tells about the selected topic.

    `names` and `sentences` are pairs of words and text; `own_kinds` kind and count.
    """

    node: TreeNode
    names: tuple[tuple[str, str], ...]
    own_kinds: tuple[tuple[str, int], ...]
    sentences: tuple[str, ...]
    links: tuple[tuple[str, str], ...]
    note: str


MOST_SENTENCES = 4
MOST_LINKS = 12


def summary(shape: Shape, number: int) -> Summary:
    """Return the summary of one topic; eight queries."""
    read = _Nodes(shape, (number,))
    names = read.names.get(number, {})
    kinds = Frame.objects.filter(topic=number).order_by("type").values_list("type")
    texts = Sentence.objects.filter(frame__topic=number, language=own_language())
    spoken = texts.order_by("frame__position", "frame").values_list("text", flat=True)
    links = Topic.objects.filter(linked_from__topic=number).order_by("linked_from__position")
    called = dict(
        TopicName.objects.filter(topic__linked_from__topic=number, language=own_language())
        .order_by()
        .values_list("topic_id", "name")
    )
    return Summary(
        node=read.node(number, 1, 1, 1, frozenset()),
        names=tuple((str(words), names.get(code, "")) for code, words in LANGUAGE_NAMES.items()),
        own_kinds=tuple(kinds.annotate(count=Count("pk")).values_list("type", "count")),
        sentences=tuple(spoken[:MOST_SENTENCES]),
        links=tuple(
            (key, called.get(pk) or key) for pk, key in links.values_list("pk", "key")[:MOST_LINKS]
        ),
        note=read.rows[number].note,
    )
