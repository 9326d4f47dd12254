"""The rows that experts edit: intents, how people say them, and what they bring about."""

from django.core.validators import MaxValueValidator
from django.db import models
from django.utils.translation import gettext_lazy as _

from plans import validators
from plans.recording import Recorded
from plans.validators import languages, no_control, one_word


class Phrase(models.Model):
    """A piece of pattern with a name, used in triggers as `<please>`."""

    key = models.CharField(
        max_length=60, unique=True, validators=[one_word], help_text=_("Example: please")
    )
    texts = models.JSONField(
        default=dict,
        validators=[validators.texts_by_language],
        help_text=_('The pattern in each language. Example: {"en": "please|could you"}'),
    )
    position = models.PositiveIntegerField(default=0)
    history = Recorded()

    class Meta:
        ordering = ["position", "id"]

    def __str__(self) -> str:
        return f"<{self.key}>"


class ValueList(models.Model):
    """Words with one meaning for a parameter: "più forte" means louder."""

    key = models.CharField(
        max_length=60, unique=True, validators=[one_word], help_text=_("Example: volume_level")
    )
    values = models.JSONField(
        default=dict,
        validators=[validators.words_by_value],
        help_text=_('Language → value → words. Example: {"en": {"louder": ["louder", "up"]}}'),
    )
    position = models.PositiveIntegerField(default=0)
    history = Recorded()

    class Meta:
        ordering = ["position", "id"]

    def __str__(self) -> str:
        return self.key


class Intent(models.Model):
    """Something a person may ask for or say about the talk itself."""

    key = models.CharField(
        max_length=60, unique=True, validators=[one_word], help_text=_("Example: playsong")
    )
    priority = models.PositiveSmallIntegerField(
        default=50,
        validators=[MaxValueValidator(100)],
        help_text=_("100 safety, 80 wishes about the talk, 50 robot actions, 40 appreciation."),
    )
    family = models.CharField(
        max_length=60,
        blank=True,
        validators=[one_word],
        help_text=_("Groups intents for authors. Example: media"),
    )
    abilities = models.JSONField(
        default=dict,
        blank=True,
        validators=[validators.texts_by_language],
        help_text=_('What comes after "I can". Example: {"en": "play a song"}'),
    )
    note = models.TextField(
        blank=True, max_length=2000, validators=[no_control], help_text=_("For colleagues.")
    )
    position = models.PositiveIntegerField(default=0)
    history = Recorded(subject="pk")

    class Meta:
        ordering = ["position", "id"]

    def __str__(self) -> str:
        return self.key


class Slot(models.Model):
    """A parameter captured from the sentence, written `{title}` in triggers."""

    intent = models.ForeignKey(Intent, models.CASCADE, related_name="slots")
    name = models.CharField(max_length=40, validators=[one_word], help_text=_("Example: title"))
    kind = models.CharField(
        max_length=80,
        default="text",
        validators=[validators.slot_kind],
        help_text=_(
            "text, topic, number, duration, time, date, yes_no or value:list. "
            "Example: value:volume_level"
        ),
    )
    required = models.BooleanField(default=False, help_text=_("Ask for it when it is missing."))
    questions = models.JSONField(
        default=dict,
        blank=True,
        validators=[validators.texts_by_language],
        help_text=_('How to ask. Example: {"en": "Which song?"}'),
    )
    position = models.PositiveIntegerField(default=0)
    history = Recorded("intent.key", subject="intent_id", part="name")

    class Meta:
        ordering = ["position", "id"]
        constraints = [models.UniqueConstraint(fields=["intent", "name"], name="one_slot")]

    def __str__(self) -> str:
        return f"{{{self.name}}}"


class Trigger(models.Model):
    """A trigger sentence: one way to say it, as a pattern."""

    intent = models.ForeignKey(Intent, models.CASCADE, related_name="triggers")
    language = models.CharField(max_length=8, choices=languages, help_text=_("Example: en"))
    text = models.CharField(
        max_length=500,
        validators=[no_control, validators.trigger_pattern],
        help_text=_("Example: (play|put on) [the song] {title}"),
    )
    position = models.PositiveIntegerField(default=0)
    history = Recorded("intent.key", subject="intent_id")

    class Meta:
        ordering = ["position", "id"]

    def __str__(self) -> str:
        return self.text


class PlanSentence(models.Model):
    """What the agent says before the plan."""

    intent = models.ForeignKey(Intent, models.CASCADE, related_name="plan_sentences")
    language = models.CharField(max_length=8, choices=languages, help_text=_("Example: en"))
    text = models.CharField(
        max_length=400, validators=[no_control], help_text=_("Example: Let us listen to {title}.")
    )
    only = models.CharField(
        max_length=80,
        blank=True,
        validators=[validators.culture_codes],
        help_text=_("Codes of cultures, empty for all. Example: IN EN"),
    )
    position = models.PositiveIntegerField(default=0)
    history = Recorded("intent.key", subject="intent_id")

    class Meta:
        ordering = ["position", "id"]

    def __str__(self) -> str:
        return self.text


class _Action(models.Model):
    action = models.CharField(
        max_length=60, validators=[one_word], help_text=_("Example: playsong")
    )
    parameters = models.JSONField(
        default=list,
        blank=True,
        validators=[validators.parameter_pairs],
        help_text=_('Names and values in order. Example: [["title", "{title}"]]'),
    )
    position = models.PositiveIntegerField(default=0)

    class Meta:
        abstract = True
        ordering = ["position", "id"]

    def __str__(self) -> str:
        return self.action


class PlanAction(_Action):
    """An action for the client to execute."""

    intent = models.ForeignKey(Intent, models.CASCADE, related_name="plan_actions")
    history = Recorded("intent.key", subject="intent_id", part="action")


class KBPlanAction(_Action):
    """An action on the knowledge base or on the flow of the talk."""

    intent = models.ForeignKey(Intent, models.CASCADE, related_name="kbplan_actions")
    history = Recorded("intent.key", subject="intent_id", part="action")


class IntentTest(models.Model):
    """A stored test: a sentence and what must be captured from it."""

    intent = models.ForeignKey(Intent, models.CASCADE, related_name="tests")
    language = models.CharField(max_length=8, choices=languages, help_text=_("Example: en"))
    sentence = models.CharField(
        max_length=500,
        validators=[no_control, validators.test_sentence],
        help_text=_("Example: Play Hey Brother"),
    )
    parameters = models.JSONField(
        null=True,
        blank=True,
        validators=[validators.expected_parameters],
        help_text=_(
            'What must be captured; empty: must not match. Example: {"title": "Hey Brother"}'
        ),
    )
    position = models.PositiveIntegerField(default=0)
    history = Recorded("intent.key", subject="intent_id", part="sentence")

    class Meta:
        ordering = ["position", "id"]

    def __str__(self) -> str:
        return self.sentence
