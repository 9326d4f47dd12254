"""Check a whole knowledge base: what the dialogue and the plan side each find."""

from itertools import count

import msgspec

from dialogue.engine.checks import check_knowledge
from dialogue.engine.concepts import Knowledge
from dialogue.engine.content import Content, build_content
from dialogue.engine.findings import Finding
from dialogue.engine.library_checks import check_library
from ontology_io.owl.resolve_fit import fitting
from ontology_io.owl.resolve_notes import Notes
from ontology_io.records import KnowledgeBase


def check_base(base: KnowledgeBase) -> list[Finding]:
    """Return all findings; those with `error` stop loading and publishing."""
    knowledge = _with_numbers(base.knowledge)
    return [*check_knowledge(knowledge), *check_library(knowledge, base.library)]


def check_files(base: KnowledgeBase) -> list[Finding]:
    """Return all findings of what was read from files, which may be longer than a row can be.

    SQLite would take it, PostgreSQL not; and no author could save the topic again.
    """
    notes = Notes()
    fitting(base, notes)
    unfit = [Finding("D028", one.where, one.text, one.hint) for one in notes.problems]
    return [*check_base(base), *unfit]


def _with_numbers(knowledge: Knowledge) -> Knowledge:
    """Return it with passing numbers for what gets its real one when it is written.

    The tree knows its topics by number: without, only the last new one would be checked.
    """
    topics = tuple(
        topic if topic.number else msgspec.structs.replace(topic, number=-place)
        for place, topic in enumerate(knowledge.topics, 1)
    )
    return msgspec.structs.replace(knowledge, topics=topics)


def build_base(base: KnowledgeBase) -> Content:
    """Return the content that a base without errors makes; nothing is written.

    New topics get passing numbers after the last: a dialogue state counts topics from 1.
    """
    knowledge = base.knowledge
    following = count(max((topic.number for topic in knowledge.topics), default=0) + 1)
    topics = tuple(
        topic if topic.number else msgspec.structs.replace(topic, number=next(following))
        for topic in knowledge.topics
    )
    return build_content(msgspec.structs.replace(knowledge, topics=topics), base.library)
