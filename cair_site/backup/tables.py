"""Which tables are content, and their rows as plain values.

Content is the draft with its history, intents, releases, conversations, and what the last import
left over. No accounts, passwords, sessions or keys, and nothing that is only a moment's state
(checks, runs of publishing and of imports). Of people there is only the name of the account that
wrote something.
"""

from collections.abc import Iterator, Mapping
from typing import TypeAlias

from django.apps import apps
from django.contrib.auth import get_user_model
from django.core.exceptions import ValidationError
from django.db import connection
from django.db.migrations.recorder import MigrationRecorder
from django.db.models import BinaryField, Field, ForeignKey, Model

from authoring.models import Conversation
from cair_site.backup.file import BackupError, Header, Row, Table
from ontology_io.models import Remainder
from ontology_io.numbering import last_number

Value: TypeAlias = "Field[object, object]"
#: A row may hold a whole release, and is then read alone.
ROWS = 2000


def tables() -> dict[str, type[Model]]:
    """Return the models whose rows are content, by their label."""
    models: list[type[Model]] = [
        model
        for app in ("dialogue", "plans")
        for model in apps.get_app_config(app).get_models(include_auto_created=True)
    ]
    models += [Remainder, Conversation]
    return {model._meta.label_lower: model for model in models}


def header() -> Header:
    """Return what this database would say of itself in the first line of a backup."""
    known = {
        label: Table(
            fields=tuple(field.attname for field in fields(model)), last=last_number(model)
        )
        for label, model in tables().items()
    }
    return Header(migrations=migrations(), tables=known)


def migrations() -> dict[str, tuple[str, ...]]:
    """Return the applied migrations of the apps whose tables are content."""
    own = {model._meta.app_label for model in tables().values()}
    applied = MigrationRecorder(connection).applied_migrations()
    return {app: tuple(sorted(name for at, name in applied if at == app)) for app in sorted(own)}


def fields(model: type[Model]) -> list[Value]:
    """Return the fields of a table, in the order of its rows."""
    return list(model._meta.concrete_fields)


def all_rows() -> Iterator[Row]:
    """Yield the rows of all tables, each with the label of its model at the beginning."""
    people: dict[object, str] = dict(
        get_user_model()._default_manager.values_list("pk", "username")
    )
    for label, model in tables().items():
        own = fields(model)
        names = [field.attname for field in own]
        persons = [place for place, field in enumerate(own, 1) if of_person(field)]
        size = 1 if any(isinstance(field, BinaryField) for field in own) else ROWS
        rows = model._base_manager.order_by("pk").values_list(*names)
        for values in rows.iterator(chunk_size=size):
            row: Row = [label, *values]
            for place in persons:
                row[place] = people.get(row[place])
            yield row


def of_person(field: Value) -> bool:
    """Say whether a field points to an account."""
    return isinstance(field, ForeignKey) and field.related_model is get_user_model()


class Reading:
    """Turns plain values of one table back into what the database stores."""

    def __init__(self, model: type[Model], people: Mapping[str, int]) -> None:
        self.model, self.people = model, people
        self.fields = fields(model)

    def __call__(self, row: Row) -> list[object]:
        """Return the values of a row. Raises BackupError."""
        label, *values = row
        if len(values) != len(self.fields):
            raise BackupError(f"A row of {label} has {len(values)} values.")
        return [
            self._stored(field, value) for field, value in zip(self.fields, values, strict=True)
        ]

    def _stored(self, field: Value, value: object) -> object:
        if of_person(field):
            value = self.people.get(value) if isinstance(value, str) else None
        try:
            value = field.to_python(value)
            return field.get_db_prep_save(value, connection)
        except (ValidationError, ValueError, TypeError, ArithmeticError) as error:
            name = f"{self.model._meta.label_lower}.{field.attname}"
            raise BackupError(f"A value of {name} cannot be read.") from error
