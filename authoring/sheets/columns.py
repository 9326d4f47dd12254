"""What sheets are made of: columns, filters, and the words for what is wrong."""

from collections.abc import Callable, Mapping
from typing import NamedTuple

from django.core.exceptions import ValidationError
from django.utils.translation import override

from authoring.sheets.records import Record
from authoring.topic_page.words import LANGUAGE_NAMES

KEY, DELETE = "key", "delete"
Tidy = Callable[[str], str]


def plain(text: str) -> str:
    """Return a text as forms keep it: no outer blanks, one kind of line end."""
    return text.replace("\r\n", "\n").replace("\r", "\n").strip()


def language_word(code: str) -> str:
    """Return what columns call a language: its English name, whatever the person's language."""
    with override("en"):
        return str(LANGUAGE_NAMES.get(code, code))


class Column(NamedTuple):
    """A column: its header, how its texts are compared, whether each sheet must have it.

    `language` is that of its texts; `is_name` says that it tells which row a line is about.
    """

    name: str
    tidy: Tidy = plain
    needed: bool = False
    language: str = ""
    is_name: bool = False

    def stored(self, text: str) -> str:
        """Return a text of the draft as it is compared, one that cannot be tidied as it is."""
        try:
            return self.tidy(text)
        except ValueError:
            return plain(text)


class Choice(NamedTuple):
    """One thing to filter by: what the address says and what people read."""

    value: str
    title: str


def note_errors(
    record: Record,
    error: ValidationError,
    columns: Mapping[str, str] | None = None,
    otherwise: str = "",
) -> None:
    """Note what a row's own validation says; `columns` are those of its fields, None: the same."""
    if hasattr(error, "error_dict"):
        for name, messages in error.message_dict.items():
            for message in messages:
                record.refuse(name if columns is None else columns.get(name, otherwise), message)
    else:
        for message in error.messages:
            record.refuse(otherwise, message)
