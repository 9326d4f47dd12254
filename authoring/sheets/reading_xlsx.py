"""Read an .xlsx as far as it is safe: no macros, no formulas, no file that unpacks without end."""

import io
import zipfile
import zlib
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import date, datetime, time, timedelta
from typing import Any
from xml.etree.ElementTree import ParseError

import openpyxl  # type: ignore[import-untyped]
from django.utils.translation import gettext as _
from openpyxl.utils.exceptions import InvalidFileException  # type: ignore[import-untyped]

from authoring.sheets import limits
from authoring.sheets.tables import UnreadableError

MOST_PARTS = 500
_MACROS = ("vbaproject", "macrosheets/")
_BROKEN = (
    zipfile.BadZipFile,
    zlib.error,
    ParseError,
    InvalidFileException,
    ValueError,
    TypeError,
    KeyError,
    IndexError,
    AttributeError,
    EOFError,
    NotImplementedError,
    RuntimeError,
    OSError,
    AssertionError,
    OverflowError,
    RecursionError,
)


@dataclass(frozen=True, slots=True)
class Cell:
    """One cell as text; `fault` says why its text cannot be taken."""

    text: str
    fault: str = ""


def xlsx_lines(data: bytes, title: str) -> Iterator[tuple[int, Sequence[Cell]]]:
    """Yield number and cells of each line: of the sheet with this title, else of the first."""
    with _as_a_sentence():
        _look_inside(data)
        book = openpyxl.load_workbook(io.BytesIO(data), read_only=True, keep_links=False)
        sheets = {sheet.title.casefold(): sheet for sheet in book.worksheets}
        if not sheets:
            raise UnreadableError(_("The file has no sheet."))
        sheet = sheets.get(title.casefold()) or book.worksheets[0]
        sheet.reset_dimensions()
        rows = sheet.iter_rows(max_col=limits.MOST_COLUMNS)
        for number, cells in enumerate(rows, 1):
            yield number, [_cell(cell) for cell in cells]


@contextmanager
def _as_a_sentence() -> Iterator[None]:
    try:
        yield
    except UnreadableError:
        raise
    except _BROKEN as error:
        raise UnreadableError(_("The file is damaged. Save it again as .xlsx.")) from error


def _look_inside(data: bytes) -> None:
    """Refuse macros, locked files, and what would unpack to more than a sheet can need."""
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        parts = archive.infolist()
        inflated = sum(part.file_size for part in parts)
        if len(parts) > MOST_PARTS or inflated > limits.limit("CAIR_SHEET_INFLATED"):
            raise UnreadableError(_("The file unpacks to far too much. Bring a part of it."))
        names = [part.filename.lower() for part in parts]
        if any(word in name for name in names for word in _MACROS):
            raise UnreadableError(_("The file holds macros. Save it as .xlsx or CSV UTF-8."))
        if "xl/workbook.xml" not in names:
            raise UnreadableError(_("This is no .xlsx file. Save it as .xlsx or CSV UTF-8."))


def _cell(cell: Any) -> Cell:
    value = cell.value
    kind = getattr(cell, "data_type", "n")
    if kind == "f":
        return Cell(str(value), _("This is a formula. Put its value in the cell as text."))
    if kind == "e":
        return Cell(str(value), _("The cell shows an error (%s). Write its text.") % value)
    if isinstance(value, datetime | date | time | timedelta):
        words = _("The program made a date or time of it. Format the cell as text, write it again.")
        return Cell(str(value), words)
    return Cell(_text(value))


def _text(value: object) -> str:
    if value is None:
        return ""
    if isinstance(value, bool):
        return "yes" if value else "no"
    # 0.1 + 0.2 in a sheet is 0.30000000000000004 in its file.
    return f"{value:.10g}" if isinstance(value, float) else str(value)
