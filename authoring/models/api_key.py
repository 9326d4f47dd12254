"""The keys by which robots may call the API."""

from django.conf import settings
from django.core.validators import MaxValueValidator, MinValueValidator
from django.db import models
from django.utils.translation import gettext_lazy as _

from dialogue.validators import no_control

MOST_A_MINUTE = 100_000
READ, WRITE = "read", "write"
#: What a key may do with the ontology, the least first.
ONTOLOGY = {
    "": _("no access"),
    READ: _("take it out"),
    WRITE: _("take it out and bring it in"),
}


class ApiKey(models.Model):
    """A key of the API: only its beginning and its SHA-256 are kept, never the key itself."""

    label = models.CharField(
        _("label"),
        max_length=100,
        validators=[no_control],
        help_text=_("Who uses it. Example: robot in the day room"),
    )
    prefix = models.CharField(_("beginning"), max_length=16, unique=True, editable=False)
    digest = models.CharField(max_length=64, unique=True, editable=False)
    created = models.DateTimeField(_("made"), auto_now_add=True)
    created_by = models.ForeignKey(
        settings.AUTH_USER_MODEL, models.SET_NULL, null=True, blank=True, editable=False
    )
    last_used = models.DateField(_("last used"), null=True, blank=True, editable=False)
    revoked = models.DateTimeField(_("revoked"), null=True, blank=True, editable=False)
    rate = models.PositiveIntegerField(
        _("calls a minute"),
        null=True,
        blank=True,
        validators=[MinValueValidator(1), MaxValueValidator(MOST_A_MINUTE)],
        help_text=_("For each worker of the server; empty for no limit. Example: 60"),
    )
    ontology = models.CharField(
        _("ontology"),
        max_length=5,
        blank=True,
        default="",
        choices=list(ONTOLOGY.items()),
        help_text=_(
            "For programs of researchers. Bringing in can rewrite the whole draft; robots need "
            "none of this."
        ),
    )

    class Meta:
        ordering = ["-id"]
        verbose_name = _("API key")
        verbose_name_plural = _("API keys")

    def __str__(self) -> str:
        return f"{self.label} ({self.prefix}…)"
