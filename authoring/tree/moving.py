"""Move a topic in the tree: what is refused, the preview, the move itself."""

from django.db import transaction
from django.db.models import Max
from django.utils.translation import gettext as _

from authoring.topic_page.shape import Shape, read_shape
from authoring.tree.move_preview import Preview, compare
from dialogue.models import DraftVersion, Topic


class CannotMoveError(ValueError):
    """The topic cannot go there; the message says why, in words for experts."""


def check_move(shape: Shape, number: int, target: int | None) -> None:
    """Refuse a place that is not one: below itself, or where the topic stands. CannotMoveError."""
    key = shape.keys[number]
    if target == number:
        raise CannotMoveError(_("%(key)s cannot stand below itself.") % {"key": key})
    if target is not None and number in shape.above(target):
        words = _("%(key)s cannot go below %(target)s, which is itself below %(key)s.")
        raise CannotMoveError(words % {"key": key, "target": shape.keys[target]})
    if shape.parents[number] == target:
        if target is None:
            raise CannotMoveError(_("%(key)s is a branch already.") % {"key": key})
        words = _("%(key)s stands below %(target)s already.")
        raise CannotMoveError(words % {"key": key, "target": shape.keys[target]})


def preview(shape: Shape, number: int, target: int | None) -> Preview:
    """Return what a move would bring. Raises CannotMoveError."""
    check_move(shape, number, target)
    return compare(shape, number, target)


def move(number: int, target: int | None, seen: int | None, told: str | None = None) -> Topic:
    """Put a topic below another one (None: the root), after its new neighbours.

    `seen` is the parent that the person saw, `told` the fingerprint of the preview that they saw,
    None where nobody looked at one. Raises CannotMoveError; then nothing has changed.
    """
    with transaction.atomic():
        # One move at a time, else two topics could end up below each other.
        list(DraftVersion.objects.select_for_update())
        shape = read_shape()
        row = Topic.objects.filter(pk=number).first()
        if row is None:
            raise CannotMoveError(_("This topic has been deleted by now."))
        if target is not None and target not in shape.keys:
            raise CannotMoveError(_("The place to move to has been deleted by now."))
        if row.parent_id != seen:
            words = _("Somebody has moved %(key)s in the meantime. Look at what would change now.")
            raise CannotMoveError(words % {"key": row.key})
        check_move(shape, number, target)
        if told is not None and told != compare(shape, number, target).fingerprint:
            words = _("Not moved: the move changes something else by now. Look at it again below.")
            raise CannotMoveError(words)
        row.parent_id = target
        row.position = _position(row, target)
        row.save(update_fields=["parent", "position"])
        return row


def _position(row: Topic, target: int | None) -> int:
    """Return the place after the new neighbours; its own where that is after them already."""
    last = Topic.objects.filter(parent=target).aggregate(last=Max("position"))["last"]
    return row.position if last is None or row.position > last else last + 1
