"""The history in plain words: "Maria changed the Italian sentence of GreenTea.q1"."""

import json
from collections.abc import Mapping
from typing import Any

from django.core.exceptions import FieldDoesNotExist
from django.db.models import Model
from django.utils.text import capfirst
from django.utils.translation import gettext as _
from django.utils.translation import gettext_lazy

from authoring.language_names import language_name

#: What a row of each model is called; language, place and part are filled in.
NAMES = {
    "dialogue.culture": gettext_lazy("the culture %(place)s"),
    "dialogue.topic": gettext_lazy("the topic %(place)s"),
    "dialogue.topicname": gettext_lazy("the %(language)s name of %(place)s"),
    "dialogue.keywordset": gettext_lazy("the %(language)s words that lead to %(place)s"),
    "dialogue.variable": gettext_lazy("the %(language)s variable “%(part)s” of %(place)s"),
    "dialogue.topicinstance": gettext_lazy("how likely %(place)s is liked in the culture %(part)s"),
    "dialogue.topiclink": gettext_lazy("the link from %(place)s to %(part)s"),
    "dialogue.frame": gettext_lazy("the settings of the sentence %(place)s"),
    "dialogue.sentence": gettext_lazy("the %(language)s sentence of %(place)s"),
    "dialogue.draftversion": gettext_lazy("the whole draft"),
    "plans.phrase": gettext_lazy("the phrase <%(place)s>"),
    "plans.valuelist": gettext_lazy("the value list %(place)s"),
    "plans.intent": gettext_lazy("the intent %(place)s"),
    "plans.slot": gettext_lazy("the parameter “%(part)s” of the intent %(place)s"),
    "plans.trigger": gettext_lazy("a trigger in %(language)s of the intent %(place)s"),
    "plans.plansentence": gettext_lazy("a plan sentence in %(language)s of the intent %(place)s"),
    "plans.planaction": gettext_lazy("the action “%(part)s” of the intent %(place)s"),
    "plans.kbplanaction": gettext_lazy("the action on the talk “%(part)s” of the intent %(place)s"),
    "plans.intenttest": gettext_lazy("the test “%(part)s” of the intent %(place)s"),
}
KINDS = {
    "dialogue.culture": gettext_lazy("cultures"),
    "dialogue.topic": gettext_lazy("topics"),
    "dialogue.topicname": gettext_lazy("names of topics"),
    "dialogue.keywordset": gettext_lazy("words that lead to topics"),
    "dialogue.variable": gettext_lazy("variables"),
    "dialogue.topicinstance": gettext_lazy("likeliness"),
    "dialogue.topiclink": gettext_lazy("links between topics"),
    "dialogue.frame": gettext_lazy("settings of sentences"),
    "dialogue.sentence": gettext_lazy("sentences"),
    "dialogue.draftversion": gettext_lazy("the whole draft"),
    "plans.phrase": gettext_lazy("phrases"),
    "plans.valuelist": gettext_lazy("value lists"),
    "plans.intent": gettext_lazy("intents"),
    "plans.slot": gettext_lazy("parameters"),
    "plans.trigger": gettext_lazy("triggers"),
    "plans.plansentence": gettext_lazy("plan sentences"),
    "plans.planaction": gettext_lazy("actions"),
    "plans.kbplanaction": gettext_lazy("actions on the talk"),
    "plans.intenttest": gettext_lazy("tests of intents"),
}
LONGEST = 400


def headline(row: Mapping[str, Any], person: str) -> str:
    """Return a change in words; `row` has label, history_type, place and change."""
    values = {"who": person or _("Somebody"), "what": named(row["label"], row)}
    if row["label"] == "dialogue.draftversion":
        return _("%(who)s changed the whole draft") % values
    if row["history_type"] == "+":
        return _("%(who)s added %(what)s") % values
    if row["history_type"] == "-":
        return _("%(who)s deleted %(what)s") % values
    return _("%(who)s changed %(what)s") % values


def named(label: str, row: Mapping[str, Any]) -> str:
    """Return what a row is called: "the Italian sentence of GreenTea.q1"."""
    values = {
        "place": row["place"],
        "part": row["change"].get("part", ""),
        "language": language_name(row["change"].get("language", "")),
    }
    return str(NAMES[label]) % values


def told_fields(model: type[Model], change: Mapping[str, Any]) -> list[tuple[str, str, str]]:
    """Return name, old text and new text of each field; empty ones of new rows are left out."""
    found = []
    for name, old, new, old_text, new_text in change.get("fields", ()):
        texts = (old_text or spoken(old), new_text or spoken(new))
        if texts[0] != texts[1]:
            found.append((field_name(model, name), *texts))
    return found


def field_name(model: type[Model], name: str) -> str:
    """Return what a field is called in forms."""
    try:
        return str(capfirst(getattr(model._meta.get_field(name), "verbose_name", name)))
    except FieldDoesNotExist:
        return name


def spoken(value: object) -> str:
    """Return a value as people read it, not longer than a few lines."""
    if value is None or value in ("", [], {}):
        return ""
    if isinstance(value, bool):
        return _("yes") if value else _("no")
    text = value if isinstance(value, str) else json.dumps(value, ensure_ascii=False)
    return text if len(text) <= LONGEST else text[:LONGEST] + "…"
