"""What all sheets share: columns, lines looked up all at once, each judged by itself.

A sheet is a resource of django-import-export whose instances are records (old and new texts), so
that a line is compared and judged without a query and without writing anything.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any, ClassVar

import tablib  # type: ignore[import-untyped]
from django.core.exceptions import ValidationError
from django.utils.functional import Promise
from django.utils.translation import gettext as _
from import_export.fields import Field  # type: ignore[import-untyped]
from import_export.instance_loaders import BaseInstanceLoader  # type: ignore[import-untyped]
from import_export.resources import Resource  # type: ignore[import-untyped]

from authoring.sheets.columns import DELETE, KEY, Choice, Column, note_errors, plain
from authoring.sheets.records import Record
from authoring.sheets.suggesting import Suggestions
from authoring.sheets.tables import Row, Table, UnreadableError

#: The column in which a line carries its number.
LINE = "#line"
_YES = frozenset(("yes", "y", "true", "x", "1", "sì", "si", "vero", "はい"))
_NO = frozenset(("", "no", "n", "false", "0", "いいえ"))


class _Text(Field):  # type: ignore[misc]
    """A cell of a record."""

    def __init__(self, column: Column) -> None:
        super().__init__(attribute=column.name, column_name=column.name)
        self.column = column

    def get_value(self, instance: Record) -> str:
        """Return the text as it goes out."""
        return (instance.old or {}).get(self.column.name, "")

    def save(self, instance: Record, row: Mapping[str, str], *_more: Any, **_named: Any) -> None:
        """Take the text as it came in; ValueError where it cannot be one. A name stays."""
        name = self.column.name
        text, old = row[name], (instance.old or {}).get(name)
        if self.column.is_name or (old is not None and plain(text) == plain(old)):
            return
        instance.new[name] = self.column.tidy(text)


class _LookedUp(BaseInstanceLoader):  # type: ignore[misc]
    """The rows of the draft that a whole sheet is about, read at once."""

    def get_instance(self, row: Mapping[str, str]) -> Record | None:
        """Return the record of a line, None for a new one."""
        found: Record | None = self.resource.find(row)
        return found


class Sheet(Resource):  # type: ignore[misc]
    """One kind of sheet; see the subclasses."""

    name: ClassVar[str]
    title: ClassVar[str | Promise]
    told: ClassVar[str | Promise]
    #: The sheet's own name inside an .xlsx, in every language of the person.
    tab: ClassVar[str]
    #: The models whose permissions it takes to change, add or delete rows: "dialogue.frame".
    writes: ClassVar[tuple[str, ...]]
    deletable: ClassVar[bool] = True
    #: Whether new rows may be added.
    grows: ClassVar[bool] = True
    #: Filters offered: their names in addresses and their labels.
    filters: ClassVar[Mapping[str, str | Promise]] = {}

    class Meta:
        use_bulk = True  # No savepoint for each line: nothing is written here.
        skip_diff = True
        import_id_fields = ()
        instance_loader_class = _LookedUp

    def __init__(self, may: Callable[[str], bool] = lambda _name: True) -> None:
        super().__init__()
        self.may = may
        self.columns = tuple(self.all_columns())
        self.fields = {one.name: _Text(one) for one in self.columns}
        self.records: list[Record] = []

    # What each sheet says about itself.

    def all_columns(self) -> Iterable[Column]:
        """Return the columns in their order, without `delete`."""
        raise NotImplementedError

    def rows(self, chosen: Mapping[str, str]) -> Iterable[Record]:
        """Yield the records of the draft that the filters leave, to be taken out."""
        raise NotImplementedError

    def choices(self, name: str) -> Iterable[Choice]:
        """Return what a filter offers."""
        raise NotImplementedError

    def look_up(self, rows: Sequence[Row]) -> None:
        """Read what the draft says about all lines; called once, before the first."""
        raise NotImplementedError

    def find(self, row: Mapping[str, str]) -> Record | None:
        """Return the record of a line, None for a new one; ValidationError tells what is wrong."""
        raise NotImplementedError

    def begin(self, row: Mapping[str, str]) -> Record:
        """Return the record of a new line."""
        return Record(key=row.get(KEY, "").strip())

    def check(self, record: Record) -> None:
        """Note what is wrong in a line that changes something."""
        raise NotImplementedError

    def check_together(self, records: Sequence[Record]) -> None:
        """Note what is wrong between the lines that change something."""

    def write(self, record: Record) -> None:
        """Make the draft say what a record wants; called inside a transaction, in order."""
        raise NotImplementedError

    def in_order(self, records: Sequence[Record]) -> Sequence[Record]:
        """Return the records in the order in which they can be written."""
        return records

    @property
    def has_key(self) -> bool:
        """Say whether new rows are those without a key."""
        return self.columns[0].name == KEY

    # Out.

    def headers(self, language: str = "") -> tuple[str, ...]:
        """Return the headers of a sheet, those of other languages left out."""
        names = (
            one.name
            for one in self.columns
            if not (language and one.language not in ("", language))
        )
        return (*names, DELETE) if self.deletable else tuple(names)

    def lines(self, chosen: Mapping[str, str]) -> Iterator[list[str]]:
        """Yield the lines to be taken out."""
        headers = self.headers(chosen.get("language", ""))
        fields = [name for name in headers if name != DELETE]
        data = self.export(self.rows(chosen), export_fields=fields)
        for line in data:
            yield [*line, ""] if self.deletable else list(line)

    # In.

    def judge(self, table: Table) -> list[Record]:
        """Return a record for each line, with what it would change and what is wrong in it."""
        self._check_headers(table.headers)
        data = tablib.Dataset(headers=[*table.headers, LINE])
        for row in table.rows:
            data.append([*(row.texts[name] for name in table.headers), str(row.number)])
        self.records, self.given = [], frozenset(table.headers)
        self.faults = {row.number: row.faults for row in table.rows}
        self.look_up(table.rows)
        # A dry run would open a transaction and lock others out; nothing is written anyway.
        result = self.import_data(data, use_transactions=False)
        self._tell_of_failures(result)
        self._refuse_doubles()
        self.check_together([one for one in self.records if one.kind not in ("same", "wrong")])
        self._refuse_unpermitted()
        return self.records

    def _check_headers(self, headers: Sequence[str]) -> None:
        names = [one.name for one in self.columns]
        known = [*names, DELETE] if self.deletable else names
        unknown = [name for name in headers if name not in known]
        if unknown:
            words = _("There is no column “%(name)s” here. Columns: %(known)s.")
            message = words % {"name": unknown[0][:60], "known": ", ".join(known)}
            raise UnreadableError(Suggestions(known).told(message, unknown[0]))
        missing = [one.name for one in self.columns if one.needed and one.name not in headers]
        if missing:
            words = _("The column “%(name)s” is missing. Columns: %(known)s.")
            raise UnreadableError(words % {"name": missing[0], "known": ", ".join(known)})

    def before_import(self, dataset: Any, **_more: Any) -> None:
        """Leave the lines as they are."""

    def init_instance(self, row: Mapping[str, str] | None = None) -> Record:
        """Return the record of a new line."""
        return self.begin(row or {})

    def get_instance(self, instance_loader: _LookedUp, row: Mapping[str, str]) -> Record | None:
        """Return the record that the draft has for a line."""
        try:
            return instance_loader.get_instance(row)
        except ValidationError as error:
            lost = Record(key=row.get(KEY, "").strip()[:140])
            note_errors(lost, error)
            return lost

    def after_init_instance(self, instance: Record, new: bool, row: Any, **_more: Any) -> None:
        """Keep the record; begin with what the draft says."""
        instance.number = int(row[LINE])
        instance.new = {self.columns[0].name: instance.key} | (instance.old or {})
        for fault in self.faults.get(instance.number, ()):
            instance.refuse(fault.column, fault.message)
        self.records.append(instance)

    def for_delete(self, row: Mapping[str, str], instance: Record) -> bool:
        """Say whether the line asks to delete its row."""
        word = row.get(DELETE, "").strip().casefold()
        if word not in _YES | _NO:
            instance.refuse(DELETE, _("Write yes to delete the row, or leave the cell empty."))
        instance.delete = word in _YES
        if instance.delete and instance.old is None and not instance.problems:
            instance.refuse(DELETE, _("There is no such row, so it cannot be deleted."))
        return False  # Deleting is judged like any change, and done when it is saved.

    def import_instance(self, instance: Record, row: Mapping[str, str], **more: Any) -> None:
        """Take over the texts of a line."""
        if not instance.delete:
            super().import_instance(instance, row, **more)

    def skip_row(
        self, instance: Record, _original: Any, _row: Any, import_validation_errors: Any = None
    ) -> bool:
        """Leave a line that changes nothing."""
        return not import_validation_errors and instance.kind in ("same", "wrong")

    def validate_instance(
        self, instance: Record, import_validation_errors: Any = None, validate_unique: bool = True
    ) -> None:
        """Note everything that is wrong in a line."""
        for column, error in (import_validation_errors or {}).items():
            for message in ValidationError(error).messages:
                instance.refuse(column, message)
        if not instance.problems:
            self.check(instance)
        if instance.problems:
            raise ValidationError(
                {one.column or "__all__": one.message for one in instance.problems}
            )

    def save_instance(self, *_more: Any, **_named: Any) -> None:
        """Write nothing: see authoring.sheets.saving."""

    def delete_instance(self, *_more: Any, **_named: Any) -> None:
        """Delete nothing: see authoring.sheets.saving."""

    def _tell_of_failures(self, result: Any) -> None:
        """Refuse the lines that could not be judged at all; the others stand."""
        if result.base_errors:
            raise result.base_errors[0].error
        at = {record.number: record for record in self.records}
        for failed in result.error_rows:
            number = int(failed.errors[0].row[LINE])
            if number not in at:
                self.records.append(Record(key="", number=number))
            record = at.get(number, self.records[-1])
            record.refuse("", _("This line cannot be read. Write it anew."))

    def _refuse_doubles(self) -> None:
        first: dict[str, int] = {}
        for record in self.records:
            if not record.key:
                continue
            if record.key in first:
                words = _("%(key)s stands in line %(line)d already. Remove one of the two.")
                record.refuse(
                    self.columns[0].name, words % {"key": record.key, "line": first[record.key]}
                )
            first.setdefault(record.key, record.number)

    def _refuse_unpermitted(self) -> None:
        verbs = {
            "new": ("add", _("You may not add rows here.")),
            "changed": ("change", _("You may not change rows here.")),
            "deleted": ("delete", _("You may not delete rows here.")),
        }
        may = {
            kind: all(self.may(_permission(one, verb)) for one in self.writes)
            for kind, (verb, _words) in verbs.items()
        }
        for record in self.records:
            kind = record.kind
            if not may.get(kind, True):
                record.refuse("", verbs[kind][1])


def _permission(model: str, verb: str) -> str:
    app, _point, name = model.partition(".")
    return f"{app}.{verb}_{name}"
