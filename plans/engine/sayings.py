"""What the agent says about plans in general: phrases that are plain text, apart by `|`."""

from collections.abc import Mapping
from types import MappingProxyType

from plans.engine.intents import Library

#: Said where the robot lacks an action. `cannot_alert` is of that action, `cannot` holds `{can}`,
#: the words of the intent ("play a song"), `cannot_do` is for intents without such words.
CANNOT_ACTION = "cannot_"
CANNOT = "cannot"
CANNOT_DO = "cannot_do"
#: Said before the plan where only some of its actions can be carried out.
CANNOT_ALL = "cannot_all"
#: Asks whether something nearly understood was meant; holds `{can}`.
DID_YOU_MEAN = "did_you_mean"

Sayings = Mapping[str, Mapping[str, tuple[str, ...]]]


def is_saying(key: str) -> bool:
    """Say whether the phrase of this key is plain text, no pattern."""
    return key in (CANNOT, DID_YOU_MEAN) or key.startswith(CANNOT_ACTION)


def sayings_of(library: Library) -> Sayings:
    """Return the sentences by key and language."""
    return MappingProxyType(
        {
            phrase.key: MappingProxyType(
                {language: _sentences(text) for language, text in phrase.texts.items()}
            )
            for phrase in library.phrases
            if is_saying(phrase.key)
        }
    )


def _sentences(text: str) -> tuple[str, ...]:
    return tuple(sentence.strip() for sentence in text.split("|") if sentence.strip())
