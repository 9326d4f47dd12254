"""Whether the rows of the database can hold a knowledge base: lengths and names."""

import re
from collections.abc import Iterator

from dialogue.engine.concepts import ROOT, Frame, Topic
from dialogue.engine.pools import POOLS
from dialogue.engine.sentence_types import SENTENCE_TYPES
from ontology_io.owl.names import TOPIC_NAME, VARIABLE_NAME
from ontology_io.owl.resolve_notes import Notes
from ontology_io.records import KnowledgeBase
from plans.engine.intents import Intent

SENTENCE, NAME, VARIABLE, KEYWORDS = 400, 120, 120, 2000
PATTERN, NOTE, ACTIVITY, TRIGGER = 200, 2000, 200, 500
_WORD = re.compile(r"[a-z][a-z0-9_]{0,59}")
_CULTURE = re.compile(r"[A-Z]{2,8}")
#: What is measured: what it is called, the text, how long it may be.
_Text = tuple[str, str, int]


def fitting(base: KnowledgeBase, notes: Notes) -> None:
    """Tell, as errors, everything that a row could not hold."""
    for culture in base.knowledge.cultures:
        if not _CULTURE.fullmatch(culture.code):
            notes.error(culture.code, "A culture's code is two to eight capitals.", "E.g. EN.")
    for topic in base.knowledge.topics:
        _topic(topic, notes)
    for name, frames in base.knowledge.pools.items():
        if name not in POOLS:
            notes.error(name, "There is no such pool.", f"Use {', '.join(POOLS)}.")
        for frame in frames:
            _tell(frame.key, _said(frame), notes)
    _library(base, notes)


def _topic(topic: Topic, notes: Notes) -> None:
    if topic.key == ROOT or not TOPIC_NAME.fullmatch(topic.key):
        notes.error(
            topic.key,
            "The name of a topic is letters and digits, beginning with a letter.",
            "Rename the class in Protégé (Refactor > Rename entity), e.g. GreenTea.",
        )
    _tell(topic.key, _texts(topic), notes)
    _tell(topic.key, _words(topic), notes)
    for frame in topic.frames:
        _tell(frame.key, _said(frame), notes)
        if frame.type not in SENTENCE_TYPES:
            notes.error(frame.key, f"There is no kind of sentence {frame.type!r}.", "")


def _tell(where: str, texts: Iterator[_Text], notes: Notes) -> None:
    for what, text, most in texts:
        if len(text) > most:
            notes.error(
                where, f"{what} has {len(text)} characters; {most} are the most.", "Shorten it."
            )


def _texts(topic: Topic) -> Iterator[_Text]:
    yield "Its note", topic.note, NOTE
    yield "Its pattern", " | ".join(topic.pattern), PATTERN
    yield "inheritsNo", topic.stop, len(SENTENCE_TYPES)
    for code, fields in topic.names.items():
        for text in fields.values():
            yield f"Its name in {code}", text, NAME
    for name in topic.individuals.values():
        yield f"The name of the individual {name}", name, 100


def _words(topic: Topic) -> Iterator[_Text]:
    for code, texts in topic.variables.items():
        for name, text in texts.items():
            yield f"The variable ${name} in {code}", text, VARIABLE
            if not VARIABLE_NAME.fullmatch(name):
                yield f"The name of the variable ${name} (small letters only)", name, 0
    for code, sets in topic.keywords.items():
        for words in sets:
            yield f"A set of keywords in {code}", "|".join(words), KEYWORDS


def _said(frame: Frame) -> Iterator[_Text]:
    yield "Its activity", frame.do, ACTIVITY
    for code, text in frame.texts.items():
        yield f"The sentence in {code}", text, SENTENCE


def _library(base: KnowledgeBase, notes: Notes) -> None:
    library = base.library
    keys = [one.key for one in library.intents] + [one.key for one in library.phrases]
    for key in keys + [one.key for one in library.values]:
        if not _WORD.fullmatch(key):
            notes.error(
                key, "The name is one word of small letters, digits and _.", "E.g. play_song."
            )
    for intent in library.intents:
        _tell(intent.key, _told(intent), notes)
        _tell(intent.key, _spoken(intent), notes)
        if not 0 <= intent.priority <= 100:
            notes.error(intent.key, f"Its priority is {intent.priority}.", "Give 0 to 100.")


def _told(intent: Intent) -> Iterator[_Text]:
    yield "Its note", intent.note, NOTE
    yield "Its family", intent.family, 60
    for slot in intent.slots:
        yield f"The name of the slot {slot.name}", slot.name, 40
        yield f"The kind of the slot {slot.name}", slot.kind, 80
    for item in (*intent.plan, *intent.kbplan):
        yield f"The name of the action {item.action}", item.action, 60


def _spoken(intent: Intent) -> Iterator[_Text]:
    for code, rows in intent.triggers.items():
        for text in rows:
            yield f"A trigger in {code}", text, TRIGGER
    for code, sentences in intent.plan_sentences.items():
        for one in sentences:
            yield f"A plan sentence in {code}", one.text, SENTENCE
    for code, tests in intent.tests.items():
        for test in tests:
            yield f"A test in {code}", test.sentence, 500
