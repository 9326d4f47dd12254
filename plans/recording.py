"""Who changed which row of the draft, and what it said before: one record a row and request.

Only what is written for a person is recorded: inside a request of the admin (see `recorded_for`).
What writes in bulk is wrapped in `in_bulk`; it leaves one line about the whole draft instead.
"""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from decimal import Decimal
from operator import attrgetter
from types import SimpleNamespace
from typing import Any

from django.core.exceptions import ObjectDoesNotExist
from django.db import models
from django.db.models.signals import m2m_changed, pre_save
from django.utils import timezone
from simple_history.models import HistoricalRecords  # type: ignore[import-untyped]

_bulk: ContextVar[bool] = ContextVar("bulk", default=False)


class RecordedChange(models.Model):
    """What our records hold besides the values of the row.

    `place` is the key of what it belongs to (GreenTea.q1), `subject` the number of its topic or
    intent, `change` {"part", "language", "fields": [[name, old, new, old text, new text]], "sets"}.
    """

    change = models.JSONField(default=dict)
    place = models.CharField(max_length=140, blank=True, db_index=True)
    subject = models.IntegerField(null=True, db_index=True)

    class Meta:
        abstract = True


def recording() -> bool:
    """Say whether a row saved now would be recorded."""
    return getattr(HistoricalRecords.context, "request", None) is not None and not _bulk.get()


@contextmanager
def recorded_for(request: object) -> Iterator[None]:
    """Record rows as written by `request.user`."""
    before = getattr(HistoricalRecords.context, "request", None)
    HistoricalRecords.context.request = request
    try:
        yield
    finally:
        HistoricalRecords.context.request = before


@contextmanager
def in_bulk() -> Iterator[None]:
    """Record no single rows: for what writes many at once and tells of it in one line."""
    token = _bulk.set(True)
    try:
        yield
    finally:
        _bulk.reset(token)


def person() -> Any:
    """Return the user for whom rows are written now, None outside of requests."""
    user = getattr(getattr(HistoricalRecords.context, "request", None), "user", None)
    return user if getattr(user, "is_authenticated", False) else None


def _request() -> Any:
    return getattr(HistoricalRecords.context, "request", None) or SimpleNamespace()


def moment() -> Any:
    """Return the time of the change: the same for all rows of one request."""
    request = _request()
    if not hasattr(request, "recorded_at"):
        request.recorded_at = timezone.now()
    return request.recorded_at


def plain(value: object) -> object:
    """Return a value of a row as JSON can hold it."""
    return str(value) if isinstance(value, Decimal) else value


class Recorded(HistoricalRecords):  # type: ignore[misc]
    """The history of a model: `history = Recorded(place="topic.key", subject="topic_id")`.

    `place`, `subject` and `part` are attributes of the row; `sets` its many-to-many fields. With
    `rows=False` nothing is recorded by itself.
    """

    def __init__(
        self,
        place: str = "key",
        *,
        subject: str = "",
        part: str = "",
        sets: Sequence[str] = (),
        rows: bool = True,
    ) -> None:
        super().__init__(bases=[RecordedChange])
        self.place, self.subject, self.part = place, subject, part
        self.sets, self.rows = tuple(sets), rows

    def finalize(self, sender: type[models.Model], **kwargs: Any) -> None:
        """Listen to the rows of the model, before they are written too."""
        super().finalize(sender, **kwargs)
        if sender is not self.cls:
            return
        pre_save.connect(self.before_save, sender=sender, weak=False)
        for field in sender._meta.local_many_to_many:
            if field.name in self.sets:
                through = field.remote_field.through
                m2m_changed.connect(_Linked(self, field.name), sender=through, weak=False)

    def before_save(self, instance: Any, raw: bool = False, **_more: object) -> None:
        """Keep what the row says in the database."""
        if raw or not recording() or not self.rows:
            return
        names = [field.attname for field in instance._meta.concrete_fields]
        rows = type(instance)._base_manager.filter(pk=instance.pk) if instance.pk else None
        instance._before = rows.values(*names).first() if rows is not None else None

    def post_save(self, instance: Any, created: bool, using: Any = None, **kwargs: Any) -> None:
        """Record what was saved, if it differs from what stood there."""
        if kwargs.get("raw") or not recording() or not self.rows:
            return
        before = {} if created else getattr(instance, "_before", None) or {}
        fields = self.differing(instance, before, None if created else instance)
        if created or fields:
            self.note(instance, "+" if created else "~", fields)

    def pre_delete(self, instance: Any, **kwargs: Any) -> None:
        """Keep the sets of a row: they are gone before the row is."""
        if recording() and self.rows:
            super().pre_delete(instance, **kwargs)
            instance._sets = {name: _numbers(getattr(instance, name)) for name in self.sets}

    def post_delete(self, instance: Any, using: Any = None, **kwargs: Any) -> None:
        """Record the whole row that was deleted."""
        if recording() and self.rows:
            fields = [
                [field.name, plain(getattr(instance, field.attname)), None, "", ""]
                for field in instance._meta.concrete_fields
                if _told(field) and not field.remote_field
            ]
            self.note(instance, "-", fields, getattr(instance, "_sets", {}))

    def differing(self, instance: Any, before: dict[str, Any], same: Any) -> list[list[object]]:
        """Return name, old, new, old text, new text of each field that differs."""
        found: list[list[object]] = []
        for field in instance._meta.concrete_fields:
            old = plain(before.get(field.attname))
            new = plain(field.to_python(getattr(instance, field.attname)))
            if not _told(field) or _same(field, old, new) or (same is None and field.remote_field):
                continue
            texts = [_named(field, old), _named(field, new)] if field.remote_field else ["", ""]
            found.append([field.name, old, new, *texts])
        return found

    def note(
        self,
        instance: Any,
        kind: str,
        fields: list[list[object]],
        sets: dict[str, list[int]] | None = None,
    ) -> None:
        """Write the record, or add to the one this request has made of the same row."""
        written = _request().__dict__.setdefault("recorded_rows", {})
        key = (instance._meta.label_lower, instance.pk)
        record = written.get(key) if kind == "~" else None
        if record:
            record.change["fields"] = _joined(record.change["fields"], fields)
        else:
            record = getattr(instance, self.manager_name).model(
                history_date=moment(),
                history_type=kind,
                history_user=person(),
                history_change_reason=getattr(instance, "_change_reason", None),
                place=str(_walk(instance, self.place) or "")[:140],
                subject=_walk(instance, self.subject),
                change={
                    "part": str(_walk(instance, self.part) or ""),
                    "language": getattr(instance, "language", ""),
                    "fields": fields,
                    "sets": sets or {},
                },
            )
        for field in instance._meta.concrete_fields:
            setattr(record, field.attname, getattr(instance, field.attname))
        record.save()
        written[key] = record


class _Linked:
    """Records one many-to-many field of rows."""

    def __init__(self, records: Recorded, name: str) -> None:
        self.records, self.name = records, name

    def __call__(
        self, instance: Any, action: str, pk_set: Any, reverse: bool, **_more: object
    ) -> None:
        """Hear of a change of the set, before and after it."""
        if reverse or not recording():
            return
        now = _numbers(getattr(instance, self.name))
        if action.startswith("pre_"):
            instance.__dict__.setdefault("_set_before", {})[self.name] = now
            return
        old = instance.__dict__.get("_set_before", {}).get(self.name, now)
        if old != now:
            rows = getattr(instance, self.name).model._base_manager.in_bulk({*old, *now})
            texts = [", ".join(str(rows[number]) for number in each) for each in (old, now)]
            self.records.note(instance, "~", [[self.name, old, now, *texts]])


def _numbers(manager: Any) -> list[int]:
    return sorted(manager.values_list("pk", flat=True))


def _told(field: Any) -> bool:
    return bool(field.editable) and not field.primary_key


def _same(field: Any, old: object, new: object) -> bool:
    if isinstance(field, models.DecimalField) and old is not None and new is not None:
        return Decimal(str(old)) == Decimal(str(new))
    return old == new or (old is None and new in ("", [], {}))


def _named(field: Any, number: object) -> str:
    row = field.remote_field.model._base_manager.filter(pk=number).first() if number else None
    return str(row or "")


def _walk(instance: Any, path: str) -> Any:
    try:
        return attrgetter(path)(instance) if path else None
    except (ObjectDoesNotExist, AttributeError):
        return None


def _joined(first: list[list[Any]], then: list[list[Any]]) -> list[list[Any]]:
    """Return both lists of fields as one: what it was at first, what it is at last."""
    known = {row[0]: row for row in first}
    for name, old, new, old_text, new_text in then:
        begin = known.get(name, [name, old, new, old_text, new_text])
        known[name] = [name, begin[1], new, begin[3], new_text]
    return [row for row in known.values() if row[1] != row[2]]
