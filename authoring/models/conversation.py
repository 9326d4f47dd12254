"""Regression conversations: talks that must go on being answered as experts found right."""

from django.conf import settings
from django.core.validators import MaxValueValidator, MinValueValidator
from django.db import models
from django.utils.translation import gettext_lazy as _

from dialogue.turns import MOST_SEED
from plans.validators import languages, no_control

LONGEST_TITLE, LONGEST_NOTE = 120, 2000


class Conversation(models.Model):
    """A talk with what must hold of each reply.

    `turns` is a JSON list of authoring.chat.conversation_turns.Turn, the opening first.
    `capabilities` are the actions the robot can do, None the usual ones. `passed` is None where it
    never ran; `ran_on` is the number of the release it ran on, 0 the draft.
    """

    title = models.CharField(
        _("title"),
        max_length=LONGEST_TITLE,
        validators=[no_control],
        help_text=_("What it is about. Example: Tea and then grief"),
    )
    note = models.TextField(
        _("note"),
        blank=True,
        max_length=LONGEST_NOTE,
        validators=[no_control],
        help_text=_("For colleagues. Example: agreed with the nurses"),
    )
    language = models.CharField(_("language"), max_length=8, choices=languages, editable=False)
    culture = models.CharField(_("culture"), max_length=8, editable=False)
    seed = models.PositiveBigIntegerField(
        _("seed"),
        editable=False,
        validators=[MinValueValidator(1), MaxValueValidator(MOST_SEED)],
    )
    topic = models.CharField(_("begins with"), max_length=100, blank=True, editable=False)
    capabilities = models.JSONField(null=True, blank=True, default=None, editable=False)
    turns = models.JSONField(default=list, editable=False)
    created = models.DateTimeField(_("saved"), auto_now_add=True)
    created_by = models.ForeignKey(
        settings.AUTH_USER_MODEL,
        models.SET_NULL,
        null=True,
        blank=True,
        editable=False,
        related_name="+",
    )
    passed = models.BooleanField(_("holds"), null=True, editable=False)
    ran = models.DateTimeField(_("last tried"), null=True, editable=False)
    ran_on = models.PositiveIntegerField(default=0, editable=False)

    class Meta:
        ordering = ["title", "id"]
        verbose_name = _("conversation")
        verbose_name_plural = _("conversations")

    def __str__(self) -> str:
        return self.title
