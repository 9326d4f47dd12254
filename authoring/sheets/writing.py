"""Rows of a sheet → a file: CSV that Excel opens with all its letters, or XLSX."""

import csv
import io
import re
from collections.abc import Iterable, Sequence

from openpyxl import Workbook  # type: ignore[import-untyped]
from openpyxl.cell import WriteOnlyCell  # type: ignore[import-untyped]
from openpyxl.cell.cell import ILLEGAL_CHARACTERS_RE  # type: ignore[import-untyped]
from openpyxl.styles import Alignment, Font, PatternFill  # type: ignore[import-untyped]
from openpyxl.utils import get_column_letter  # type: ignore[import-untyped]

from authoring.sheets.guarding import guarded

CSV, XLSX = "csv", "xlsx"
CONTENT_TYPES = {
    CSV: "text/csv; charset=utf-8",
    XLSX: "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet",
}
_TEXT = "@"
#: Likeliness: a number, so that it can be sorted and counted with.
_NUMBER = re.compile(r"0|1|0\.\d{1,3}")
_HEAD = PatternFill("solid", fgColor="D9EAE8")
_WRAP = Alignment(vertical="top", wrap_text=True)

Lines = Iterable[Sequence[str]]


def written(kind: str, title: str, headers: Sequence[str], lines: Lines) -> bytes:
    """Return the file of a sheet; no program takes a cell of it for a formula."""
    return _csv(headers, lines) if kind == CSV else _xlsx(title, headers, lines)


def _csv(headers: Sequence[str], lines: Lines) -> bytes:
    file = io.StringIO(newline="")
    writer = csv.writer(file)
    writer.writerow(headers)
    writer.writerows([guarded(text) for text in line] for line in lines)
    return file.getvalue().encode("utf-8-sig", "replace")


def _xlsx(title: str, headers: Sequence[str], lines: Lines) -> bytes:
    book = Workbook(write_only=True)
    sheet = book.create_sheet(title)
    sheet.freeze_panes = "B2"
    for place, header in enumerate(headers, 1):
        sheet.column_dimensions[get_column_letter(place)].width = _WIDTHS.get(header, _WIDE)
    sheet.append([_header(sheet, header) for header in headers])
    for line in lines:
        sheet.append([_cell(sheet, text) for text in line])
    file = io.BytesIO()
    book.save(file)
    return file.getvalue()


_WIDE = 44
_WIDTHS = {
    "key": 24,
    "topic": 24,
    "topic or pool": 20,
    "intent": 22,
    "is a": 20,
    "home": 8,
    "type": 6,
    "language": 10,
    "cultures": 12,
    "delete": 8,
    "where": 8,
}


def _header(sheet: object, text: str) -> object:
    cell = WriteOnlyCell(sheet, text)
    cell.font, cell.fill = Font(bold=True), _HEAD
    return cell


def _cell(sheet: object, text: str) -> object:
    if _NUMBER.fullmatch(text):
        return WriteOnlyCell(sheet, float(text))
    cell = WriteOnlyCell(sheet, ILLEGAL_CHARACTERS_RE.sub("", guarded(text)))
    cell.data_type = "s"
    cell.number_format, cell.alignment = _TEXT, _WRAP
    return cell
