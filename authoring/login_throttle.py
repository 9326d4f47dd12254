"""Guessing passwords is slow: after some failures a name is locked for its address, for minutes.

An address that fails with ever new names is locked altogether. An attempt is counted before the
password is looked at, so that many at once gain nothing; a good login forgets those of its name.
"""

import logging
import math
import unicodedata
from dataclasses import dataclass
from datetime import timedelta
from typing import Any

from django.conf import settings
from django.contrib.admin.forms import AdminAuthenticationForm
from django.core.exceptions import ValidationError
from django.db import transaction
from django.dispatch import Signal
from django.utils import timezone
from django.utils.crypto import salted_hmac
from django.utils.translation import gettext as _

from authoring.addresses import caller
from authoring.models import LoginAttempts

audit = logging.getLogger("cair.audit")
#: Somebody tried to log in: `result` is DONE, FAILED or LOCKED.
tried = Signal()

#: Names that one address may fail with, as many times as one name may fail.
NAMES = 6
LONGEST_NAME = 300
DONE, FAILED, LOCKED = "done", "failed", "locked"


@dataclass(frozen=True, slots=True)
class _Limit:
    digest: str
    most: int


def begin(name: str, address: str) -> int:
    """Count an attempt before its password is looked at.

    Returns 0 where it may go on, else how many minutes are left until it may; then it is not
    counted.
    """
    with transaction.atomic():
        rows = [(limit, _row(limit)) for limit in _limits(name, address)]
        left = max(_minutes_left(row) for _limit, row in rows)
        if left:
            return left
        for limit, row in rows:
            _count(limit, row)
    return 0


def succeeded(name: str, address: str) -> None:
    """Forget the failures of a name, and take this attempt back from those of its address."""
    pair, place = _limits(name, address)
    LoginAttempts.objects.filter(digest=pair.digest).delete()
    with transaction.atomic():
        row = _row(place)
        row.failures, row.locked_until = max(row.failures - 1, 0), None
        row.save(update_fields=["failures", "locked_until"])


def _limits(name: str, address: str) -> tuple[_Limit, _Limit]:
    folded = unicodedata.normalize("NFKC", name[:LONGEST_NAME]).casefold()
    most = settings.CAIR_LOGIN_FAILURES
    return (
        _Limit(_digest("pair", folded, address), most),
        _Limit(_digest("address", "", address), most * NAMES),
    )


def _digest(kind: str, name: str, address: str) -> str:
    text = "\0".join((kind, address, name))
    hashed = salted_hmac("cair.login", text.encode("utf-8", "surrogatepass"), algorithm="sha256")
    return hashed.hexdigest()


def _row(limit: _Limit) -> LoginAttempts:
    """Return the row of a limit, locked for this transaction; begun anew where it is old."""
    now = timezone.now()
    rows = LoginAttempts.objects.select_for_update()
    row, _made = rows.get_or_create(digest=limit.digest, defaults={"since": now})
    lock_ended = row.locked_until is not None and row.locked_until <= now
    if lock_ended or (row.locked_until is None and row.since <= now - _span()):
        row.failures, row.since, row.locked_until = 0, now, None
    return row


def _count(limit: _Limit, row: LoginAttempts) -> None:
    row.failures += 1
    if row.failures >= limit.most:
        row.locked_until = timezone.now() + _span()
    row.save()


def _minutes_left(row: LoginAttempts) -> int:
    if row.locked_until is None:
        return 0
    return max(math.ceil((row.locked_until - timezone.now()).total_seconds() / 60), 0)


def _span() -> timedelta:
    return timedelta(minutes=settings.CAIR_LOGIN_MINUTES)


def forget_old() -> None:
    """Delete what counts no longer."""
    LoginAttempts.objects.filter(since__lt=timezone.now() - 2 * _span()).delete()


class LoginForm(AdminAuthenticationForm):
    """The login of the admin, with as many attempts as are allowed."""

    def clean(self) -> dict[str, Any]:
        """Check name and password. Raises ValidationError, which says when to try again."""
        name = self.cleaned_data.get("username")
        if name is None or not self.cleaned_data.get("password"):
            return super().clean()
        address = caller(self.request) if self.request else ""
        if left := begin(name, address):
            _tell(LOCKED, address)
            told = _("Too many failed logins. Try again in %(minutes)d min.") % {"minutes": left}
            raise ValidationError(told, code="locked")
        try:
            cleaned = super().clean()
        except ValidationError:
            forget_old()
            _tell(FAILED, address)
            raise
        succeeded(name, address)
        _tell(DONE, address, user=self.get_user().pk)
        return cleaned


def _tell(result: str, address: str, user: object = None) -> None:
    """Write the audit line and count; never the name that was tried, which may be a password."""
    level = logging.INFO if result == DONE else logging.WARNING
    fields = {"result": result, "address": address}
    audit.log(level, "Login", extra={"fields": fields | ({"user": user} if user else {})})
    tried.send(LoginForm, result=result)
