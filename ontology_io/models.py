"""The rows of imports: how each goes on, and what the vocabulary did not know of the last one."""

import zlib

from django.conf import settings
from django.db import models


class Remainder(models.Model):
    """One row: what the last import held beyond the vocabulary, as compressed N-Triples."""

    data = models.BinaryField(default=b"", editable=False)

    class Meta:
        default_permissions = ()

    def __str__(self) -> str:
        return f"{len(self.text)} characters"

    @property
    def text(self) -> str:
        """Return the sorted N-Triples, "" where there are none."""
        return zlib.decompress(bytes(self.data)).decode() if self.data else ""


class ImportRun(models.Model):
    """One import of an ontology. `running` is True for the one that is going on, else NULL.

    `step` is one of import_runs.STEPS. `data` is the uploaded file, then what the preview found
    to write; it is emptied when nothing can come of it any more. `draft` is the version of the
    draft that the preview compared with. `result` is what import_runs.result returns.
    """

    running = models.BooleanField(null=True, unique=True, editable=False)
    author = models.ForeignKey(
        settings.AUTH_USER_MODEL,
        models.SET_NULL,
        null=True,
        blank=True,
        editable=False,
        related_name="+",
    )
    file_name = models.CharField(max_length=200, blank=True, editable=False)
    keep = models.BooleanField(default=False, editable=False)
    data = models.BinaryField(default=b"", editable=False)
    step = models.CharField(max_length=20, editable=False)
    started = models.DateTimeField(auto_now_add=True)
    beat = models.DateTimeField(auto_now_add=True)
    ended = models.DateTimeField(null=True, editable=False)
    draft = models.PositiveBigIntegerField(default=0, editable=False)
    result = models.JSONField(default=dict, editable=False)
    applied = models.BooleanField(default=False, editable=False)

    class Meta:
        default_permissions = ()
        ordering = ["-id"]

    def __str__(self) -> str:
        return f"Import {self.pk}: {self.step}"
