"""Cells that hold codes and numbers: each way to write one thing comes to the same text."""

import re
from collections.abc import Mapping
from decimal import Decimal, InvalidOperation

from django.utils.translation import gettext as _

from authoring.topic_page.words import KINDS
from languages.known import LANGUAGES

_APART = re.compile(r"[\s,;/]+")


def culture_codes(text: str) -> str:
    """Return codes of cultures in capitals, apart by blanks, in the order of letters."""
    return " ".join(sorted({one.upper() for one in _APART.split(text) if one}))


def kind_letter(text: str) -> str:
    """Return the letter of a kind of sentence; its name is taken too."""
    word = text.strip().casefold()
    if word in KINDS or not word:
        return word
    names = {str(kind.name).casefold(): kind.letter for kind in KINDS.values()}
    return names.get(word, word)


def language_code(text: str) -> str:
    """Return the code of a language: "it" for "it", "Italian" or "Italiano"."""
    word = text.strip().casefold()
    names = {one.own_name.casefold(): code for code, one in LANGUAGES.items()}
    return names.get(word, _ENGLISH.get(word, word))


_ENGLISH = {"english": "en", "italian": "it", "japanese": "ja"}


def likeliness(text: str) -> str:
    """Return a likeliness as 0.7 however it is written (0,70); ValueError for other texts."""
    word = text.strip().replace(",", ".")
    if not word:
        return ""
    try:
        number = Decimal(word)
    except InvalidOperation as error:
        raise ValueError(_("Write a number from 0 to 1, e.g. 0.7.")) from error
    if not number.is_finite() or not 0 <= number <= 1:
        raise ValueError(_("%s is not from 0 to 1. Write e.g. 0.7.") % text.strip()[:20])
    rounded = f"{number:f}"
    return rounded.rstrip("0").rstrip(".") if "." in rounded else rounded


_FIELD = " | "


def name_fields(text: str) -> str:
    """Return the further forms of a name as `bare=dog | n=p`, in the order of letters."""
    return fields_text(read_fields(text))


def read_fields(text: str) -> dict[str, str]:
    """Return the further forms of a name; ValueError where one has no `=`."""
    fields: dict[str, str] = {}
    for part in (one.strip() for one in text.split("|")):
        key, sign, value = (one.strip() for one in part.partition("="))
        if part and (not sign or not key or not value):
            raise ValueError(_("“%s”: write a field, = and its text, e.g. n=p | bare=dog.") % part)
        if key in fields:
            raise ValueError(_("“%s” is there twice.") % key)
        if part:
            fields[key] = value
    return fields


def fields_text(fields: object) -> str:
    """Return the further forms of a name as a cell."""
    if not isinstance(fields, Mapping):
        return ""
    return _FIELD.join(f"{key}={fields[key]}" for key in sorted(fields))


ANY, BETWEEN = "*", " / "


def keywords(text: str) -> str:
    """Return keywords as `green|matcha / tea`; the second set is left out where it is any."""
    first, second = read_keywords(text)
    return keywords_text(first, second)


def read_keywords(text: str) -> tuple[str, str]:
    """Return both sets of keywords of a cell."""
    first, _sign, second = f" {text.strip()} ".partition(BETWEEN)
    return _words(first), _words(second) or ANY


def keywords_text(first: str, second: str) -> str:
    """Return both sets of keywords as a cell."""
    first, second = _words(first), _words(second)
    if not first and second in ("", ANY):
        return ""
    return first if second in ("", ANY) else f"{first}{BETWEEN}{second}"


def _words(text: str) -> str:
    return "|".join(word.strip() for word in text.split("|") if word.strip())
