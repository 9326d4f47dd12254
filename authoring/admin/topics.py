"""The authoring page of topics."""

from typing import Any

from django.contrib import admin
from django.db.models import QuerySet
from django.http import HttpRequest, HttpResponse
from django.utils.translation import gettext_lazy as _

from authoring.admin.base import PlacedAdmin
from authoring.admin.filters import TOPIC_FILTERS
from authoring.admin.topic_filters import (
    BranchFilter,
    MissingNameFilter,
    OwnSentencesFilter,
)
from authoring.admin.topic_forms import (
    KeywordForm,
    KnownAutocomplete,
    LikelinessForm,
    LinkForm,
    NameForm,
    OnePerLanguageFormSet,
    TopicForm,
)
from authoring.admin.topic_list import TopicList, badges
from authoring.topic_page.topic_context import topic_context
from dialogue import authoring, models
from languages.known import LANGUAGES


class LanguageInline(admin.StackedInline):
    """One row a language."""

    formset = OnePerLanguageFormSet
    template = "admin/dialogue/topic/languages.html"

    def get_extra(self, request: HttpRequest, obj: Any = None, **kwargs: Any) -> int:
        return len(LANGUAGES)

    def get_max_num(self, request: HttpRequest, obj: Any = None, **kwargs: Any) -> int:
        return len(LANGUAGES)


class NameInline(LanguageInline):
    model = models.TopicName
    form = NameForm
    tab = "names"
    template = "admin/dialogue/topic/names.html"


class KeywordInline(LanguageInline):
    model = models.KeywordSet
    form = KeywordForm
    tab = "keywords"


class InstanceInline(admin.StackedInline):
    model = models.TopicInstance
    form = LikelinessForm
    extra = 0
    tab = "likeliness"
    template = "admin/dialogue/topic/likeliness.html"

    def get_queryset(self, request: HttpRequest) -> QuerySet[models.TopicInstance]:
        rows: QuerySet[models.TopicInstance] = super().get_queryset(request)
        return rows.select_related("culture").order_by("culture__position", "culture")


class VariableInline(admin.TabularInline):
    model = models.Variable
    extra = 0
    tab = "place"


class LinkInline(admin.TabularInline):
    model = models.TopicLink
    form = LinkForm
    fk_name = "topic"
    extra = 0
    autocomplete_fields = ("target",)
    tab = "place"

    def get_queryset(self, request: HttpRequest) -> QuerySet[models.TopicLink]:
        rows: QuerySet[models.TopicLink] = super().get_queryset(request)
        return rows.select_related("target")

    def formfield_for_foreignkey(self, db_field: Any, request: HttpRequest, **kwargs: Any) -> Any:
        if db_field.name == "target":
            kwargs["widget"] = KnownAutocomplete(db_field, self.admin_site)
        return super().formfield_for_foreignkey(db_field, request, **kwargs)


@admin.register(models.Topic)
class TopicAdmin(PlacedAdmin):
    form = TopicForm
    list_display = ("key", "branch", "names_shown", "home", "own_sentences", "findings")
    list_filter = (
        BranchFilter,
        "home",
        "gentle",
        OwnSentencesFilter,
        MissingNameFilter,
        *TOPIC_FILTERS,
    )
    list_select_related = ("parent", "home")
    list_per_page = 50
    search_fields = ("key", "names__name", "keywords__first", "keywords__second")
    search_help_text = _("A name in any language, a keyword, or the name in the ontology.")
    autocomplete_fields = ("parent", "also")
    fieldsets = (
        (None, {"fields": ("key", "parent", "home", "gentle", "also")}),
        (_("How it talks"), {"fields": ("pattern", "stop")}),
        (_("For colleagues"), {"fields": ("note", "position")}),
    )
    inlines = (NameInline, KeywordInline, InstanceInline, LinkInline, VariableInline)

    def get_queryset(self, request: HttpRequest) -> QuerySet[models.Topic]:
        rows: QuerySet[models.Topic] = super().get_queryset(request)
        return rows.select_related("parent", "home")

    def get_changelist(self, request: HttpRequest, **kwargs: Any) -> type[TopicList]:
        return TopicList

    def formfield_for_foreignkey(self, db_field: Any, request: HttpRequest, **kwargs: Any) -> Any:
        if db_field.name == "parent":
            kwargs["widget"] = KnownAutocomplete(db_field, self.admin_site)
        return super().formfield_for_foreignkey(db_field, request, **kwargs)

    def render_change_form(
        self, request: HttpRequest, context: dict[str, Any], *args: Any, **kwargs: Any
    ) -> HttpResponse:
        """Show with the form what the robot says about the topic."""
        row = kwargs.get("obj")
        if row is not None and not context.get("is_popup"):
            context |= topic_context(request, context, row)
        return super().render_change_form(request, context, *args, **kwargs)

    def save_related(self, request: HttpRequest, form: Any, formsets: Any, change: bool) -> None:
        super().save_related(request, form, formsets, change)
        authoring.give_likeliness(form.instance)
        authoring.rename_frames(form.instance)

    @admin.display(description=_("branch"))
    def branch(self, topic: models.Topic) -> str:
        return getattr(topic, "branch_key", "")

    @admin.display(description=_("names"))
    def names_shown(self, topic: models.Topic) -> str:
        return " · ".join(name.name for name in topic.names.all())

    @admin.display(description=_("own sentences"), ordering="sentence_count")
    def own_sentences(self, topic: models.Topic) -> int:
        return getattr(topic, "sentence_count", 0)

    @admin.display(description=_("findings"))
    def findings(self, topic: models.Topic) -> str:
        return badges(topic)
