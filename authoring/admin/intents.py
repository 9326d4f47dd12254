"""The pages of intents, value lists and phrases."""

from collections.abc import Iterator, Mapping
from typing import Any

from django.contrib import admin, messages
from django.contrib.admin.views.main import ChangeList
from django.db.models import Count, Model
from django.http import HttpRequest, HttpResponse
from django.urls import reverse
from django.utils.html import format_html, format_html_join
from django.utils.translation import gettext as _
from django.utils.translation import gettext_lazy, ngettext

from authoring.admin.base import PlacedAdmin
from authoring.admin.intent_parts import PARTS
from authoring.intent_page import forms, list_forms, results
from authoring.intent_page.draft_library import draft_library
from authoring.intent_page.wordings import WAYS_OF_ASKING, priority_words
from languages.known import LANGUAGES
from plans import models
from plans.engine.actions import ACTIONS
from plans.engine.kb_actions import KB_ACTIONS

CSS = "authoring/intent.css"
#: How many remarks of a language are told after saving.
MOST_TOLD = 3


class IntentList(ChangeList):
    """The list, with what is written in each language: two queries for the whole page."""

    def get_results(self, request: HttpRequest) -> None:
        """Count the parts of the intents that are shown."""
        super().get_results(request)
        rows: list[Any] = list(self.result_list)
        for name, model in (("triggers", models.Trigger), ("tests", models.IntentTest)):
            counts = _counts(model, [row.pk for row in rows])
            for row in rows:
                setattr(row, f"counted_{name}", counts.get(row.pk, {}))
        self.result_list = rows


def _counts(model: type[Model], numbers: list[int]) -> dict[int, dict[str, int]]:
    parts = model._default_manager.filter(intent_id__in=numbers).order_by()
    found: dict[int, dict[str, int]] = {}
    for number, code, times in parts.values_list("intent_id", "language").annotate(n=Count("pk")):
        found.setdefault(number, {})[code] = times
    return found


def _per_language(counts: Mapping[str, int]) -> str:
    return " · ".join(f"{code} {counts.get(code, 0)}" for code in LANGUAGES)


@admin.register(models.Intent)
class IntentAdmin(PlacedAdmin):
    form = forms.IntentForm
    list_display = ("key", "family", "in_words", "in_triggers", "in_tests", "passing", "note")
    list_filter = ("family",)
    search_fields = ("key", "note", "triggers__text")
    search_help_text = gettext_lazy("Search the name, the note and the trigger sentences.")
    change_form_template = "admin/plans/intent/change_form.html"
    change_list_template = "admin/plans/intent/change_list.html"
    inlines = PARTS

    @admin.display(description=gettext_lazy("Priority"), ordering="priority")
    def in_words(self, intent: models.Intent) -> str:
        return priority_words(intent.priority)

    @admin.display(description=gettext_lazy("Trigger sentences"))
    def in_triggers(self, intent: models.Intent) -> str:
        return _per_language(intent.counted_triggers)  # type: ignore[attr-defined]

    @admin.display(description=gettext_lazy("Tests"))
    def in_tests(self, intent: models.Intent) -> str:
        return _per_language(intent.counted_tests)  # type: ignore[attr-defined]

    @admin.display(description=gettext_lazy("Passed"))
    def passing(self, intent: models.Intent) -> str:
        return format_html('<span data-tests-of="{}" class="quiet">…</span>', intent.pk)

    def changelist_view(
        self, request: HttpRequest, extra_context: dict[str, Any] | None = None
    ) -> HttpResponse:
        """Show the list over the whole page."""
        return super().changelist_view(
            request, {"is_nav_sidebar_enabled": False, **(extra_context or {})}
        )

    def get_changelist(self, request: HttpRequest, **kwargs: Any) -> type[IntentList]:
        return IntentList

    def get_formset_kwargs(
        self, request: HttpRequest, obj: Any, inline: Any, prefix: str
    ) -> dict[str, Any]:
        """Give the spare rows their languages."""
        given: dict[str, Any] = super().get_formset_kwargs(request, obj, inline, prefix)
        return {**given, "initial": inline.spare(obj.pk is None)}

    def render_change_form(
        self, request: HttpRequest, context: dict[str, Any], *args: Any, **kwargs: Any
    ) -> HttpResponse:
        """Show the form with the tables it chooses from."""
        parts = {each.formset.prefix: each for each in context["inline_admin_formsets"]}
        context |= {
            "parts": parts,
            "languages": [(code, one.own_name) for code, one in LANGUAGES.items()],
            "families": models.Intent.objects.exclude(family="")
            .order_by("family")
            .values_list("family", flat=True)
            .distinct(),
            "ways_of_asking": WAYS_OF_ASKING,
            "action_table": _action_table(),
            "is_nav_sidebar_enabled": False,  # The sentences need the room.
        }
        return super().render_change_form(request, context, *args, **kwargs)

    def save_model(self, request: HttpRequest, obj: Any, form: Any, change: bool) -> None:
        super().save_model(request, obj, form, change)
        request.saved_intent = obj.pk  # type: ignore[attr-defined]

    def changeform_view(
        self,
        request: HttpRequest,
        object_id: str | None = None,
        form_url: str = "",
        extra_context: dict[str, Any] | None = None,
    ) -> HttpResponse:
        """Save, then tell what the stored tests and the checks say; they never stand in the way."""
        response = super().changeform_view(request, object_id, form_url, extra_context)
        number = getattr(request, "saved_intent", None)
        if number is not None and response.status_code == 302:
            for text in _told(number):
                messages.warning(request, text)
        return response


def _action_table() -> dict[str, dict[str, list[dict[str, Any]]]]:
    """Return the parameters of each action with their allowed values, for the script."""
    return {
        "plan_actions": {
            action.name: [{"name": one.name, "values": one.values} for one in action.parameters]
            for action in ACTIONS
        },
        "kbplan_actions": {
            action.name: [{"name": name, "values": ()} for name in action.parameters]
            for action in KB_ACTIONS
        },
    }


def _told(number: int) -> Iterator[str]:
    compiled = draft_library()
    intent = models.Intent.objects.get(pk=number)
    for problem in compiled.problems:
        if problem.where == intent.key:
            yield str(problem)
    failing = results.failures(compiled, number)
    if failing:
        words = ngettext(
            "%(n)d stored test fails: %(which)s.",
            "%(n)d stored tests fail: %(which)s.",
            len(failing),
        )
        shown = "; ".join(f"“{one.sentence}” ({one.reason})" for one in failing[:3])
        yield words % {"n": len(failing), "which": shown}
    by_language: dict[str, list[str]] = {}
    for one in results.remarks(compiled, number):
        by_language.setdefault(one.language, []).append(one.text)
    for code, texts in by_language.items():
        name = LANGUAGES[code].own_name if code in LANGUAGES else _("All languages")
        more = [_("and %(n)d more, shown below the stored tests.") % {"n": len(texts) - MOST_TOLD}]
        yield f"{name}: {' '.join([*texts[:MOST_TOLD], *more[: len(texts) > MOST_TOLD]])}"


class SharedAdmin(PlacedAdmin):
    """A list or phrase that intents share: where it is used stands on its page."""

    readonly_fields = ("used_in",)
    search_fields = ("key",)

    class Media:
        css = {"all": (CSS,)}
        js = ("authoring/intent_lists.js",)

    def users_of(self, row: Any) -> Any:
        """Return the intents that use the row."""
        raise NotImplementedError

    @admin.display(description=gettext_lazy("Used in"))
    def used_in(self, row: Any) -> str:
        intents = self.users_of(row).distinct() if row and row.pk else ()
        links = [
            (reverse("admin:plans_intent_change", args=(intent.pk,)), intent.key)
            for intent in intents
        ]
        if not links:
            return _("Nowhere yet.")
        return format_html_join(", ", '<a href="{}">{}</a>', links)


@admin.register(models.Phrase)
class PhraseAdmin(SharedAdmin):
    form = list_forms.PhraseForm
    fields = ("key", "texts", "used_in", "position")
    list_display = ("__str__", "in_english")

    @admin.display(description="English")
    def in_english(self, phrase: models.Phrase) -> str:
        return str(phrase.texts.get("en", ""))[:80]

    def users_of(self, row: Any) -> Any:
        """Return the intents whose trigger sentences name the phrase."""
        return models.Intent.objects.filter(triggers__text__contains=f"<{row.key}>")


@admin.register(models.ValueList)
class ValueListAdmin(SharedAdmin):
    form = list_forms.ValueListForm
    fields = ("key", "values", "used_in", "position")
    list_display = ("key", "in_short")

    @admin.display(description=gettext_lazy("Values"))
    def in_short(self, row: models.ValueList) -> str:
        values = {one: None for lists in row.values.values() for one in lists}
        return ", ".join(values)[:80]

    def users_of(self, row: Any) -> Any:
        """Return the intents with a parameter of this list."""
        return models.Intent.objects.filter(slots__kind=f"value:{row.key}")
