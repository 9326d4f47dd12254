"""What the last check of the draft found, and how publishing goes on, for all workers."""

from django.conf import settings
from django.db import models


class CheckRun(models.Model):
    """The last check: one row, written over by the next one.

    `findings` is a JSON list of authoring.checks.findings.Found; `total` counts also what was too
    much to keep.
    """

    draft = models.PositiveBigIntegerField(editable=False)
    created = models.DateTimeField(auto_now=True)
    total = models.PositiveIntegerField(default=0, editable=False)
    findings = models.TextField(default="[]", editable=False)

    class Meta:
        default_permissions = ()

    def __str__(self) -> str:
        return f"Check of draft {self.draft}"


class PublishRun(models.Model):
    """One attempt to publish. `running` is True for the one that is going on, else NULL.

    `step` is one of publishing.STEPS, then one of authoring.releases.publish_run.ENDS; `problems`
    lists what stopped it, as JSON.
    """

    running = models.BooleanField(null=True, unique=True, editable=False)
    author = models.ForeignKey(
        settings.AUTH_USER_MODEL, models.SET_NULL, null=True, editable=False, related_name="+"
    )
    started = models.DateTimeField(auto_now_add=True)
    beat = models.DateTimeField(auto_now=True)
    draft = models.PositiveBigIntegerField(editable=False)
    note = models.CharField(max_length=300, blank=True, editable=False)
    step = models.CharField(max_length=20, editable=False)
    problems = models.JSONField(default=list, editable=False)
    publication = models.ForeignKey(
        "dialogue.Publication", models.SET_NULL, null=True, editable=False, related_name="+"
    )

    class Meta:
        default_permissions = ()
        ordering = ["-id"]

    def __str__(self) -> str:
        return f"Publishing {self.pk}: {self.step}"
