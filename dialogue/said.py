"""The rows of what the agent says: frames, each with its sentence in every language."""

from django.core.exceptions import ValidationError
from django.db import models
from django.db.models import Q
from django.utils.translation import gettext_lazy as _

from dialogue import validators
from dialogue.validators import languages, no_control
from plans.recording import Recorded


class Frame(models.Model):
    """One thing the agent can say, about a topic or from a pool, in every language."""

    key = models.CharField(
        max_length=140,
        unique=True,
        help_text=_("Stable name. Example: GreenTea.q1"),
        validators=[validators.frame_key],
    )
    topic = models.ForeignKey(
        "dialogue.Topic",
        models.CASCADE,
        null=True,
        blank=True,
        related_name="frames",
        help_text=_("Example: Tea"),
    )
    pool = models.CharField(
        max_length=40,
        blank=True,
        choices=validators.pools,
        help_text=_("For lines without a topic."),
    )
    type = models.CharField(
        max_length=1,
        blank=True,
        choices=validators.types,
        help_text=_("Example: q, a yes/no question"),
    )
    scope = models.CharField(
        max_length=8,
        blank=True,
        choices=validators.SCOPE_CHOICES,
        help_text=_("Where it may be said."),
    )
    only = models.ManyToManyField(
        "dialogue.Culture",
        blank=True,
        help_text=_("Said only in these cultures; none chosen means all."),
    )
    do = models.CharField(
        _("activity"),
        max_length=200,
        blank=True,
        validators=[no_control, validators.activity],
        help_text=_("For proposals: the plan to run. Example: playsong title=$hasName"),
    )
    slot = models.SmallIntegerField(default=-1, editable=False)
    position = models.PositiveIntegerField(default=0, help_text=_("Place in the list. Example: 2"))
    history = Recorded(subject="topic_id", sets=("only",))

    class Meta:
        ordering = ["position", "id"]
        constraints = [
            models.CheckConstraint(
                condition=Q(topic__isnull=False, pool="") | Q(topic__isnull=True) & ~Q(pool=""),
                name="frame_of_topic_or_pool",
                violation_error_message=_("Choose either a topic or a pool."),
            )
        ]

    def __str__(self) -> str:
        return self.key

    def clean(self) -> None:
        if self.topic and not self.type:
            raise ValidationError({"type": _("Choose what kind of sentence it is.")})
        if self.pool and self.type:
            raise ValidationError({"type": _("A line of a pool has no type; leave it empty.")})
        begin = f"{self.topic}.{self.type}" if self.topic else f"{self.pool}."
        if self.key and not self.key.removeprefix(begin).isdecimal():
            text = _("It must be %(begin)s and a number, or left empty.")
            raise ValidationError({"key": text % {"begin": begin}})


class Sentence(models.Model):
    """What a frame says in one language."""

    frame = models.ForeignKey(Frame, models.CASCADE, related_name="sentences")
    language = models.CharField(max_length=8, choices=languages, help_text=_("Example: en"))
    text = models.CharField(
        max_length=400, validators=[no_control], help_text=_("Example: Do you like $hasName?")
    )
    history = Recorded("frame.key", subject="frame.topic_id")

    class Meta:
        constraints = [
            models.UniqueConstraint(fields=["frame", "language"], name="one_sentence_a_language")
        ]

    def __str__(self) -> str:
        return self.text

    def clean(self) -> None:
        validators.check_sentence(self.language, self.text)
