"""Fields of value lists and phrases: one line a word, in place of JSON."""

from typing import Any

from authoring.intent_page.widgets import LanguageTexts, OwnWidget, Sent, decoded, encoded
from languages.known import LANGUAGES

BLANK_ROWS = 2
MOST_ROWS = 200


class WordsByValue(OwnWidget):
    """The words of each value in each language: {"en": {"louder": ["louder", "up"]}}."""

    template_name = "words_by_value.html"

    def get_context(self, name: str, value: Any, attrs: Any) -> dict[str, Any]:
        """Return a row for each value, and a few empty ones."""
        context = super().get_context(name, value, attrs)
        lists = decoded(value)
        lists = lists if isinstance(lists, dict) else {}
        words = {code: lists[code] for code in LANGUAGES if isinstance(lists.get(code), dict)}
        values = list(dict.fromkeys(one for texts in words.values() for one in texts))
        context["widget"]["languages"] = [
            {"code": code, "label": language.own_name} for code, language in LANGUAGES.items()
        ]
        context["widget"]["lines"] = [
            {
                "value": one,
                "cells": [
                    {
                        "code": code,
                        "label": language.own_name,
                        "words": _lines(words.get(code, {}).get(one)),
                    }
                    for code, language in LANGUAGES.items()
                ],
            }
            for one in [*values, *[""] * BLANK_ROWS]
        ]
        return context

    def value_from_datadict(self, data: Sent, files: Any, name: str) -> Any:
        """Return the words that were sent as JSON; empty lines are left out."""
        if not self.sent_names(data, name):
            return data.get(name)
        found: dict[str, dict[str, list[str]]] = {}
        for row in range(MOST_ROWS):
            if f"{name}_{row}_value" not in data:
                break
            value = str(data.get(f"{name}_{row}_value") or "").strip()
            for code in LANGUAGES:
                words = _words(str(data.get(f"{name}_{row}_{code}") or ""))
                if words:
                    found.setdefault(code, {}).setdefault(value, []).extend(words)
        return encoded(found)


def _lines(words: object) -> str:
    return "\n".join(map(str, words)) if isinstance(words, list) else ""


def _words(text: str) -> list[str]:
    """Return the words of an input: one a line, or apart by `|`."""
    return [word.strip() for word in text.replace("|", "\n").splitlines() if word.strip()]


class Wordings(LanguageTexts):
    """The wordings of a phrase in each language, one a line: {"en": "please|could you"}."""

    def __init__(self) -> None:
        super().__init__({}, rows=6)

    def shown(self, text: object) -> str:
        """Return a pattern with each of its outer choices on a line."""
        return "\n".join(outer_choices(text)) if isinstance(text, str) else ""

    def kept(self, text: str) -> str:
        """Return the lines as one pattern."""
        return "|".join(line.strip() for line in text.splitlines() if line.strip())


def outer_choices(pattern: str) -> list[str]:
    """Return what stands between the `|` outside brackets: a pattern cut into its choices."""
    found, depth = [""], 0
    for sign in pattern:
        depth += (sign in "([") - (sign in ")]")
        if sign == "|" and depth <= 0:
            found.append("")
        else:
            found[-1] += sign
    return found
