"""What the rows may hold, told in words for experts: the same rules as in the files of content/."""

import re
from collections.abc import Iterator, Mapping

from django.core.exceptions import ValidationError
from django.core.validators import RegexValidator
from django.utils.text import format_lazy
from django.utils.translation import gettext_lazy as _

from languages.known import LANGUAGES
from plans.engine.intents import SLOT_KINDS, ActionItem
from plans.engine.patterns import PatternError, parse_pattern
from plans.engine.plan_text import PlanTextError, parse_plan, print_plan

LONGEST_TEXT = 2000

one_word = RegexValidator(
    r"\A[a-z][a-z0-9_]{0,59}\Z", _("Write one word of small letters, e.g. playsong.")
)
no_control = RegexValidator(
    r"\A[^\x00-\x08\x0b-\x1f\x7f\ud800-\udfff\ufffe\uffff]*\Z",
    _("Remove the invisible control characters (they often come with pasted text)."),
)
slot_kind = RegexValidator(
    rf"\A({'|'.join(SLOT_KINDS)}|value:[a-z][a-z0-9_]*)\Z",
    format_lazy(
        _("Write {kinds} or value: and a list, e.g. value:volume_level."),
        kinds=", ".join(SLOT_KINDS),
    ),
)
culture_codes = RegexValidator(
    r"\A([A-Z]{2,8}( [A-Z]{2,8})*)?\Z", _("Write codes of cultures apart by blanks, e.g. IN EN.")
)

_PARAMETER = re.compile(r"[a-z][a-z0-9_]*")
_KEPT_FOR_FILES = ("->", "|", "\n")


def languages() -> list[tuple[str, str]]:
    """Return the choices of languages; a function, so that a new one needs no migration."""
    return [(code, language.own_name) for code, language in LANGUAGES.items()]


def texts_by_language(value: object) -> None:
    """Refuse all but a text for each of some languages: {"en": "Which song?"}."""
    for code, text in _languages(value, str(_('Write {"en": "…"}: a text for each language.'))):
        _text(text, _("The text of “%(language)s”") % {"language": code})


def words_by_value(value: object) -> None:
    """Refuse all but language → value → words: {"en": {"louder": ["louder", "up"]}}."""
    shape = str(_('Write {"en": {"louder": ["louder", "up"]}}: the words of each value.'))
    for code, lists in _languages(value, shape):
        if not isinstance(lists, dict):
            raise ValidationError(f"{code}: {shape}")
        for name, words in lists.items():
            place = {"value": name, "language": code}
            _text(name, _("A value in “%(language)s”") % place)
            if not isinstance(words, list):
                text = _("%(language)s, “%(value)s”: write a list of words in [ ].")
                raise ValidationError(text % place)
            for word in words:
                _text(word, _("A word of “%(value)s” in “%(language)s”") % place)
                if "|" in word:
                    text = _("“%(word)s”: write words one by one, without |.")
                    raise ValidationError(text % {"word": word})


def parameter_pairs(value: object) -> None:
    """Refuse all but names with values in order: [["title", "{title}"]]."""
    shape = str(_('Write [["title", "{title}"]]: names and values in order.'))
    if not isinstance(value, list) or not all(map(_is_pair, value)):
        raise ValidationError(shape)
    item = ActionItem(action="plan", parameters=tuple((name, text) for name, text in value))
    try:
        same = parse_plan(print_plan((item,))) == (item,)
    except PlanTextError as error:
        raise ValidationError(str(error)) from error
    if not same:
        raise ValidationError(_("A value cannot hold # or name=, nor begin or end with a blank."))


def expected_parameters(value: object) -> None:
    """Refuse all but names with what must be captured: {"title": "Hey Brother"}."""
    if not isinstance(value, dict):
        raise ValidationError(_('Write {"title": "Hey Brother"}, or leave it empty.'))
    for name, text in value.items():
        if not _PARAMETER.fullmatch(name):
            said = _("“%(name)s”: write a name of small letters, e.g. title.")
            raise ValidationError(said % {"name": name})
        _text(text, _("The value of “%(name)s”") % {"name": name})
        test_sentence(text)


def test_sentence(text: str) -> None:
    """Refuse what the files of content/ use to part a sentence from what is expected."""
    found = [mark for mark in _KEPT_FOR_FILES if mark in text]
    if found:
        # Told by its name where it cannot be seen.
        mark = repr(found[0])
        raise ValidationError(_("A test cannot hold %(mark)s.") % {"mark": mark})


def trigger_pattern(text: str) -> None:
    """Refuse a pattern that cannot be read, with the place."""
    try:
        parse_pattern(text)
    except PatternError as error:
        raise ValidationError(str(error)) from error


def _is_pair(pair: object) -> bool:
    return isinstance(pair, list) and len(pair) == 2 and all(isinstance(each, str) for each in pair)


def _languages(value: object, shape: str) -> Iterator[tuple[str, object]]:
    if not isinstance(value, dict):
        raise ValidationError(shape)
    _known(value)
    yield from value.items()


def _known(value: Mapping[str, object]) -> None:
    for code in value:
        if code not in LANGUAGES:
            said = _("“%(code)s” is no language; use %(languages)s.")
            raise ValidationError(said % {"code": code, "languages": ", ".join(LANGUAGES)})


def _text(text: object, what: str) -> None:
    if not isinstance(text, str) or not text.strip() or text != text.strip():
        said = _("%(what)s must be a text without outer blanks, in quotes.")
        raise ValidationError(said % {"what": what})
    if len(text) > LONGEST_TEXT:
        said = _("%(what)s has %(length)s characters; %(most)s at most.")
        values = {"what": what, "length": len(text), "most": LONGEST_TEXT}
        raise ValidationError(said % values)
    no_control(text)
