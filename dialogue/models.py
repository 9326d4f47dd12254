"""The rows that experts edit: topics, what is said about them, and publications."""

from django.core.exceptions import ValidationError
from django.core.validators import MaxValueValidator, MinValueValidator
from django.db import models
from django.db.models import Q
from django.utils.translation import gettext_lazy as _

from dialogue import validators
from dialogue.said import Frame, Sentence
from dialogue.validators import languages, no_control
from dialogue.versions import DraftVersion, Publication
from plans.recording import Recorded

__all__ = [
    "Culture",
    "DraftVersion",
    "Frame",
    "KeywordSet",
    "Publication",
    "Sentence",
    "Topic",
    "TopicInstance",
    "TopicLink",
    "TopicName",
    "Variable",
]


class Culture(models.Model):
    """A culture with its own layer of the ontology (CS-ABox)."""

    code = models.CharField(
        max_length=8,
        unique=True,
        validators=[validators.culture_code],
        help_text=_("Short code in capitals. Example: EN"),
    )
    names = models.JSONField(
        default=dict,
        validators=[validators.texts_by_language],
        help_text=_('Its name in each language. Example: {"en": "Indian", "it": "indiana"}'),
    )
    language = models.CharField(
        max_length=8, choices=languages, help_text=_("The language usually spoken. Example: en")
    )
    position = models.PositiveIntegerField(default=0, help_text=_("Place in lists. Example: 1"))
    history = Recorded("code", sets=("frame_set",))

    class Meta:
        ordering = ["position", "id"]

    def __str__(self) -> str:
        return self.code


class Topic(models.Model):
    """A concept people can talk about: a class of the TBox, a node of the Dialogue Tree."""

    key = models.CharField(
        _("name in the ontology"),
        max_length=100,
        unique=True,
        validators=[validators.one_name, validators.not_the_root],
        help_text=_("One word in CamelCase, used as the OWL class. Example: GreenTea"),
    )
    parent = models.ForeignKey(
        "self",
        models.PROTECT,
        null=True,
        blank=True,
        related_name="children",
        help_text=_("The more general topic. Empty for a branch. Example: Tea"),
    )
    also = models.ManyToManyField(
        "self",
        symmetrical=False,
        blank=True,
        related_name="lends_to",
        help_text=_("Further topics whose sentences fit this one too. Example: Giftable"),
    )
    home = models.ForeignKey(
        Culture,
        models.PROTECT,
        null=True,
        blank=True,
        help_text=_("The culture it belongs to, empty if shared. Example: IT for Gnocchi"),
    )
    gentle = models.BooleanField(
        default=False,
        help_text=_(
            "A hard subject: never proposed by the agent, listened to gently. Example: grief"
        ),
    )
    stop = models.CharField(
        _("inherits no sentences of"),
        max_length=8,
        blank=True,
        validators=[validators.sentence_types],
        help_text=_("Letters of the types not taken from more general topics. Example: qg"),
    )
    pattern = models.CharField(
        max_length=200,
        blank=True,
        validators=[validators.patterns],
        help_text=_(
            "Order of the sentence types; alternatives after |. Example: q r w c [g] | c q r"
        ),
    )
    note = models.TextField(
        blank=True,
        max_length=2000,
        validators=[no_control],
        help_text=_("For colleagues. Example: checked by the nurses"),
    )
    position = models.PositiveIntegerField(
        default=0, help_text=_("Place among its neighbours. Example: 3")
    )
    history = Recorded(subject="pk", sets=("also", "lends_to"))

    class Meta:
        ordering = ["position", "id"]

    def __str__(self) -> str:
        return self.key

    def clean(self) -> None:
        above, passed = self.parent, []
        while above and above.pk not in passed:
            if above.pk == self.pk:
                text = _("%(topic)s would lie below itself. Choose a topic that is not below it.")
                raise ValidationError({"parent": text % {"topic": self.key}})
            passed.append(above.pk)
            above = above.parent


class TopicName(models.Model):
    """What a topic is called in one language, with the forms that cannot be derived."""

    topic = models.ForeignKey(Topic, models.CASCADE, related_name="names")
    language = models.CharField(max_length=8, choices=languages, help_text=_("Example: it"))
    name = models.CharField(
        max_length=120,
        validators=[no_control],
        help_text=_("What fits after “I like …”; in Italian without article. Example: tè verde"),
    )
    fields = models.JSONField(
        _("further forms"),
        default=dict,
        blank=True,
        help_text=_(
            'Gender, number and irregular forms. Example: {"g": "m", "n": "p", "sg": "cane"}'
        ),
    )
    history = Recorded("topic.key", subject="topic_id")

    class Meta:
        constraints = [
            models.UniqueConstraint(fields=["topic", "language"], name="one_name_a_language")
        ]

    def __str__(self) -> str:
        return f"{self.name} ({self.language})"

    def clean(self) -> None:
        validators.check_name(self.language, self.name, self.fields)


class Variable(models.Model):
    """A word that sentences of this topic and of all below it may use as `$unit`."""

    topic = models.ForeignKey(Topic, models.CASCADE, related_name="variables")
    language = models.CharField(max_length=8, choices=languages, help_text=_("Example: en"))
    name = models.CharField(
        max_length=40,
        validators=[validators.variable_name],
        help_text=_("Used in sentences after a $. Example: unit"),
    )
    text = models.CharField(
        max_length=120, validators=[no_control], help_text=_("Example: a cup of")
    )
    history = Recorded("topic.key", subject="topic_id", part="name")

    class Meta:
        constraints = [
            models.UniqueConstraint(fields=["topic", "language", "name"], name="one_variable")
        ]

    def __str__(self) -> str:
        return f"${self.name} ({self.language})"


class KeywordSet(models.Model):
    """The two sets of words by which a topic is recognised in one language."""

    topic = models.ForeignKey(Topic, models.CASCADE, related_name="keywords")
    language = models.CharField(max_length=8, choices=languages, help_text=_("Example: en"))
    first = models.CharField(
        max_length=2000,
        validators=[no_control, validators.keywords],
        help_text=_("Words apart by |. Example: green|matcha"),
    )
    second = models.CharField(
        max_length=2000,
        validators=[no_control, validators.keywords],
        default="*",
        help_text=_("A word of this set must be heard too; * means any. Example: tea"),
    )
    history = Recorded("topic.key", subject="topic_id")

    class Meta:
        constraints = [
            models.UniqueConstraint(fields=["topic", "language"], name="one_keyword_set")
        ]

    def __str__(self) -> str:
        return f"{self.first} / {self.second}"


class TopicInstance(models.Model):
    """The individual of a topic in one culture (CS-ABox), e.g. EN_TEA, with its likeliness."""

    topic = models.ForeignKey(Topic, models.CASCADE, related_name="instances")
    culture = models.ForeignKey(Culture, models.CASCADE, related_name="instances")
    likeliness = models.DecimalField(
        max_digits=4,
        decimal_places=3,
        validators=[MinValueValidator(0), MaxValueValidator(1)],
        help_text=_(
            "How probable it is that a person of this culture likes it, 0 to 1. Example: 0.7"
        ),
    )
    name = models.CharField(
        _("name in the ontology"),
        max_length=100,
        blank=True,
        validators=[validators.individual_name],
        help_text=_("Empty for the usual one, made of culture and topic. Example: EN_TEA"),
    )
    history = Recorded("topic.key", subject="topic_id", part="culture.code")

    class Meta:
        constraints = [
            models.UniqueConstraint(fields=["topic", "culture"], name="one_instance_a_culture"),
            models.CheckConstraint(
                condition=Q(likeliness__gte=0, likeliness__lte=1),
                name="likeliness_0_to_1",
                violation_error_message=_("The likeliness must be from 0 to 1."),
            ),
        ]

    def __str__(self) -> str:
        return f"{self.culture_id}: {self.likeliness}"


class TopicLink(models.Model):
    """hasTopic: another topic this one leads to."""

    topic = models.ForeignKey(Topic, models.CASCADE, related_name="links")
    target = models.ForeignKey(
        Topic, models.CASCADE, related_name="linked_from", help_text=_("Example: Milk")
    )
    position = models.PositiveIntegerField(default=0, help_text=_("Place in the list. Example: 1"))
    history = Recorded("topic.key", subject="topic_id", part="target.key")

    class Meta:
        ordering = ["position", "id"]
        constraints = [
            models.UniqueConstraint(fields=["topic", "target"], name="one_link"),
            models.CheckConstraint(condition=~Q(topic=models.F("target")), name="link_elsewhere"),
        ]

    def __str__(self) -> str:
        return str(_("to %(topic)s") % {"topic": self.target_id})

    def clean(self) -> None:
        # The constraint is not asked where the topic's own page leaves the topic out.
        if self.topic_id and self.topic_id == self.target_id:
            text = _("A topic cannot lead to itself. Choose another one.")
            raise ValidationError({"target": text})
