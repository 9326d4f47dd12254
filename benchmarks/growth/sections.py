"""The four ways in which things grow."""

from collections.abc import Callable, Iterator
from pathlib import Path

from benchmarks.growth import rows
from benchmarks.growth.contents import FAN_OUT, knowledge_of, sentences_a_topic, talked
from benchmarks.growth.rows import Row
from benchmarks.growth.size import figures_of, library_of
from benchmarks.growth.turns import Case, Site
from dialogue.engine.content import Content, build_content
from dialogue.engine.state import DialogueState
from dialogue.garbage import collected_later
from plans.engine.intents import Library
from tests.engine.plans.chat import CHAT

SAID = ("yes", "no", "I do not know", *CHAT["en"][:37])
TOPICS = (300, 3_000, 30_000)
SENTENCES = (2, 8, 16, 32)
INTENTS = (50, 200, 1_000)
TURNS = (1, 10, 100, 1_000, 3_000, 10_000)
COVERED = (0, 250, 2_780)
ALL = "all topics covered"
#: As many classes however many topics: 300 leaves under each at the most topics.
WIDE = "none covered, wide classes"
HITS = 40


@collected_later()
def _content(
    topics: int, sentences: int = 2, library: Library | None = None, fan_out: int = FAN_OUT
) -> Content:
    return build_content(knowledge_of(topics, sentences, fan_out), library or Library())


def _covered(covered: int) -> str:
    return f"{covered:,} topics covered"


def _rows(section: str, site: Site, cases: dict[tuple[float, str], Case]) -> Iterator[Row]:
    costs = site.costs(list(cases.values()), section)
    for ((x, case), one), cost in zip(cases.items(), costs, strict=True):
        yield Row(section, x, rows.TURN, case, cost)
        yield Row(section, x, rows.STATE, case, len(one.text))


def _sizes(section: str, x: float, found: dict[str, float]) -> Iterator[Row]:
    for what, value in found.items():
        yield Row(section, x, what, "", value)


def by_topics(site: Site, folder: Path) -> Iterator[Row]:
    """Yield figures at 300, 3,000 and 30,000 topics, twelve to fourteen sentences each."""
    cases: dict[tuple[float, str], Case] = {}
    for topics in TOPICS:
        content = _content(topics)
        for covered in COVERED:
            if covered <= len(content.tree.nodes):
                case = Case(content, talked(content, covered), SAID)
                cases[topics, _covered(covered)] = case
        everything = talked(content, len(content.tree.nodes))
        cases[topics, ALL] = Case(content, everything, SAID)
        wide = _content(topics, fan_out=topics)
        cases[topics, WIDE] = Case(wide, talked(wide, 0), SAID)
        yield from _sizes(rows.TOPICS, topics, figures_of(folder / "content", topics))
    yield from _rows(rows.TOPICS, site, cases)


def by_sentences(site: Site, folder: Path) -> Iterator[Row]:
    """Yield figures of 3,000 topics with more and more sentences."""
    cases: dict[tuple[float, str], Case] = {}
    for sentences in SENTENCES:
        content = _content(TOPICS[1], sentences)
        x = round(sentences_a_topic(content))
        cases |= {
            (x, _covered(covered)): Case(content, talked(content, covered), SAID)
            for covered in COVERED
        }
        found = figures_of(folder / "content", TOPICS[1], sentences)
        yield from _sizes(rows.SENTENCES, x, found)
    yield from _rows(rows.SENTENCES, site, cases)


def by_intents(site: Site, folder: Path) -> Iterator[Row]:
    """Yield figures of 300 topics with more and more intents: ordinary talk, and requests."""
    from benchmarks.matching.synthetic import World

    cases: dict[tuple[float, str], Case] = {}
    for intents in INTENTS:
        world = World(intents)
        content = _content(TOPICS[0], library=library_of(intents))
        state = talked(content, COVERED[1])
        cases[intents, "ordinary talk"] = Case(content, state, SAID)
        cases[intents, "requests"] = Case(content, state, world.hits("en", HITS))
        found = figures_of(folder / "content", TOPICS[0], intents=intents)
        yield from _sizes(rows.INTENTS, intents, found)
    yield from _rows(rows.INTENTS, site, cases)


def by_talk(site: Site, _folder: Path) -> Iterator[Row]:
    """Yield figures along one talk of 10,000 turns about the padded content."""
    from benchmarks.paper.content import padded

    snapshot = padded()
    content = build_content(snapshot.knowledge, snapshot.library)
    cases = {
        (float(turns), ""): Case(content, state, SAID)
        for turns, state in _talk(content, max(TURNS))
        if turns in TURNS
    }
    yield from _rows(rows.TALK, site, cases)


def _talk(content: Content, turns: int) -> Iterator[tuple[int, DialogueState]]:
    from benchmarks.paper.talks import CULTURE, LANGUAGE, Person
    from dialogue.turns import first_turn, take_turn

    person = Person(content, 1)
    state = first_turn(content, LANGUAGE, CULTURE, 1).state
    left = set(content.tree.nodes)
    for turn in range(1, turns + 1):
        state = take_turn(content, state, person.say(left or set(content.tree.nodes))).reply.state
        left.difference_update(state.topics)
        yield turn, state


Measure = Callable[[Site, Path], Iterator[Row]]
MEASURES: dict[str, Measure] = {
    rows.TOPICS: by_topics,
    rows.SENTENCES: by_sentences,
    rows.INTENTS: by_intents,
    rows.TALK: by_talk,
}
