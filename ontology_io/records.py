"""What a knowledge base says, topics and intents together, as plain values."""

import msgspec

from dialogue.engine.concepts import Knowledge
from plans.engine.intents import Library


class KnowledgeBase(msgspec.Struct, frozen=True, kw_only=True):
    """Everything an expert can edit."""

    knowledge: Knowledge = Knowledge()
    library: Library = Library()
