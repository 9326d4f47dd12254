"""The rows of versions: the number of the draft, and the publications that robots use."""

from django.conf import settings
from django.db import models
from django.utils.translation import gettext_lazy as _

from plans.recording import Recorded


class DraftVersion(models.Model):
    """One row: a number that grows with every change of the draft, so that findings can age."""

    number = models.PositiveBigIntegerField(default=0, editable=False)
    history = Recorded("", rows=False)

    def __str__(self) -> str:
        return f"Draft {self.number}"


class Publication(models.Model):
    """One built Dialogue Tree with its plans: what robots use. Never changed once written."""

    created = models.DateTimeField(auto_now_add=True)
    author = models.ForeignKey(
        settings.AUTH_USER_MODEL, models.SET_NULL, null=True, blank=True, editable=False
    )
    note = models.CharField(
        max_length=300, blank=True, help_text=_("Example: new topics about tea")
    )
    checksum = models.CharField(max_length=64, editable=False)
    counts = models.JSONField(default=dict, editable=False)
    data = models.BinaryField(editable=False)

    class Meta:
        ordering = ["-id"]
        permissions = [
            ("publish_draft", "Can publish the draft and go back to a release"),
            ("export_content", "Can take content out: spreadsheets, ontologies"),
        ]

    def __str__(self) -> str:
        return str(_("Publication %(number)s") % {"number": self.pk})
