"""Two people on one page: whoever saves second is told, and decides.

A form carries a digest of its row and parts as they were shown. When it comes back and the digest
is another one by then, nothing is saved: a page shows both texts.
"""

import hashlib
import json
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from django import forms
from django.db.models import Model
from django.http import QueryDict
from django.utils.translation import gettext as _

#: The hidden field of the digest.
SEEN = "draft_seen"
#: Buttons and fields of the page itself: no text of the person.
_NOT_TEXT = frozenset(("csrfmiddlewaretoken", SEEN))
LONGEST_SHOWN = 2000


@dataclass(frozen=True, slots=True)
class Difference:
    """One field: where it is, what stands there now, what the person wrote."""

    where: str
    now: str
    mine: str


def digest(row: Model, sets: Mapping[str, Iterable[int]], parts: Iterable[Model]) -> str:
    """Return what a row, its sets and its parts come to: 64 letters, equal for equal texts."""
    values = [
        _values(row),
        {name: sorted(numbers) for name, numbers in sorted(sets.items())},
        sorted(([part._meta.label_lower, *_values(part)] for part in parts), key=str),
    ]
    text = json.dumps(values, ensure_ascii=False, sort_keys=True, default=str)
    return hashlib.sha256(text.encode("utf-8", "surrogatepass")).hexdigest()


def _values(row: Model) -> list[object]:
    return [
        field.get_prep_value(field.to_python(getattr(row, field.attname)))
        if field.get_internal_type() == "DecimalField"
        else getattr(row, field.attname)
        for field in row._meta.concrete_fields
    ]


def rebased(data: QueryDict, prefix: str, there: set[str], key: str = "id") -> QueryDict:
    """Return posted forms with rows that are gone by now as new rows, so that they can be saved.

    `there` holds the numbers of the rows that still are. Kept rows come first, as Django wants it.
    """
    total = _number(data.get(f"{prefix}-TOTAL_FORMS"))
    initial = min(_number(data.get(f"{prefix}-INITIAL_FORMS")), total)
    kept = [i for i in range(initial) if data.get(f"{prefix}-{i}-{key}") in there]
    if len(kept) == initial:
        return data
    order = [*kept, *(i for i in range(total) if i not in kept)]
    moved = data.copy()
    for name in [name for name in moved if _place(name, prefix) is not None]:
        del moved[name]
    for new, old in enumerate(order):
        begin = f"{prefix}-{old}-"
        for name in [name for name in data if name.startswith(begin)]:
            moved.setlist(f"{prefix}-{new}-{name.removeprefix(begin)}", data.getlist(name))
        if old not in kept:
            moved[f"{prefix}-{new}-{key}"] = ""
    moved[f"{prefix}-INITIAL_FORMS"] = str(len(kept))
    return moved


def _number(text: str | None) -> int:
    return min(int(text), 1000) if text and text.isdecimal() and len(text) < 6 else 0


def _place(name: str, prefix: str) -> str | None:
    begin, middle, _field = name.removeprefix(f"{prefix}-").partition("-")
    return begin if name.startswith(f"{prefix}-") and middle and begin.isdecimal() else None


def form_differences(form: Any, where: str = "") -> Iterator[Difference]:
    """Yield each field in which a posted form differs from what stands there now."""
    for name in form.changed_data:
        if name in form.fields and not isinstance(form.fields[name].widget, forms.HiddenInput):
            field = form.fields[name]
            label = str(field.label or name)
            yield Difference(
                where=f"{where}: {label}" if where else label,
                now=shown(field, form.get_initial_for_field(field, name)),
                mine=shown(field, form[name].value()),
            )


def formset_differences(formset: Any) -> Iterator[Difference]:
    """Yield each difference of the parts: changed, new, deleted by one or the other."""
    title = str(formset.model._meta.verbose_name)
    posted = set()
    for form in formset.forms:
        row = form.instance if form.instance.pk else None
        posted.add(form.instance.pk)
        if row and form["DELETE"].value() if "DELETE" in form.fields else False:
            yield Difference(f"{title} {row}", str(row), _("(deleted)"))
        elif row or form.has_changed():
            yield from form_differences(form, f"{title} {row}" if row else _new(title))
    for row in formset.get_queryset():
        if row.pk not in posted:
            yield Difference(f"{title} {row}", str(row), _("(was not there yet; it stays)"))


def _new(title: str) -> str:
    return _("%(title)s, new") % {"title": title}


def shown(field: Any, value: Any) -> str:
    """Return the value of a form field as people read it."""
    if isinstance(field, forms.ModelChoiceField):
        return _rows(field, value)
    if isinstance(field, forms.ChoiceField):
        words: dict[Any, Any] = dict(field.choices)  # type: ignore[arg-type]
        return str(words.get(value, value or ""))
    if isinstance(field, forms.BooleanField):
        return _("yes") if value else _("no")
    return _text(value)[:LONGEST_SHOWN]


def _text(value: object) -> str:
    if isinstance(value, list | dict):
        return json.dumps(value, ensure_ascii=False)
    return "" if value is None else str(value)


def _rows(field: Any, value: Any) -> str:
    given: Sequence[Any] = value if isinstance(value, list | tuple) else [value]
    numbers = [str(getattr(one, "pk", one)) for one in given if one]
    numbers = [one for one in numbers if one.isdecimal() and len(one) < 12]
    return ", ".join(str(row) for row in field.queryset.filter(pk__in=numbers))


def written(data: QueryDict) -> Iterator[tuple[str, str]]:
    """Yield the texts of a posted form as they are, for a row that is gone altogether."""
    for name, texts in data.lists():
        hidden = name in _NOT_TEXT or name.startswith("_") or name.endswith("_FORMS")
        for text in texts:
            if text.strip() and not hidden and not name.endswith("-id"):
                yield name, text[:LONGEST_SHOWN]


def sent_again(data: QueryDict) -> Iterator[tuple[str, str]]:
    """Yield every field of a posted form but the digest, to be posted once more."""
    for name, texts in data.lists():
        if name not in _NOT_TEXT:
            for text in texts:
                yield name, text
