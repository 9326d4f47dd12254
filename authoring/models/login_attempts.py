"""Logins that failed, until they are forgotten."""

from django.db import models


class LoginAttempts(models.Model):
    """Failed logins of one name from one address, or of any name from one address.

    Neither is kept: `digest` is their HMAC with the server's secret, 64 hexadecimal digits.
    """

    digest = models.CharField(max_length=64, unique=True, editable=False)
    failures = models.PositiveIntegerField(default=0, editable=False)
    since = models.DateTimeField(editable=False, db_index=True)
    locked_until = models.DateTimeField(null=True, editable=False)

    class Meta:
        default_permissions = ()

    def __str__(self) -> str:
        return f"{self.digest[:8]}…: {self.failures}"
