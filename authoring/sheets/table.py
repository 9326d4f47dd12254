"""All kinds of sheets, one row each."""

from collections.abc import Mapping
from types import MappingProxyType

from authoring.sheets.intents import PlanSentences, Tests, Triggers
from authoring.sheets.likeliness import Likeliness
from authoring.sheets.sentences import Sentences
from authoring.sheets.sheet import Sheet
from authoring.sheets.topics import Topics

_ALL: tuple[type[Sheet], ...] = (Sentences, Topics, Likeliness, Triggers, PlanSentences, Tests)

SHEETS: Mapping[str, type[Sheet]] = MappingProxyType({one.name: one for one in _ALL})
