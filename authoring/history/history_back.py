"""Going back: take one change of a row back, bring a deleted row back with its parts."""

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

from django.core.exceptions import ObjectDoesNotExist, ValidationError
from django.db import IntegrityError, models, transaction
from django.utils.translation import gettext as _

from authoring.history.history import DELETED, FieldChange, models_with_history, records_of
from authoring.history.history_words import field_name, named, spoken
from dialogue.authoring import give_likeliness, rename_frames
from dialogue.models import Topic


class CannotGoBackError(ValueError):
    """The change can no longer be taken back; the message says why, in words for experts."""


@dataclass(frozen=True, slots=True)
class Preview:
    """What going back would do: what stands there now (old) and what would stand there (new)."""

    what: str
    brings_back: bool
    fields: tuple[FieldChange, ...]


def find(label: str, number: int) -> tuple[type[models.Model], Any]:
    """Return a model and one record of its history. Raises ObjectDoesNotExist."""
    model = models_with_history().get(label)
    if model is None:
        raise ObjectDoesNotExist(label)
    return model, records_of(model).get(pk=number)


def permission(model: type[models.Model], record: Any) -> str:
    """Return what one must be allowed to do to go back."""
    verb = "add" if record.history_type == DELETED else "change"
    return f"{model._meta.app_label}.{verb}_{model._meta.model_name}"


def preview(model: type[models.Model], record: Any) -> Preview:
    """Return what going back would do. Raises CannotGoBackError."""
    what = named(model._meta.label_lower, record.__dict__)
    if record.history_type == DELETED:
        _refuse_missing_owner(model, record)
        texts = [(name, "", spoken(old)) for name, old, *_rest in record.change["fields"]]
    else:
        row = _row(model, record)
        texts = [
            (name, _text_now(row, name), old_text or spoken(old))
            for name, old, _new, old_text, _new_text in _went(record)
        ]
    fields = (FieldChange(field_name(model, name), now, then) for name, now, then in texts)
    shown = tuple(one for one in fields if one.old != one.new)
    return Preview(what=what, brings_back=record.history_type == DELETED, fields=shown)


def go_back(model: type[models.Model], record: Any) -> models.Model:
    """Take a change back, as a new change; return the row. Raises CannotGoBackError."""
    try:
        with transaction.atomic():
            row = (
                _bring_back(model, record)
                if record.history_type == DELETED
                else _undo(model, record)
            )
            _keep_in_step(row)
            return row
    except ValidationError as error:
        reason = " ".join(error.messages)
        raise CannotGoBackError(_("It no longer fits: %(reason)s") % {"reason": reason}) from error
    except IntegrityError as error:
        raise CannotGoBackError(_("It no longer fits what stands there now.")) from error


def _went(record: Any) -> list[list[Any]]:
    fields: list[list[Any]] = record.change.get("fields", [])
    if record.history_type != "~" or not fields:
        raise CannotGoBackError(_("There is nothing to go back to: the row was made then."))
    return fields


def _row(model: type[models.Model], record: Any) -> Any:
    row = model._default_manager.filter(pk=record.id).first()
    if row is None:
        raise CannotGoBackError(_("It has been deleted since. Bring it back first."))
    return row


def _text_now(row: Any, name: str) -> str:
    field = row._meta.get_field(name)
    if field.many_to_many:
        return ", ".join(map(str, getattr(row, name).all()))
    if field.remote_field:
        return str(getattr(row, name) or "")
    value = getattr(row, name)
    return spoken(value if isinstance(value, bool | int | str | dict | list) else str(value))


def _undo(model: type[models.Model], record: Any) -> models.Model:
    row = _row(model, record)
    sets = {}
    for name, old, *_rest in _went(record):
        field = model._meta.get_field(name)
        if field.many_to_many:
            sets[name] = old
        else:
            setattr(row, getattr(field, "attname", name), old)
    _refuse_gone(row)
    row.full_clean()
    row._change_reason = "back"
    row.save()
    _set(row, sets)
    return row  # type: ignore[no-any-return]


def _set(row: Any, sets: dict[str, list[int]]) -> None:
    for name, numbers in sets.items():
        manager = getattr(row, name)
        manager.set(manager.model._default_manager.filter(pk__in=numbers))


def _refuse_gone(row: Any) -> None:
    """Refuse a link to a row that is no longer there, by what it was."""
    for field in row._meta.concrete_fields:
        number = getattr(row, field.attname)
        if field.remote_field and number is not None:
            there = field.remote_field.model._default_manager.filter(pk=number).exists()
            if not there:
                told = {"what": str(field.verbose_name)}
                raise CannotGoBackError(
                    _("What it belongs to (%(what)s) is no longer there. Bring that back first.")
                    % told
                )


def _refuse_missing_owner(model: type[models.Model], record: Any) -> None:
    if model._default_manager.filter(pk=record.id).exists():
        raise CannotGoBackError(_("It is there again already."))
    _refuse_gone(_from_record(model, record))


def _from_record(model: type[models.Model], record: Any) -> Any:
    fields = model._meta.concrete_fields
    return model(**{field.attname: getattr(record, field.attname) for field in fields})


def _bring_back(model: type[models.Model], record: Any) -> models.Model:
    _refuse_missing_owner(model, record)
    row = _from_record(model, record)
    row.full_clean(exclude=["id"])
    row._change_reason = "back"
    row.save(force_insert=True)
    for part, each in _parts(model, record):
        with suppress(CannotGoBackError):  # A link whose other end is gone stays away.
            _bring_back(part, each)
    _set(row, record.change.get("sets", {}))
    return row  # type: ignore[no-any-return]


def _parts(model: type[models.Model], record: Any) -> Iterator[tuple[type[models.Model], Any]]:
    """Yield what was deleted together with a row because it belonged to it."""
    for part in models_with_history().values():
        for link in part._meta.concrete_fields:
            if link.remote_field and link.remote_field.model is model and _cascades(link):
                same = {"history_type": DELETED, "history_date": record.history_date}
                rows = records_of(part).filter(**same, **{link.attname: record.id})
                for each in rows.order_by("history_id"):
                    yield part, each


def _cascades(link: Any) -> bool:
    return link.remote_field.on_delete is models.CASCADE


def _keep_in_step(row: models.Model) -> None:
    if isinstance(row, Topic):
        give_likeliness(row)
        rename_frames(row)
