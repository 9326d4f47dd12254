"""What rows about topics may hold, and the choices offered, in words for experts."""

from django.core.exceptions import ValidationError
from django.core.validators import RegexValidator
from django.utils.translation import gettext
from django.utils.translation import gettext_lazy as _

from dialogue.engine.concepts import ROOT
from dialogue.engine.lines import ProposalError, parse_proposal
from dialogue.engine.patterns import PatternError, parse_patterns
from dialogue.engine.pools import POOLS
from dialogue.engine.sentence_types import SENTENCE_TYPES
from languages.known import LANGUAGES
from languages.language import FormError
from languages.templates import TemplateError, compile_template
from plans.validators import languages, no_control, texts_by_language

__all__ = ["languages", "no_control", "texts_by_language"]

SCOPE_CHOICES = [
    ("", _("this topic and everything below it")),
    ("self", _("this topic only")),
    ("below", _("only what is below this topic")),
]

one_name = RegexValidator(
    r"\A[A-Za-z][A-Za-z0-9]{0,99}\Z", _("Write one word of letters and digits, e.g. GreenTea.")
)
individual_name = RegexValidator(
    r"\A[A-Za-z][A-Za-z0-9_.-]{0,99}\Z",
    _("Write letters, digits and _ . - beginning with a letter, e.g. EN_TEA."),
)
culture_code = RegexValidator(r"\A[A-Z]{2,8}\Z", _("Write two to eight capitals, e.g. EN."))
sentence_types = RegexValidator(r"\A[qpnwcgte]*\Z", _("Use the letters of sentence types."))
variable_name = RegexValidator(r"\A[a-z][a-z_]*\Z", _("Small letters only, e.g. unit."))
frame_key = RegexValidator(
    r"\A[A-Za-z][A-Za-z0-9_]{0,99}\.[a-z]?[0-9]{1,4}\Z", _("Write it like GreenTea.q1.")
)
keywords = RegexValidator(
    r"\A(?!.* / )(?!\s*/)(?!.*/\s*\Z)[^\n]*\Z",
    _("Write one set of words apart by |; the second set has a field of its own."),
)


def types() -> list[tuple[str, str]]:
    """Return the choices of sentence types; a function, so that a new one needs no migration."""
    return [(row.letter, f"{row.letter}: {gettext(row.name)}") for row in SENTENCE_TYPES.values()]


def pools() -> list[tuple[str, str]]:
    """Return the choices of pools."""
    return [(pool.name, f"{pool.name}: {gettext(pool.used_when)}") for pool in POOLS.values()]


def not_the_root(key: str) -> None:
    """Refuse the name of the root, which stands above all topics."""
    if key == ROOT:
        text = _("%(root)s is the root itself. Choose another name.")
        raise ValidationError(text % {"root": ROOT})


def patterns(text: str) -> None:
    """Refuse patterns that cannot be read."""
    try:
        parse_patterns(text.split(" | "))
    except PatternError as error:
        raise ValidationError(str(error)) from error


def activity(text: str) -> None:
    """Refuse an activity that cannot be read."""
    try:
        parse_proposal(text)
    except (ProposalError, TemplateError) as error:
        raise ValidationError(str(error)) from error


def check_name(language: str, name: str, fields: object) -> None:
    """Refuse a name whose forms cannot be made; the message stands at the field it is about."""
    known = LANGUAGES.get(language)
    if known is None or not name:
        return
    if not isinstance(fields, dict) or not all(isinstance(text, str) for text in fields.values()):
        text = _('Write texts by name, e.g. {"g": "m", "n": "p"}.')
        raise ValidationError({"fields": text})
    if "name" in fields:
        raise ValidationError({"fields": _("The name itself has a field of its own.")})
    try:
        known.name_forms({"name": name, **fields})
    except FormError as error:
        place = "name" if error.field == "name" else "fields"
        raise ValidationError({place: str(error)}) from error


def check_sentence(language: str, text: str) -> None:
    """Refuse a sentence that cannot be read, with the place."""
    if language not in LANGUAGES or not text:
        return
    try:
        compile_template(text, language)
    except TemplateError as error:
        raise ValidationError({"text": str(error)}) from error
