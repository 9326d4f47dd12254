"""Check a knowledge base before it is loaded or published: all errors at once."""

from collections.abc import Iterable, Iterator, Mapping

from dialogue.engine.concepts import ROOT, Frame, Knowledge, Topic
from dialogue.engine.content import SAME_AS_PARENT
from dialogue.engine.findings import Finding
from dialogue.engine.keywords import ANYTHING
from dialogue.engine.lines import parse_proposal
from dialogue.engine.patterns import PatternError, parse_pattern
from dialogue.engine.pools import POOLS
from dialogue.engine.sentence_checks import check_sentences
from dialogue.engine.sentence_types import SENTENCE_TYPES
from languages.known import LANGUAGES
from languages.language import FormError

LONGEST_KEY = 100


def check_knowledge(knowledge: Knowledge) -> list[Finding]:
    """Return all findings; those with `error` stop loading and publishing."""
    found = list(_check_structure(knowledge))
    for topic in knowledge.topics:
        found += _check_topic(topic, knowledge)
    found += _check_pools(knowledge)
    if not any(finding.error for finding in found):
        found += check_sentences(knowledge)
    return found


def _check_structure(knowledge: Knowledge) -> Iterator[Finding]:
    topics = {topic.key: topic for topic in knowledge.topics}
    if len(topics) < len(knowledge.topics):
        yield Finding("D001", ROOT, "Two topics have the same name.", "Rename one of them.")
    for topic in knowledge.topics:
        if topic.is_a != ROOT and topic.is_a not in topics:
            yield _unknown("D002", topic, topic.is_a, "parent")
        elif _has_cycle(topic, topics):
            yield Finding(
                "D003", topic.key, "It lies below itself.", "Choose a parent above it, or Topic."
            )
        yield from _check_links(topic, topics)


def _check_links(topic: Topic, topics: Mapping[str, Topic]) -> Iterator[Finding]:
    for key in topic.also:
        if key not in topics:
            yield _unknown("D004", topic, key, "topic to take sentences from")
    for key in topic.see:
        if key not in topics:
            yield _unknown("D005", topic, key, "link")
    if topic.key in topic.see:
        yield Finding("D006", topic.key, "It links to itself.", "Remove the link.")
    if len(set(topic.see)) < len(topic.see):
        yield Finding("D006", topic.key, "It links to a topic twice.", "Remove one link.")


def _unknown(code: str, topic: Topic, key: str, role: str) -> Finding:
    return Finding(code, topic.key, f"Its {role} {key!r} does not exist.", "Correct the name.")


def _has_cycle(topic: Topic, topics: Mapping[str, Topic]) -> bool:
    seen = {topic.key}
    key = topic.is_a
    while key in topics:
        if key in seen:
            return True
        seen.add(key)
        key = topics[key].is_a
    return False


def _check_topic(topic: Topic, knowledge: Knowledge) -> Iterator[Finding]:
    if topic.key == ROOT or len(topic.key) > LONGEST_KEY:
        yield Finding("D007", topic.key, "This name cannot be used.", "Choose another name.")
    cultures = {culture.code for culture in knowledge.cultures}
    if topic.of and topic.of not in cultures:
        yield _unknown("D008", topic, topic.of, "home culture")
    for culture, value in topic.likeliness.items():
        if culture not in cultures:
            yield _unknown("D008", topic, culture, "culture")
        if not 0 <= value <= 1:
            yield Finding(
                "D009",
                topic.key,
                f"The likeliness {value} in {culture} is outside 0..1.",
                "Give a number from 0 to 1.",
            )
    yield from _check_names(topic)
    yield from _check_patterns(topic)
    yield from _check_keywords(topic)
    for frame in topic.frames:
        yield from _check_frame(frame, frozenset(SENTENCE_TYPES), cultures)


def _check_names(topic: Topic) -> Iterator[Finding]:
    for code, language in LANGUAGES.items():
        if code not in topic.names:
            yield Finding("D010", topic.key, f"It has no name in {code}.", "Add the name.")
            continue
        try:
            language.name_forms(topic.names[code])
        except FormError as error:
            yield Finding("D011", topic.key, f"Name in {code}: {error.message}", error.hint)


def _check_patterns(topic: Topic) -> Iterator[Finding]:
    for text in topic.pattern:
        try:
            parse_pattern(text)
        except PatternError as error:
            yield Finding("D012", topic.key, str(error), "Write for example q r w c [g].")
    unknown = set(topic.stop) - set(SENTENCE_TYPES)
    if unknown:
        yield Finding(
            "D013",
            topic.key,
            f"It stops the types {' '.join(sorted(unknown))}, which do not exist.",
            f"Use {' '.join(SENTENCE_TYPES)}.",
        )


def _check_keywords(topic: Topic) -> Iterator[Finding]:
    for code in [code for code in LANGUAGES if code in topic.keywords]:
        for word in (*topic.keywords[code][0], *topic.keywords[code][1]):
            if word not in (ANYTHING, SAME_AS_PARENT) and not LANGUAGES[code].tokens(word):
                yield Finding(
                    "D027",
                    topic.key,
                    f"The keyword {word!r} in {code} has no letters or digits.",
                    "Remove it.",
                )


def _check_frame(frame: Frame, types: frozenset[str], cultures: Iterable[str]) -> Iterator[Finding]:
    if frame.type not in types:
        yield Finding(
            "D014", frame.key, f"There is no type {frame.type!r}.", "Use q p n w c g t e."
        )
    silent = [code for code in LANGUAGES if not frame.texts.get(code, "").strip()]
    for code in silent:
        # In that language other sentences are said: a gap. One that nobody can hear is a mistake.
        mute = len(silent) == len(LANGUAGES)
        text = f"It says nothing in {code}."
        yield Finding("D015", frame.key, text, "Write the sentence.", error=mute)
    for culture in frame.only:
        if culture not in cultures:
            yield Finding("D016", frame.key, f"There is no culture {culture!r}.", "Correct it.")
    yield from _check_activity(frame)


def _check_activity(frame: Frame) -> Iterator[Finding]:
    if frame.type == "g" and not frame.do:
        yield Finding(
            "D017", frame.key, "A proposal needs its activity.", "E.g. playsong title=$hasName."
        )
    if frame.do:
        try:
            parse_proposal(frame.do)
        except ValueError as error:
            yield Finding("D018", frame.key, str(error), "E.g. playsong title=$hasName.")


def _check_pool_speaks(name: str, frames: tuple[Frame, ...]) -> Iterator[Finding]:
    if not frames:
        yield Finding("D019", name, "This pool is empty.", "Write at least one sentence.")
    for code in LANGUAGES if frames else ():
        if not any(frame.texts.get(code, "").strip() for frame in frames):
            text = f"This pool has no sentence in {code}."
            yield Finding("D019", name, text, "Write at least one sentence.")


def _check_pools(knowledge: Knowledge) -> Iterator[Finding]:
    cultures = {culture.code for culture in knowledge.cultures}
    for name in POOLS:
        yield from _check_pool_speaks(name, knowledge.pools.get(name, ()))
    for name, frames in knowledge.pools.items():
        if name not in POOLS:
            yield Finding("D020", name, "There is no such pool.", f"Use {', '.join(POOLS)}.")
        for frame in frames:
            yield from _check_frame(frame, frozenset((name,)), cultures)
