"""What existing clients say and how they want to be answered, generation by generation."""

import re
from dataclasses import dataclass
from typing import Any

from django.conf import settings

from languages.placeholders import with_speaker, without_placeholders

#: Multi-speaker clients send `<response><profile_id value="…">text<speaking_time>…`.
_SAID = re.compile(r'<profile_id value="([^"<>]{1,60})">([^<]*)')
EVERYBODY = "00000000-0000-0000-0000-000000000000"


@dataclass(frozen=True, slots=True)
class Names:
    """The names of the fields in the answer."""

    plan_sentence: str
    dialogue_sentence: str


FROM_CLIENT_SENTENCE = Names("plan_sentence", "dialogue_sentence")
FROM_SENTENCE = Names("intent_reply", "reply")


@dataclass(frozen=True, slots=True)
class Heard:
    """What a client said, and the shape of the answer it can read."""

    sentence: str
    names: Names
    many: bool
    profile: str

    def reply(self, type_: str, text: str) -> str | list[list[str]]:
        """Return a sentence; for multi-speaker clients a list of [type, text, profile]."""
        return [[type_, text, self.profile]] if self.many else text


def hear(message: dict[str, Any]) -> Heard:
    """Return what a message of any generation says; wrong types count as silence."""
    old_names = "sentence" in message and "client_sentence" not in message
    names = FROM_SENTENCE if old_names else FROM_CLIENT_SENTENCE
    given = message.get("client_sentence", message.get("sentence"))
    text = given if isinstance(given, str) else ""
    text = text[: 2 * settings.CAIR_LONGEST_SENTENCE]
    said = _SAID.findall(text)
    many = bool(said) or "dialogue_statistics" in message
    sentence = " ".join(words.strip() for _, words in said) if said else text
    return Heard(
        sentence=sentence[: settings.CAIR_LONGEST_SENTENCE],
        names=names,
        many=many,
        profile=said[-1][0] if said else (EVERYBODY if many else ""),
    )


def spoken(text: str, profile: str) -> str:
    """Return a sentence a client can say: `$name` becomes its speaker's placeholder, or goes."""
    return with_speaker(text, profile) if profile else without_placeholders(text)
