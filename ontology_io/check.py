"""Check a whole knowledge base: what the dialogue and the plan side each find."""

from dialogue.engine.checks import check_knowledge
from dialogue.engine.findings import Finding
from dialogue.engine.library_checks import check_library
from ontology_io.records import KnowledgeBase


def check_base(base: KnowledgeBase) -> list[Finding]:
    """Return all findings; those with `error` stop loading and publishing."""
    return [*check_knowledge(base.knowledge), *check_library(base.knowledge, base.library)]
