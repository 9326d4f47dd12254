"""What a sheet would change, ready to be shown; and what is sent along to be saved."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from django.core import signing
from django.utils.translation import gettext as _

from authoring.sheets.columns import Column
from authoring.sheets.records import CHANGED, DELETED, NEW, SAME, WRONG, Record
from authoring.sheets.saving import changing, seen
from authoring.sheets.sheet import Sheet
from authoring.sheets.tables import Row, Table, UnreadableError
from authoring.word_marks import Piece, word_marks

_SALT = "authoring.sheets"
_VALID_SECONDS = 24 * 3600
#: Django takes 5 MB of a form; the rest of it is small.
LONGEST_SENT = 4_500_000


@dataclass(frozen=True, slots=True)
class ShownCell:
    """One cell: its text in pieces (same, gone, come), what is wrong in it."""

    column: str
    language: str
    pieces: tuple[Piece, ...]
    changed: bool
    problems: tuple[str, ...]

    @property
    def empty(self) -> bool:
        """Say whether there is nothing to read."""
        return not any(piece.text for piece in self.pieces)


@dataclass(frozen=True, slots=True)
class ShownRow:
    """One line: its number in the sheet, what becomes of it, its cells, what is wrong in it all."""

    number: int
    kind: str
    key: str
    cells: tuple[ShownCell, ...]
    problems: tuple[str, ...]
    note: str


@dataclass(frozen=True, slots=True)
class Preview:
    """All lines that are not as they were, those with mistakes apart; `counts` by kind."""

    columns: tuple[str, ...]
    wrong: tuple[ShownRow, ...]
    changes: tuple[ShownRow, ...]
    counts: dict[str, int]


def preview(sheet: Sheet, table: Table, records: Sequence[Record]) -> Preview:
    """Return what records would change, as lines with marks."""
    told = [record for record in records if record.kind != SAME]
    columns = [
        one
        for one in sheet.columns
        if one.is_name
        or (one.name in table.headers and any(_says(each, one.name) for each in told))
    ]
    shown = [_shown(record, columns) for record in told]
    counts = dict.fromkeys((NEW, CHANGED, DELETED, SAME, WRONG), 0)
    for record in records:
        counts[record.kind] += 1
    return Preview(
        columns=tuple(one.name for one in columns),
        wrong=tuple(row for row in shown if row.kind == WRONG),
        changes=tuple(row for row in shown if row.kind != WRONG),
        counts=counts,
    )


def _says(record: Record, column: str) -> bool:
    """Say whether a line has something to show in a column: empty columns are left out."""
    texts = (record.new.get(column), (record.old or {}).get(column))
    return any(texts) or any(one.column == column for one in record.problems)


def _shown(record: Record, columns: Iterable[Column]) -> ShownRow:
    cells = tuple(_cell(record, column) for column in columns)
    placed = {cell.column for cell in cells}
    elsewhere = (one.message for one in record.problems if one.column not in placed)
    return ShownRow(record.number, record.kind, record.key, cells, tuple(elsewhere), record.note)


def _cell(record: Record, column: Column) -> ShownCell:
    old = (record.old or {}).get(column.name, "")
    new = "" if record.delete else record.new.get(column.name, "")
    problems = tuple(one.message for one in record.problems if one.column == column.name)
    pieces = tuple(word_marks(old, new)) if old != new else (Piece("same", new),)
    return ShownCell(column.name, column.language, pieces, old != new, problems)


def sealed(sheet: Sheet, table: Table, records: Sequence[Record], person: int) -> str:
    """Return the lines that change something, to be sent along and saved by this person alone.

    "" where nothing changes. Raises UnreadableError where that is too much for one form.
    """
    kept = changing(records)
    if not kept:
        return ""
    numbers = {record.number for record in kept}
    rows = [row for row in table.rows if row.number in numbers]
    content = {
        "sheet": sheet.name,
        "person": person,
        "headers": table.headers,
        "rows": [[row.number, [row.texts[name] for name in table.headers]] for row in rows],
        "seen": seen(kept),
    }
    text = signing.dumps(content, salt=_SALT, compress=True)
    if len(text) > LONGEST_SENT:
        raise UnreadableError(_("The sheet changes too much at once. Bring a part of it."))
    return text


def unsealed(sheet: Sheet, text: str, person: int) -> tuple[Table, str]:
    """Return the lines that were sent along and what was seen of them.

    Raises UnreadableError where they are damaged, too old or somebody else's.
    """
    try:
        content: dict[str, Any] = signing.loads(text, salt=_SALT, max_age=_VALID_SECONDS)
    except signing.BadSignature as error:
        words = _("The preview is too old or damaged, so nothing was saved. Bring the sheet again.")
        raise UnreadableError(words) from error
    if content["sheet"] != sheet.name or content["person"] != person:
        raise UnreadableError(_("This preview is not yours. Bring the sheet again."))
    headers = tuple(content["headers"])
    rows = tuple(
        Row(number, dict(zip(headers, texts, strict=True))) for number, texts in content["rows"]
    )
    return Table(headers, rows), content["seen"]
