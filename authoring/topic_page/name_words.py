"""The fields of a name in plain words, one row a field, and its forms as a preview."""

from collections.abc import Mapping
from typing import NamedTuple

from django.utils.functional import Promise
from django.utils.translation import gettext_lazy as _

from languages.known import LANGUAGES

Words = str | Promise


class NameField(NamedTuple):
    """One field: its key in the data, what it is, an example, and the choices if it has any."""

    key: str
    label: Words
    told: Words
    choices: tuple[tuple[str, Words], ...] = ()


_NUMBER = (("", _("one (singular)")), ("s", _("one (singular)")), ("p", _("many (plural)")))
_COUNTED = (("", _("as usual")), ("yes", _("yes")), ("no", _("no")))
_GENDER = (("", _("choose…")), ("m", _("masculine")), ("f", _("feminine")))
_ARTICLE = (("", _("yes")), ("yes", _("yes")), ("none", _("no")))

NAME_FIELDS: Mapping[str, tuple[NameField, ...]] = {
    "en": (
        NameField("n", _("Number"), _("Example: many for “dogs”"), _NUMBER),
        NameField("bare", _("Without article or plural"), _("Example: dog, for “dogs”")),
        NameField("count", _("Can be counted"), _("Example: no for “tea”"), _COUNTED),
        NameField("one", _("With “a” or “an”"), _("Only if irregular. Example: a pair of shoes")),
    ),
    "it": (
        NameField("g", _("Gender"), _("Example: masculine for “tè verde”"), _GENDER),
        NameField("n", _("Number"), _("Example: many for “gnocchi”"), _NUMBER),
        NameField("sg", _("In the singular"), _("Example: cane, for “cani”")),
        NameField("art", _("Takes an article"), _("Example: no for “Roma”"), _ARTICLE),
        NameField("count", _("Can be counted"), _("Example: no for “latte”"), _COUNTED),
        NameField("un", _("With “un”"), _("Only if irregular. Example: uno psicologo")),
        NameField("il", _("With “il”"), _("Only if irregular. Example: gli dei")),
        NameField("dove", _("Where"), _("Example: al mare, in montagna")),
        NameField("di", _("With “di”"), _("Only if irregular. Example: di Roma")),
        NameField("a", _("With “a”"), _("Only if irregular. Example: a Roma")),
        NameField("da", _("With “da”"), _("Only if irregular. Example: da Roma")),
        NameField("in", _("With “in”"), _("Only if irregular. Example: in cucina")),
        NameField("su", _("With “su”"), _("Only if irregular. Example: su Marte")),
        NameField("con", _("With “con”"), _("Only if irregular. Example: con Maria")),
    ),
    "ja": (
        NameField("kana", _("Reading"), _("In kana. Example: りょくちゃ")),
        NameField("polite", _("Polite"), _("As the robot says it. Example: お寿司")),
    ),
}

NAME_HELP: Mapping[str, Words] = {
    "en": _("What fits after “I like …”. Example: green tea"),
    "it": _("Without article. Example: tè verde"),
    "ja": _("The plain word. Example: 緑茶"),
}

#: Those seldom needed stand behind "more forms".
SELDOM = frozenset(("one", "un", "il", "dove", "di", "a", "da", "in", "su", "con"))


def without_empty(fields: Mapping[str, str]) -> dict[str, str]:
    """Return the fields that say something."""
    return {key: text for key, text in fields.items() if text}


class Form(NamedTuple):
    """One form of a name: how a sentence asks for it, and how it sounds."""

    asked: str
    text: str


def forms_of(language: str, name: str, fields: Mapping[str, str]) -> tuple[Form, ...]:
    """Return every form of a name; FormError where a field is wrong."""
    made = LANGUAGES[language].name_forms({"name": name, **fields}).forms
    return tuple(
        Form(f"$hasName.{form}" if form else "$hasName", made[form]) for form in sorted(made)
    )
