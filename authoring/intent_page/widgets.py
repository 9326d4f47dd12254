"""Fields in place of JSON: a text per language, values of parameters, what a test expects.

Each widget shows plain inputs and gives back the JSON text its form field expects. Where none of
its own inputs was sent, a JSON text of that name is taken as it is.
"""

import json
from collections.abc import Callable, Iterable, Mapping
from typing import Any

from django import forms
from django.template.loader import render_to_string
from django.utils.datastructures import MultiValueDict
from django.utils.html import escape
from django.utils.safestring import SafeString

from authoring.intent_page.quick_widgets import filled
from authoring.intent_page.wordings import PRIORITIES
from languages.known import LANGUAGES

FOLDER = "admin/plans/intent"
Choices = Callable[[], Iterable[tuple[str, str]]]
Sent = Mapping[str, Any]


def decoded(value: object) -> Any:
    """Return what a JSON text holds, None for nonsense; what is no text stays as it is."""
    if not isinstance(value, str):
        return value
    try:
        return json.loads(value)
    except ValueError:
        return None


def encoded(value: object) -> str:
    """Return a value as the JSON text of a form field."""
    return json.dumps(value, ensure_ascii=False)


class OwnWidget(forms.Widget):
    """A widget with a template among those of the project."""

    def render(
        self, name: str, value: Any, attrs: dict[str, Any] | None = None, renderer: Any = None
    ) -> SafeString:
        """Return its HTML."""
        context = self.get_context(name, value, attrs)["widget"]
        return render_to_string(f"{FOLDER}/{self.template_name}", {"widget": context})

    def sent_names(self, data: Sent, name: str) -> list[str]:
        """Return the names of its own inputs that were sent, in their order."""
        return [each for each in data if each.startswith((f"{name}_", f"{name}."))]

    def value_omitted_from_data(self, data: Sent, files: Any, name: str) -> bool:
        """Say whether neither its inputs nor a JSON text were sent."""
        return name not in data and not self.sent_names(data, name)


class LanguageTexts(OwnWidget):
    """One text per language: {"en": "Which song?"}."""

    template_name = "language_texts.html"

    def __init__(self, examples: Mapping[str, str], *, rows: int = 1) -> None:
        super().__init__()
        self.examples, self.rows = examples, rows

    def get_context(self, name: str, value: Any, attrs: Any) -> dict[str, Any]:
        """Return the languages with their texts."""
        context = super().get_context(name, value, attrs)
        texts = decoded(value)
        texts = texts if isinstance(texts, dict) else {}
        context["widget"]["rows"] = self.rows
        context["widget"]["languages"] = [
            {
                "code": code,
                "label": language.own_name,
                "text": self.shown(texts.get(code)),
                "example": self.examples.get(code, ""),
            }
            for code, language in LANGUAGES.items()
        ]
        return context

    def shown(self, text: object) -> str:
        """Return a text as it is edited."""
        return text if isinstance(text, str) else ""

    def kept(self, text: str) -> str:
        """Return an edited text as it is stored."""
        return text.strip()

    def value_from_datadict(self, data: Sent, files: Any, name: str) -> Any:
        """Return the texts that were sent as JSON; empty ones are left out."""
        if not self.sent_names(data, name):
            return data.get(name)
        texts = {code: self.kept(str(data.get(f"{name}_{code}") or "")) for code in LANGUAGES}
        return encoded({code: text for code, text in texts.items() if text})


class Parameters(OwnWidget):
    """The values of the parameters of an action: [["title", "{title}"]]; a script adds inputs."""

    template_name = "parameters.html"

    def get_context(self, name: str, value: Any, attrs: Any) -> dict[str, Any]:
        """Return the names with their values."""
        context = super().get_context(name, value, attrs)
        pairs = decoded(value)
        pairs = pairs if isinstance(pairs, list) else []
        context["widget"]["pairs"] = [
            {"name": pair[0], "value": pair[1]}
            for pair in pairs
            if isinstance(pair, list) and len(pair) == 2
        ]
        return context

    def value_from_datadict(self, data: Sent, files: Any, name: str) -> Any:
        """Return the values that were sent as JSON; empty ones are left out."""
        sent = self.sent_names(data, name)
        if not sent:
            return data.get(name)
        pairs = [[each.partition(".")[2], str(data[each]).strip()] for each in sent if "." in each]
        return encoded([pair for pair in pairs if pair[1]])


class Expected(OwnWidget):
    """What a test captures: {"title": "Hey Brother"}, {} for nothing, null: must not match."""

    template_name = "expected.html"

    def render(
        self, name: str, value: Any, attrs: dict[str, Any] | None = None, renderer: Any = None
    ) -> SafeString:
        """Return its HTML: whether the sentence must match, and the values in one line."""
        wanted = decoded(value)
        match = isinstance(wanted, dict)
        texts = {"name": escape(name), "line": escape(expected_line(wanted) if match else "")}
        return filled(f"{FOLDER}/{self.template_name}", texts, match=match)

    def value_from_datadict(self, data: Sent, files: Any, name: str) -> Any:
        """Return what was sent as JSON; an unreadable line is refused as a wrong name."""
        if f"{name}_must" not in data:
            return data.get(name)
        if data.get(f"{name}_must") != "match":
            return None
        return encoded(expected_values(str(data.get(f"{name}_line") or "")))


def expected_line(values: Mapping[str, object]) -> str:
    """Return values as a line: "title = Hey Brother | level = louder"."""
    return " | ".join(f"{name} = {value}" for name, value in values.items())


def expected_values(line: str) -> dict[str, str]:
    """Return the values of a line; a piece without `=` is named by its own words."""
    found = {}
    for piece in filter(str.strip, line.split("|")):
        name, _equals, value = piece.partition("=")
        found[name.strip()] = value.strip()
    return found


class PriorityChoice(OwnWidget):
    """A priority by its name, or another number."""

    template_name = "priority.html"

    def get_context(self, name: str, value: Any, attrs: Any) -> dict[str, Any]:
        """Return the named priorities and the number."""
        context = super().get_context(name, value, attrs)
        named = str(value) in map(str, PRIORITIES)
        context["widget"]["choices"] = [
            {"number": number, "words": words, "chosen": str(number) == str(value)}
            for number, words in PRIORITIES.items()
        ]
        context["widget"]["number"] = "" if named or value is None else value
        return context

    def value_from_datadict(self, data: Sent, files: Any, name: str) -> Any:
        """Return the number; "other" asks for the one written beside."""
        chosen = data.get(name)
        return data.get(f"{name}_number") if chosen == "other" else chosen


class CultureBoxes(OwnWidget):
    """Cultures to be ticked; none ticked means all. The value is their codes apart by blanks."""

    template_name = "cultures.html"

    def __init__(self, choices: Choices) -> None:
        super().__init__()
        self.choices = choices

    def get_context(self, name: str, value: Any, attrs: Any) -> dict[str, Any]:
        """Return the cultures and which are ticked, unknown ones too."""
        context = super().get_context(name, value, attrs)
        ticked = str(value or "").split()
        known = dict(self.choices())
        codes = [*known, *(code for code in ticked if code not in known)]
        context["widget"]["cultures"] = [
            {"code": code, "words": known.get(code, code), "ticked": code in ticked}
            for code in codes
        ]
        context["widget"]["ticked"] = [known.get(code, code) for code in ticked]
        return context

    def value_from_datadict(self, data: Sent, files: Any, name: str) -> str:
        """Return the codes that were ticked."""
        sent = data.getlist(name) if isinstance(data, MultiValueDict) else [data.get(name) or ""]
        return " ".join(map(str, sent))

    def value_omitted_from_data(self, data: Sent, files: Any, name: str) -> bool:
        """Say no: boxes that are not ticked are not sent."""
        return False


class OneLine(forms.TextInput):
    """A sentence that may be long: it is shown on several lines, but is one."""

    def value_from_datadict(self, data: Sent, files: Any, name: str) -> Any:
        """Return the sentence with blanks in the place of line ends."""
        value = super().value_from_datadict(data, files, name)
        return " ".join(value.splitlines()) if isinstance(value, str) else value


class OpenSelect(forms.Select):
    """A choice that keeps a value which is not among its choices, and asks for them when shown."""

    def __init__(self, choices: Choices) -> None:
        super().__init__()
        self.open_choices = choices

    def optgroups(self, name: str, value: list[str], attrs: Any = None) -> list[Any]:
        """Return the choices, with the value that is none of them at the end."""
        choices: list[Any] = list(self.open_choices())
        known = {
            str(one)
            for first, second in choices
            for one in ([each[0] for each in second] if isinstance(second, list) else [first])
        }
        strange = [(one, one) for one in value if one and one not in known]
        self.choices = [*choices, *strange]
        return super().optgroups(name, value, attrs)
