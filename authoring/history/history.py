"""The history of the draft: who changed what, when, and what it said before.

All models of the draft are asked in one query, whatever the number of changes shown.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import datetime
from typing import Any

from django.apps import apps
from django.contrib.auth import get_user_model
from django.db.models import Model, Q, QuerySet, Value

from authoring.history.history_words import headline, told_fields

CREATED, CHANGED, DELETED = "+", "~", "-"
APPS = ("dialogue", "plans")
COLUMNS = (
    "history_id",
    "id",
    "history_date",
    "history_user_id",
    "history_type",
    "history_change_reason",
    "place",
    "subject",
    "change",
)


@dataclass(frozen=True, slots=True)
class FieldChange:
    """One field of a change: its name in words, the old text and the new one."""

    name: str
    old: str
    new: str


@dataclass(frozen=True, slots=True)
class Change:
    """One change of one row. `record` is the number of its record in the history of the model."""

    model: str
    record: int
    row: int
    when: datetime
    person: str
    kind: str
    words: str
    reason: str
    place: str
    fields: tuple[FieldChange, ...]

    @property
    def can_go_back(self) -> bool:
        """Say whether it has an earlier state: a row that was made is deleted on its page."""
        return self.kind == DELETED or (self.kind == CHANGED and bool(self.fields))


@dataclass(frozen=True, slots=True)
class Wanted:
    """Which changes: all that is None or empty is not asked for.

    `topic` is the key of a topic, a sentence or an intent, its parts included.
    """

    person: int | None = None
    since: datetime | None = None
    until: datetime | None = None
    model: str = ""
    topic: str = ""
    #: For the history of rows: by model, which records.
    rows: Mapping[str, Q] = field(default_factory=dict)

    def condition(self) -> Q:
        """Return what every record must fulfil."""
        found = Q()
        if self.person is not None:
            found &= Q(history_user_id=self.person)
        if self.since:
            found &= Q(history_date__gte=self.since)
        if self.until:
            found &= Q(history_date__lt=self.until)
        if self.topic:
            found &= Q(place=self.topic) | Q(place__startswith=f"{self.topic}.")
        return found


def models_with_history() -> dict[str, type[Model]]:
    """Return the models by the name that addresses and records use: dialogue.topic."""
    return {
        model._meta.label_lower: model
        for app in APPS
        for model in apps.get_app_config(app).get_models()
        if hasattr(model._meta, "simple_history_manager_attribute")
    }


def records_of(model: type[Model]) -> QuerySet[Any]:
    """Return all records of the history of a model."""
    manager: Any = model.history  # type: ignore[attr-defined]
    rows: QuerySet[Any] = manager.model._default_manager.all()
    return rows


def changes(wanted: Wanted, start: int = 0, stop: int = 50) -> list[Change]:
    """Return changes, the latest first; two queries."""
    found = _union(wanted)
    if found is None:
        return []
    rows = list(found.order_by("-history_date", "label", "-history_id")[start:stop])
    people = _people(row["history_user_id"] for row in rows)
    return [_change(row, people) for row in rows]


def count(wanted: Wanted) -> int:
    """Return how many changes there are; one query."""
    found = _union(wanted)
    return 0 if found is None else found.count()


def history_of(row: Model) -> Wanted:
    """Return what to ask for the history of a row and of all its parts."""
    label, number = row._meta.label_lower, row.pk
    own = {label: Q(id=number)}
    if label in ("dialogue.topic", "plans.intent"):
        app = row._meta.app_label
        parts = [name for name in models_with_history() if name.startswith(f"{app}.")]
        whole = {name: Q(subject=number) for name in parts if name not in _WITHOUT_SUBJECT}
        return Wanted(rows=whole | own)
    for name, model in models_with_history().items():
        for link in model._meta.concrete_fields:
            if link.remote_field and link.remote_field.model is type(row) and name in _PARTS:
                own[name] = Q(**{link.attname: number})
    return Wanted(rows=own)


_WITHOUT_SUBJECT = frozenset(
    ("dialogue.culture", "dialogue.draftversion", "plans.phrase", "plans.valuelist")
)
_PARTS = frozenset(("dialogue.sentence",))


def _union(wanted: Wanted) -> Any:
    """Return one query over the histories of all models; None where none is asked for."""
    queries = []
    for label, model in models_with_history().items():
        if wanted.model and label != wanted.model:
            continue
        if wanted.rows and label not in wanted.rows:
            continue
        condition = wanted.condition() & wanted.rows.get(label, Q())
        rows = records_of(model).order_by().filter(condition)
        queries.append(rows.annotate(label=Value(label)).values("label", *COLUMNS))
    if not queries:
        return None
    return queries[0].union(*queries[1:], all=True)


def _people(numbers: Iterable[int | None]) -> dict[int, str]:
    users = get_user_model()._default_manager.in_bulk({one for one in numbers if one})
    return {number: user.get_full_name() or user.get_username() for number, user in users.items()}


def _change(row: Mapping[str, Any], people: Mapping[int, str]) -> Change:
    model = models_with_history()[row["label"]]
    person = people.get(row["history_user_id"], "")
    fields: Sequence[tuple[str, str, str]] = told_fields(model, row["change"])
    return Change(
        model=row["label"],
        record=row["history_id"],
        row=row["id"],
        when=row["history_date"],
        person=person,
        kind=row["history_type"],
        words=headline(row, person),
        reason=row["history_change_reason"] or "",
        place=row["place"],
        fields=tuple(FieldChange(*one) for one in fields),
    )
