"""The forms of rows, one module a subject; Django registers what is imported here."""

from authoring.admin import (
    api_keys,
    conversations,
    cultures,
    intents,
    publications,
    sentences,
    topics,
    users,
)

__all__ = [
    "api_keys",
    "conversations",
    "cultures",
    "intents",
    "publications",
    "sentences",
    "topics",
    "users",
]
