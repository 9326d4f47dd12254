"""What each language knows of numbers and times, by code."""

from collections.abc import Mapping
from types import MappingProxyType

from languages.spoken.english import ENGLISH
from languages.spoken.italian import ITALIAN
from languages.spoken.japanese import JAPANESE
from languages.spoken.shape import Spoken

SPOKEN: Mapping[str, Spoken] = MappingProxyType({"en": ENGLISH, "it": ITALIAN, "ja": JAPANESE})
