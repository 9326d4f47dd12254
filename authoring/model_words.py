"""What rows and their fields are called on pages, in the language of the person."""

from collections.abc import Mapping

from django.apps import apps
from django.db.models import Field
from django.utils.functional import Promise
from django.utils.translation import gettext_lazy as _
from django.utils.translation import pgettext_lazy

#: What a row of each model is called: one, many.
ROWS: Mapping[str, tuple[Promise, Promise]] = {
    "dialogue.culture": (pgettext_lazy("row", "culture"), pgettext_lazy("row", "cultures")),
    "dialogue.topic": (pgettext_lazy("row", "topic"), pgettext_lazy("row", "topics")),
    "dialogue.topicname": (_("topic name"), _("topic names")),
    "dialogue.variable": (_("variable"), pgettext_lazy("row", "variables")),
    "dialogue.keywordset": (_("keyword set"), _("keyword sets")),
    "dialogue.topicinstance": (_("topic instance"), _("topic instances")),
    "dialogue.topiclink": (_("topic link"), _("topic links")),
    "dialogue.frame": (
        pgettext_lazy("kind of row", "sentence"),
        pgettext_lazy("kind of row", "sentences"),
    ),
    "dialogue.sentence": (pgettext_lazy("row", "wording"), pgettext_lazy("row", "wordings")),
    "dialogue.draftversion": (_("draft version"), _("draft versions")),
    "dialogue.publication": (
        pgettext_lazy("kind of row", "release"),
        pgettext_lazy("kind of row", "releases"),
    ),
    "plans.phrase": (_("phrase"), pgettext_lazy("row", "phrases")),
    "plans.valuelist": (_("value list"), pgettext_lazy("row", "value lists")),
    "plans.intent": (pgettext_lazy("row", "intent"), pgettext_lazy("row", "intents")),
    "plans.slot": (_("slot"), _("slots")),
    "plans.trigger": (_("trigger"), pgettext_lazy("row", "triggers")),
    "plans.plansentence": (_("plan sentence"), pgettext_lazy("row", "plan sentences")),
    "plans.planaction": (_("plan action"), _("plan actions")),
    "plans.kbplanaction": (_("kb plan action"), _("kb plan actions")),
    "plans.intenttest": (_("intent test"), _("intent tests")),
}
#: What fields are called that have no name of their own; one name means the same in every model.
FIELDS: Mapping[str, Promise] = {
    "abilities": pgettext_lazy("field", "abilities"),
    "action": pgettext_lazy("field", "action"),
    "also": pgettext_lazy("field", "also"),
    "author": pgettext_lazy("field", "author"),
    "code": pgettext_lazy("field", "code"),
    "created": pgettext_lazy("field", "created"),
    "culture": pgettext_lazy("field", "culture"),
    "family": pgettext_lazy("field", "family"),
    "first": pgettext_lazy("field", "first"),
    "frame": pgettext_lazy("field", "frame"),
    "gentle": pgettext_lazy("field", "gentle"),
    "home": pgettext_lazy("field", "home"),
    "intent": pgettext_lazy("field", "intent"),
    "key": pgettext_lazy("field", "key"),
    "kind": pgettext_lazy("field", "kind"),
    "language": pgettext_lazy("field", "language"),
    "likeliness": pgettext_lazy("field", "likeliness"),
    "name": pgettext_lazy("field", "name"),
    "names": pgettext_lazy("field", "names"),
    "note": pgettext_lazy("field", "note"),
    "only": pgettext_lazy("field", "only"),
    "parameters": pgettext_lazy("field", "parameters"),
    "parent": pgettext_lazy("field", "parent"),
    "pattern": pgettext_lazy("field", "pattern"),
    "pool": pgettext_lazy("field", "pool"),
    "position": pgettext_lazy("field", "position"),
    "priority": pgettext_lazy("field", "priority"),
    "questions": pgettext_lazy("field", "questions"),
    "required": pgettext_lazy("field", "required"),
    "scope": pgettext_lazy("field", "scope"),
    "second": pgettext_lazy("field", "second"),
    "sentence": pgettext_lazy("field", "sentence"),
    "target": pgettext_lazy("field", "target"),
    "text": pgettext_lazy("field", "text"),
    "texts": pgettext_lazy("field", "texts"),
    "topic": pgettext_lazy("field", "topic"),
    "type": pgettext_lazy("field", "type"),
    "values": pgettext_lazy("field", "values"),
}
#: What the apps are called in the path of a page.
APPS: Mapping[str, Promise] = {
    "dialogue": _("Dialogue"),
    "plans": _("Plans"),
    "ontology_io": _("Ontology in and out"),
}


def name_rows() -> None:
    """Give rows and fields their names; before forms are made, and without a migration."""
    for label, (one, many) in ROWS.items():
        model = apps.get_model(label)
        # Options and Field take lazy texts here, as they do from `Meta` and from the field.
        model._meta.verbose_name = one
        model._meta.verbose_name_plural = many
        for field in model._meta.get_fields():
            _name_field(field)
    for label, name in APPS.items():
        apps.get_app_config(label).verbose_name = name  # type: ignore[assignment]


def _name_field(field: object) -> None:
    if isinstance(field, Field) and field.verbose_name == field.name.replace("_", " "):
        field.verbose_name = FIELDS.get(field.name, field.verbose_name)  # type: ignore[assignment]
