"""How far the draft covers languages, cultures and kinds of sentence: numbers by branch."""

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from django.db.models import Count, FloatField
from django.db.models.functions import Cast

from authoring.by_draft import ByDraft
from authoring.coverage.coverage_gaps import Talker, gaps
from authoring.topic_page.shape import Shape, read_shape
from dialogue import models
from dialogue.garbage import collected_later
from languages.known import LANGUAGES
from plans.models import Intent, Trigger

#: What may be missing, by the names of columns.
NAMES, SENTENCES, KEYWORDS, OWN, LINKS, GAPS = (
    "names",
    "sentences",
    "keywords",
    "own",
    "links",
    "gaps",
)
MISSING = (NAMES, SENTENCES, KEYWORDS, OWN, LINKS, GAPS)
#: Likeliness is counted in ten steps of 0.1; 1 belongs to the last one.
STEPS = 10


@dataclass(slots=True)
class Numbers:
    """The numbers of one branch, or of all. Cultures are named by their row numbers.

    `named` and `speaking` count topics a language; `said` sentences by (language, kind);
    `only` sentences for one culture; `homes` topics at home there; `liking` holds the sum and
    the count of likeliness; `missing` counts topics (SENTENCES: sentences) by column.
    """

    key: str = ""
    names: Mapping[str, str] = field(default_factory=dict)
    topics: int = 0
    named: Counter[str] = field(default_factory=Counter)
    speaking: Counter[str] = field(default_factory=Counter)
    said: Counter[tuple[str, str]] = field(default_factory=Counter)
    only: Counter[int] = field(default_factory=Counter)
    homes: Counter[int] = field(default_factory=Counter)
    liking_sum: dict[int, float] = field(default_factory=dict)
    liking_count: Counter[int] = field(default_factory=Counter)
    missing: Counter[str] = field(default_factory=Counter)

    def add(self, row: "Numbers") -> None:
        """Add the numbers of another branch."""
        self.topics += row.topics
        self.named.update(row.named)
        self.speaking.update(row.speaking)
        self.said.update(row.said)
        self.only.update(row.only)
        self.homes.update(row.homes)
        self.liking_count.update(row.liking_count)
        self.missing.update(row.missing)
        for culture, value in row.liking_sum.items():
            self.liking_sum[culture] = self.liking_sum.get(culture, 0.0) + value

    def sentences(self, language: str) -> int:
        """Return how many sentences are said in a language."""
        return sum(count for (code, _kind), count in self.said.items() if code == language)

    def mean_liking(self, culture: int) -> float | None:
        """Return the mean likeliness in a culture, None where there is none."""
        count = self.liking_count[culture]
        return self.liking_sum[culture] / count if count else None


@dataclass(frozen=True, slots=True)
class Culture:
    """A culture as columns name it."""

    number: int
    code: str
    names: Mapping[str, str]


@dataclass(frozen=True, slots=True)
class Family:
    """A family of intents: how many, and their triggers by language."""

    name: str
    intents: int
    triggers: Mapping[str, int]


@dataclass(frozen=True, slots=True)
class Coverage:
    """All numbers. `liking` counts topics by culture and step of 0.1; `depths` by depth from 1.

    `gaps` names the kinds that a topic's pattern asks for and nothing provides, by its number.
    """

    branches: tuple[Numbers, ...]
    total: Numbers
    cultures: tuple[Culture, ...]
    liking: Mapping[int, Counter[int]]
    depths: Mapping[int, int]
    families: tuple[Family, ...]
    gaps: Mapping[int, frozenset[str]]

    def topics_liking(self, culture: int, step: int) -> int:
        """Return how many topics have a likeliness of this step in a culture."""
        return self.liking[culture][step] if culture in self.liking else 0


@collected_later()
def read_coverage() -> Coverage:
    """Count the draft as it is; about sixteen queries."""
    return _Count(read_shape()).coverage()


coverage: ByDraft[Coverage] = ByDraft(read_coverage)


def step_of(likeliness: float) -> int:
    """Return the step from 0 to 9 that a likeliness belongs to."""
    return min(int(likeliness * STEPS + 1e-6), STEPS - 1)


class _Count:
    """Adds up rows by the branch of their topic."""

    def __init__(self, shape: Shape) -> None:
        self.shape = shape
        self.rows: dict[int, Numbers] = {}
        self.total = Numbers()
        self.branch: dict[int, Numbers] = {}
        self.liking: dict[int, Counter[int]] = {}
        self.depths: Counter[int] = Counter()
        self.gaps: dict[int, frozenset[str]] = {}
        for number in shape.branches:
            self.rows[number] = Numbers(shape.keys[number])
        self._walk()

    def _walk(self) -> None:
        level = [(number, number) for number in self.shape.branches]
        depth = 1
        while level:
            self.depths[depth] = len(level)
            for number, branch in level:
                self.branch[number] = self.rows[branch]
            children = self.shape.children
            level = [
                (child, branch) for number, branch in level for child in children.get(number, ())
            ]
            depth += 1

    def of(self, topic: int) -> tuple[Numbers, ...]:
        """Return the numbers a topic counts in; none for one in a circle."""
        row = self.branch.get(topic)
        return (row,) if row else ()

    def _add_up(self) -> None:
        for row in self.rows.values():
            self.total.add(row)

    def coverage(self) -> Coverage:
        for number in self.branch:
            for row in self.of(number):
                row.topics += 1
        self._names()
        self._sentences()
        self._cultures()
        self._missing()
        self._add_up()
        return Coverage(
            branches=tuple(self.rows.values()),
            total=self.total,
            cultures=tuple(
                Culture(row.pk, row.code, row.names) for row in models.Culture.objects.all()
            ),
            liking=self.liking,
            depths=dict(self.depths),
            families=_families(),
            gaps=self.gaps,
        )

    def _names(self) -> None:
        rows = models.TopicName.objects.filter(language__in=LANGUAGES)
        found = rows.values_list("topic_id", "language")
        for topic, language in found:
            for row in self.of(topic):
                row.named[language] += 1
        self._lack(NAMES, Counter(topic for topic, _language in found))
        for number, language, name in rows.filter(topic__in=self.rows).values_list(
            "topic_id", "language", "name"
        ):
            self.rows[number].names = {**self.rows[number].names, language: name}

    def _lack(self, column: str, counts: Mapping[int, int]) -> None:
        """Note the topics that have fewer than one row a language."""
        for topic in self.branch:
            if counts.get(topic, 0) < len(LANGUAGES):
                self._miss(column, topic)

    def _miss(self, column: str, topic: int, count: int = 1) -> None:
        for row in self.of(topic):
            row.missing[column] += count

    def _sentences(self) -> None:
        counted = (
            models.Sentence.objects.filter(frame__topic__isnull=False, language__in=LANGUAGES)
            .values_list("frame__topic", "language", "frame__type")
            .annotate(Count("pk"))
            .order_by()
        )
        speaking = set()
        for topic, language, kind, count in counted:
            speaking.add((topic, language))
            for row in self.of(topic):
                row.said[language, kind] += count
        for topic, language in speaking:
            for row in self.of(topic):
                row.speaking[language] += 1

    def _cultures(self) -> None:
        only = models.Frame.only.through.objects.filter(frame__topic__isnull=False)
        for topic, culture, count in (
            only.values_list("frame__topic", "culture").annotate(Count("pk")).order_by()
        ):
            for row in self.of(topic):
                row.only[culture] += count
        liking = models.TopicInstance.objects.annotate(value=Cast("likeliness", FloatField()))
        for topic, culture, value in liking.values_list("topic_id", "culture_id", "value"):
            self.liking.setdefault(culture, Counter())[step_of(value)] += bool(self.of(topic))
            for row in self.of(topic):
                row.liking_sum[culture] = row.liking_sum.get(culture, 0.0) + value
                row.liking_count[culture] += 1

    def _missing(self) -> None:
        keywords = models.KeywordSet.objects.filter(language__in=LANGUAGES)
        self._lack(KEYWORDS, Counter(keywords.values_list("topic_id", flat=True)))
        frames = models.Frame.objects.filter(topic__isnull=False).order_by()
        for topic, count in _incomplete(frames):
            self._miss(SENTENCES, topic, count)
        links = models.TopicLink.objects.order_by().values_list("topic_id", flat=True).distinct()
        linked = set(links)
        talkers = self._talkers(frames.values_list("topic_id", "type", "scope").distinct())
        self.gaps = gaps(self.shape, talkers)
        for topic in self.branch:
            if not talkers[topic].said:
                self._miss(OWN, topic)
            if topic not in linked:
                self._miss(LINKS, topic)
        for topic in self.gaps:
            self._miss(GAPS, topic)

    def _talkers(self, said: Iterable[tuple[int, str, str]]) -> dict[int, Talker]:
        own: dict[int, set[tuple[str, str]]] = {}
        for topic, kind, scope in said:
            own.setdefault(topic, set()).add((kind, scope))
        lent: dict[int, tuple[int, ...]] = {}
        for topic, lender in models.Topic.also.through.objects.values_list(
            "from_topic_id", "to_topic_id"
        ):
            lent[topic] = (*lent.get(topic, ()), lender)
        found = {}
        rows = models.Topic.objects.order_by()
        for number, pattern, stop, gentle, home in rows.values_list(
            "pk", "pattern", "stop", "gentle", "home_id"
        ):
            saying = frozenset(own.get(number, ()))
            found[number] = Talker(pattern, stop, gentle, lent.get(number, ()), saying)
            for row in self.of(number) if home else ():
                row.homes[home] += 1
        return found


def _incomplete(frames: object) -> Iterable[tuple[int, int]]:
    """Yield topic and number of its sentences that are not said in all languages."""
    said = models.Sentence.objects.filter(language__in=LANGUAGES).order_by()
    full = said.values("frame").annotate(count=Count("pk")).filter(count__gte=len(LANGUAGES))
    rows = frames.exclude(pk__in=full.values("frame"))  # type: ignore[attr-defined]
    return rows.values_list("topic_id").annotate(Count("pk"))  # type: ignore[no-any-return]


def _families() -> tuple[Family, ...]:
    intents = dict(Intent.objects.order_by().values_list("family").annotate(Count("pk")))
    counted = Trigger.objects.order_by().values_list("intent__family", "language")
    triggers = {
        (family, language): count for family, language, count in counted.annotate(Count("pk"))
    }
    return tuple(
        Family(name, count, {code: triggers.get((name, code), 0) for code in LANGUAGES})
        for name, count in sorted(intents.items())
    )
