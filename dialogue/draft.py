"""The draft's version: it grows with every change, whoever makes it."""

from typing import Any

from django.apps import apps
from django.db.models import F
from django.db.models.signals import m2m_changed, post_delete, post_save

from dialogue.models import DraftVersion, Publication

_ONLY = 1
_APPS = frozenset(("dialogue", "plans"))


def draft_version() -> int:
    """Return the number of the draft; one query."""
    found = DraftVersion.objects.filter(pk=_ONLY).values_list("number", flat=True).first()
    return found or 0


def touch_draft() -> None:
    """Note that the draft has changed; for what writes in bulk, past the signals."""
    if not DraftVersion.objects.filter(pk=_ONLY).update(number=F("number") + 1):
        DraftVersion.objects.get_or_create(pk=_ONLY, defaults={"number": 1})


def watch_changes() -> None:
    """Note every row of the draft that is saved or deleted; called once the apps are ready."""
    for signal in (post_save, post_delete, m2m_changed):
        signal.connect(_changed, dispatch_uid="dialogue.draft")


def _changed(sender: Any, raw: bool = False, **_more: object) -> None:
    if raw or sender in (DraftVersion, Publication) or not apps.models_ready:
        return
    name = sender._meta.model_name
    if sender._meta.app_label in _APPS and not name.startswith("historical"):
        touch_draft()
