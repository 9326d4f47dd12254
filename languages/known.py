"""The languages the service speaks, by code; a new language is one file and one row here."""

from collections.abc import Mapping
from types import MappingProxyType

from languages.english import ENGLISH
from languages.italian import ITALIAN
from languages.japanese import JAPANESE
from languages.language import Language

_KNOWN: tuple[Language, ...] = (ENGLISH, ITALIAN, JAPANESE)

LANGUAGES: Mapping[str, Language] = MappingProxyType(
    {language.code: language for language in _KNOWN}
)
