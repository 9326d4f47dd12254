"""Italian names: from "tè verde" the forms il tè verde, del tè verde, un tè verde … are made."""

from collections.abc import Mapping

from languages.italian_articles import (
    ARTICLES,
    Onset,
    articulated,
    indefinite,
    joined,
    onset_of,
    unarticulated,
)
from languages.language import FormError, NameForms
from languages.name_fields import COUNTED, PLURAL, check_fields, pick

_PREPOSITIONS = ("di", "a", "da", "in", "su", "con")
FORMS = frozenset({"bare", "sg", "un", "dove", *_PREPOSITIONS})
#: `il` replaces `$hasName` itself ("gli dei"), and with it the article of every other form.
FIELDS = frozenset({"name", "g", "n", "sg", "art", "count", "un", "il", "dove", *_PREPOSITIONS})
_FEMININE = {"m": False, "f": True}
_ONSETS_TOLD = {"il": Onset.PLAIN, "la": Onset.PLAIN, "lo": Onset.HARD, "l'": Onset.VOWEL}


def name_forms(fields: Mapping[str, str]) -> NameForms:
    """Return the forms of an Italian name: {name: gnocchi, g: m, n: p} gives degli, agli.

    Absent: `.sg` and `.un` of a plural without `sg`; `.un` of `count: no` and of proper names;
    `.dove` of a name with an article, where nothing tells "nel parco" from "al mare".
    """
    check_fields(fields, FIELDS)
    feminine, plural = _gender_and_number(fields)
    if _takes_no_article(fields):
        forms = _forms_without_article(fields["name"])
        article = ""
    else:
        article, name = _article_and_name(fields, feminine=feminine, plural=plural)
        forms = _forms_with_article(article, name)
    forms |= {"bare": fields["name"]} | _single_forms(
        fields, article if "il" in fields and not plural else "", feminine=feminine, plural=plural
    )
    given = {field: text for field, text in fields.items() if field in FORMS}
    whole = {"": fields["il"]} if "il" in fields else {}
    return NameForms(forms | given | whole, plural=plural, feminine=feminine)


def _gender_and_number(fields: Mapping[str, str]) -> tuple[bool, bool]:
    if "g" not in fields:
        raise FormError("g", "The gender is missing.", "Write 'g: m' or 'g: f'.")
    return pick(fields, "g", _FEMININE, "m"), pick(fields, "n", PLURAL, "s")


def _takes_no_article(fields: Mapping[str, str]) -> bool:
    return not pick(fields, "art", {"none": False, "yes": True}, "yes")


def _forms_without_article(name: str) -> dict[str, str]:
    forms = {preposition: unarticulated(preposition, name) for preposition in _PREPOSITIONS}
    return forms | {"": name, "dove": forms["a"]}


def _forms_with_article(article: str, name: str) -> dict[str, str]:
    melted = {
        preposition: joined(articulated(preposition, article), name)
        for preposition in _PREPOSITIONS
    }
    return melted | {"": joined(article, name)}


def _single_forms(
    fields: Mapping[str, str], told: str, *, feminine: bool, plural: bool
) -> dict[str, str]:
    """Return `.sg` and `.un`; `told` is the article an author wrote for a singular, or ""."""
    single = fields.get("sg", "" if plural else fields["name"])
    if not single:
        return {}
    if not _is_counted(fields):
        return {"sg": single}
    onset = _ONSETS_TOLD.get(told, onset_of(single))
    return {"sg": single, "un": joined(indefinite(onset, feminine=feminine), single)}


def _is_counted(fields: Mapping[str, str]) -> bool:
    """Say whether "un" is right: not for `count: no`, nor for a proper name (un Colosseo)."""
    proper = fields["name"][0].isupper() or _takes_no_article(fields)
    return pick(fields, "count", COUNTED, "no" if proper and "sg" not in fields else "yes")


def _article_and_name(
    fields: Mapping[str, str], *, feminine: bool, plural: bool
) -> tuple[str, str]:
    """Return the article the author wrote in `il`, else the one the rules give."""
    given, name = _split_article(fields.get("il", ""))
    if given:
        return given, name
    onset = onset_of(fields["name"])
    return ARTICLES[feminine, plural][onset], fields["name"]


def _split_article(text: str) -> tuple[str, str]:
    for article in ("il", "lo", "la", "i", "gli", "le"):
        if text.casefold().startswith(f"{article} "):
            return article, text[len(article) + 1 :]
    if text[:2].casefold() in ("l'", "l’"):
        return "l'", text[2:]
    return "", ""
