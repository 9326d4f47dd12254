"""Files that people bring → tables: CSV and XLSX, every other kind refused with what to do."""

import csv
import io
from collections.abc import Iterable, Iterator, Sequence

from django.utils.translation import gettext as _

from authoring.sheets import limits
from authoring.sheets.guarding import unguarded
from authoring.sheets.reading_xlsx import Cell, xlsx_lines
from authoring.sheets.tables import Fault, Row, Table, UnreadableError

_ZIP, _OLD_EXCEL = b"PK\x03\x04", b"\xd0\xcf\x11\xe0"
_DELIMITERS = (",", ";", "\t")
_BEGINS_FORMULA = ("=", "＝")


def read_table(name: str, data: bytes, known: Sequence[str], title: str) -> Table:
    """Return the table of a file; `known` are the columns expected, `title` names its sheet.

    UnreadableError for what is no such file, is too large, or lacks a line of headers.
    """
    ending = name.lower().rpartition(".")[2]
    if ending == "xlsm":
        raise UnreadableError(_("The file may hold macros. Save it as .xlsx or CSV UTF-8."))
    if data.startswith(_OLD_EXCEL):
        raise UnreadableError(_("This is an old or locked Excel file. Save it as .xlsx."))
    if data.startswith(_ZIP):
        return _table(xlsx_lines(data, title), known)
    if ending in ("xlsx", "xls", "ods", "numbers"):
        raise UnreadableError(_("This is no .xlsx file. Save it as .xlsx or CSV UTF-8."))
    return _table(_csv_lines(data, known), known)


def _csv_lines(data: bytes, known: Sequence[str]) -> Iterator[tuple[int, Sequence[Cell]]]:
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        words = _("The letters cannot be read. Save it as CSV UTF-8 or as XLSX.")
        raise UnreadableError(words) from error
    if "\0" in text:
        raise UnreadableError(_("This is no text. Save it as CSV UTF-8 or as XLSX."))
    head = text.partition("\n")[0]
    delimiter = max(_DELIMITERS, key=lambda sign: len(_names(head.split(sign), known)))
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=delimiter, strict=True)
    number = 1
    try:
        for texts in reader:
            yield number, [_csv_cell(text) for text in texts[: limits.MOST_COLUMNS]]
            number = reader.line_num + 1
    except csv.Error as error:
        words = _("Line %(n)d cannot be read: a quote is not closed, or a cell is too long.")
        raise UnreadableError(words % {"n": number}) from error


def _csv_cell(text: str) -> Cell:
    if text.startswith(_BEGINS_FORMULA):
        words = _("This is a formula. Write its text, or ' before it if it is one.")
        return Cell(text, words)
    return Cell(text)


def _names(texts: Iterable[str], known: Sequence[str]) -> set[str]:
    """Return those of the texts that are names of columns."""
    return {header_of(text) for text in texts} & set(known)


def header_of(text: str) -> str:
    """Return a header as it is compared: quotes, capitals and outer blanks do not count."""
    return " ".join(text.strip().strip('"').split()).casefold()


def _table(lines: Iterable[tuple[int, Sequence[Cell]]], known: Sequence[str]) -> Table:
    folded = {header_of(name): name for name in known}
    headers: list[str] | None = None
    rows: list[Row] = []
    for number, cells in lines:
        if number > limits.MOST_SCANNED:
            raise UnreadableError(_("The sheet has too many blank lines. Remove them."))
        if not any(cell.text.strip() for cell in cells):
            continue
        if headers is None:
            found = [header_of(unguarded(cell.text)) for cell in cells]
            headers = [folded.get(name, name) for name in found]
            _check_headers(headers)
            continue
        rows.append(_row(number, cells, headers))
        if len(rows) > limits.limit("CAIR_SHEET_ROWS"):
            words = _("The sheet has more than %(n)d rows. Bring a part of it, e.g. one branch.")
            raise UnreadableError(words % {"n": limits.limit("CAIR_SHEET_ROWS")})
    if headers is None:
        raise UnreadableError(_("The sheet is empty. Its first line must name the columns."))
    return Table(tuple(name for name in headers if name), tuple(rows))


def _check_headers(headers: Sequence[str]) -> None:
    named = [name for name in headers if name]
    twice = sorted({name for name in named if named.count(name) > 1})
    if twice:
        words = _("The column “%(name)s” is there twice. Remove one of them.")
        raise UnreadableError(words % {"name": twice[0][:60]})


def _row(number: int, cells: Sequence[Cell], headers: Sequence[str]) -> Row:
    texts, faults = {}, []
    for name, cell in zip(headers, cells, strict=False):
        if not name:
            continue
        if len(cell.text) > limits.LONGEST_CELL:
            words = _("The cell has %(n)d characters. That is too long.") % {"n": len(cell.text)}
            faults.append(Fault(name, words))
        elif cell.fault:
            faults.append(Fault(name, cell.fault))
        texts[name] = unguarded(cell.text[: limits.LONGEST_CELL])
    missing = dict.fromkeys((name for name in headers if name), "")
    return Row(number, missing | texts, tuple(faults))
