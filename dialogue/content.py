"""Read the rows of the Dialogue Manager into plain values (a fixed number of queries)."""

from collections import defaultdict
from collections.abc import Collection, Iterable, Mapping
from typing import TypeVar

from django.db.models import Model, QuerySet

from dialogue import models
from dialogue.engine import concepts
from dialogue.engine.tree_order import in_tree_order
from languages.known import LANGUAGES

ByTopic = dict[int, list[concepts.Frame]]
RowT = TypeVar("RowT", bound=Model)


def read_knowledge() -> concepts.Knowledge:
    """Return the whole draft: cultures, topics in tree order, pools."""
    rows = {row.pk: row for row in models.Topic.objects.all()}
    keys = {number: row.key for number, row in rows.items()}
    return _knowledge(rows.values(), keys, None)


def read_part(
    numbers: Collection[int], keys: Mapping[int, str], *, frames: bool = True
) -> concepts.Knowledge:
    """Return the topics of these numbers with what the agent says about them; no pools.

    `keys` are the keys of all topics, for links lead anywhere. Left out are keywords; likeliness
    is the usual one. `frames=False` leaves out the sentences too.
    """
    rows = models.Topic.objects.filter(pk__in=numbers)
    return _knowledge(rows, keys, numbers, frames=frames)


def _knowledge(
    rows: Iterable[models.Topic],
    keys: Mapping[int, str],
    numbers: Collection[int] | None,
    *,
    frames: bool = True,
) -> concepts.Knowledge:
    cultures = tuple(models.Culture.objects.all())
    codes = {row.pk: row.code for row in cultures}
    said, pools = _frames(codes, numbers) if frames else (defaultdict(list), {})
    parts = _Parts(codes, keys, numbers)
    topics = in_tree_order(_topic(row, parts, said, codes) for row in rows)
    return concepts.Knowledge(
        cultures=tuple(
            concepts.Culture(code=row.code, names=row.names, language=row.language)
            for row in cultures
        ),
        topics=topics,
        pools=pools,
    )


class _Parts:
    """The rows below each topic, by topic number."""

    def __init__(
        self, codes: Mapping[int, str], keys: Mapping[int, str], numbers: Collection[int] | None
    ) -> None:
        self.keys = keys
        self.names: dict[int, dict[str, dict[str, str]]] = defaultdict(dict)
        names = _of(models.TopicName.objects.all(), numbers)
        for topic, language, name, fields in names.values_list(
            "topic_id", "language", "name", "fields"
        ):
            self.names[topic][language] = {"name": name, **fields}
        self.variables: dict[int, dict[str, dict[str, str]]] = defaultdict(dict)
        for variable in _of(models.Variable.objects.order_by("id"), numbers):
            texts = self.variables[variable.topic_id].setdefault(variable.language, {})
            texts[variable.name] = variable.text
        self.see: dict[int, list[str]] = defaultdict(list)
        for link in _of(models.TopicLink.objects.all(), numbers):
            self.see[link.topic_id].append(keys[link.target_id])
        self.also: dict[int, list[str]] = defaultdict(list)
        lent_from = models.Topic.also.through.objects.order_by("id")
        for lent in _of(lent_from, numbers, "from_topic"):
            self.also[lent.from_topic_id].append(keys[lent.to_topic_id])
        self.keywords: dict[int, dict[str, tuple[tuple[str, ...], tuple[str, ...]]]]
        self.keywords = defaultdict(dict)
        self.likeliness: dict[int, dict[str, float]] = defaultdict(dict)
        self.individuals: dict[int, dict[str, str]] = defaultdict(dict)
        if numbers is None:
            self._read_what_leads_here(codes)

    def _read_what_leads_here(self, codes: Mapping[int, str]) -> None:
        sets = models.KeywordSet.objects.values_list("topic_id", "language", "first", "second")
        for topic, language, first, second in sets:
            self.keywords[topic][language] = (_words(first), _words(second))
        instances = models.TopicInstance.objects.order_by("culture__position")
        for topic, culture, likeliness, name in instances.values_list(
            "topic_id", "culture_id", "likeliness", "name"
        ):
            self.likeliness[topic][codes[culture]] = float(likeliness)
            if name:
                self.individuals[topic][codes[culture]] = name


def _of(
    rows: QuerySet[RowT], numbers: Collection[int] | None, path: str = "topic"
) -> QuerySet[RowT]:
    """Return the rows of all topics (None), or of those with these numbers."""
    return rows if numbers is None else rows.filter(**{f"{path}__in": numbers})


def _words(text: str) -> tuple[str, ...]:
    return tuple(word.strip() for word in text.split("|") if word.strip())


def _in_order(texts: Mapping[str, object]) -> list[str]:
    return [code for code in LANGUAGES if code in texts]


def _topic(
    row: models.Topic, parts: _Parts, frames: ByTopic, codes: Mapping[int, str]
) -> concepts.Topic:
    number = row.pk
    home = codes[row.home_id] if row.home_id else ""
    names, variables = parts.names[number], parts.variables[number]
    keywords = parts.keywords[number]
    return concepts.Topic(
        number=number,
        key=row.key,
        is_a=parts.keys[row.parent_id] if row.parent_id else concepts.ROOT,
        also=tuple(parts.also[number]),
        of=home,
        gentle=row.gentle,
        stop=row.stop,
        pattern=tuple(part.strip() for part in row.pattern.split(" | ")) if row.pattern else (),
        variables={code: variables[code] for code in _in_order(variables)},
        names={code: names[code] for code in _in_order(names)},
        keywords={code: keywords[code] for code in _in_order(keywords)},
        # A culture without an individual of its own, e.g. a new one, starts with what is usual.
        likeliness=concepts.usual_likeliness(home, tuple(codes.values()))
        | parts.likeliness[number],
        individuals=dict(parts.individuals[number]),
        see=tuple(parts.see[number]),
        note=row.note,
        frames=tuple(frames[number]),
    )


def _frames(
    codes: Mapping[int, str], numbers: Collection[int] | None
) -> tuple[ByTopic, dict[str, tuple[concepts.Frame, ...]]]:
    """Return the frames of topics by topic number, and those of pools by pool."""
    texts: dict[int, dict[str, str]] = defaultdict(dict)
    # Plain values where rows are many: an instance of a model costs several times as much.
    said = _of(models.Sentence.objects.all(), numbers, "frame__topic")
    for number, language, text in said.values_list("frame_id", "language", "text"):
        texts[number][language] = text
    only: dict[int, list[str]] = defaultdict(list)
    for row in _of(models.Frame.only.through.objects.order_by("id"), numbers, "frame__topic"):
        only[row.frame_id].append(codes[row.culture_id])
    topics: ByTopic = defaultdict(list)
    pools: dict[str, list[concepts.Frame]] = defaultdict(list)
    for frame in _of(models.Frame.objects.all(), numbers):
        value = _frame(frame, texts[frame.pk], only[frame.pk])
        if frame.topic_id is None:
            pools[frame.pool].append(value)
        else:
            topics[frame.topic_id].append(value)
    return topics, {name: tuple(frames) for name, frames in pools.items()}


def _frame(row: models.Frame, texts: Mapping[str, str], only: Iterable[str]) -> concepts.Frame:
    return concepts.Frame(
        number=row.pk,
        key=row.key,
        type=row.type or row.pool,
        texts={code: texts[code] for code in _in_order(texts)},
        slot=row.slot,
        only=tuple(only),
        scope=row.scope,
        do=row.do,
    )
