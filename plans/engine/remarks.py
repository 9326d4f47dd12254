"""What the checks of the intents find: a stable code, the intent, what is wrong and what to do."""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

#: What each code means, in the order in which they are shown.
CODES: Mapping[str, str] = MappingProxyType(
    {
        "C001": "another intent wins some sentences of a trigger",
        "C002": "a trigger can never win",
        "C003": "only the order of the library decides between two intents",
        "C004": "a sentence of a trigger matches nothing",
        "C005": "two intents share a wording",
        "C006": "a phrase is never used",
        "C007": "a value list is never used",
        "C008": "one word stands for two values",
        "C009": "a value is none of the words clients understand",
        "C010": "a required slot has no question",
        "C011": "a language is not written, or is without tests",
        "C012": "too few or too many triggers, plan sentences or tests",
        "C013": "no plan sentence can be said without a slot",
        "C014": "no intent asks for an action of clients",
        "C015": "an accepted conflict is no longer there",
    }
)


@dataclass(frozen=True, slots=True)
class Remark:
    """One remark; `where` is the key of an intent, a value list or `<phrase>`.

    `other` is the intent it collides with, "" where there is none. `near` is the trigger or
    sentence it is about, so that its line can be found.
    """

    code: str
    where: str
    language: str
    text: str
    error: bool = False
    other: str = ""
    near: str = ""

    def __str__(self) -> str:
        """Return one line: `C010 playsong (it): The slot title is required …`."""
        language = f" ({self.language})" if self.language else ""
        kind = "" if self.error else "warning: "
        return f"{self.code} {self.where}{language}: {kind}{self.text}"
