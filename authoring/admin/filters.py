"""What the coverage dashboard narrows the lists of topics and sentences to."""

from collections.abc import Iterable
from functools import reduce
from operator import or_
from typing import Any

from django.contrib.admin import SimpleListFilter
from django.db.models import Exists, OuterRef, Q, QuerySet
from django.http import HttpRequest
from django.utils.translation import gettext_lazy as _

from authoring.admin.topic_filters import shape_for
from authoring.coverage.coverage import STEPS, coverage
from authoring.topic_page.words import KINDS, LANGUAGE_NAMES
from dialogue.models import KeywordSet, Sentence, TopicInstance, TopicLink, TopicName
from languages.known import LANGUAGES

INCOMPLETE = "incomplete"
Choices = Iterable[tuple[str, Any]]


class _ByLanguage(SimpleListFilter):
    """Rows that have something in a language, or lack it in some language."""

    rows: Any
    link = "topic"

    def lookups(self, request: HttpRequest, model_admin: Any) -> Choices:
        some = tuple((code, _("in %s") % name) for code, name in LANGUAGE_NAMES.items())
        return (*some, (INCOMPLETE, _("not in every language")))

    def queryset(self, request: HttpRequest, queryset: QuerySet[Any]) -> QuerySet[Any]:
        value = self.value()
        here = self.rows.filter(**{self.link: OuterRef("pk")})
        if value == INCOMPLETE:
            lacking = (Q(~Exists(here.filter(language=code))) for code in LANGUAGES)
            return queryset.filter(reduce(or_, lacking))
        return (
            queryset.filter(Exists(here.filter(language=value))) if value in LANGUAGES else queryset
        )


class NamedFilter(_ByLanguage):
    """Topics with a name in a language."""

    title = _("name")
    parameter_name = "named"
    rows = TopicName.objects


class SpeakingFilter(_ByLanguage):
    """Topics with sentences of their own in a language."""

    title = _("sentences of its own")
    parameter_name = "speaking"
    rows = Sentence.objects
    link = "frame__topic"

    def lookups(self, request: HttpRequest, model_admin: Any) -> Choices:
        return tuple(super().lookups(request, model_admin))[:-1]


class KeywordFilter(_ByLanguage):
    """Topics with keywords in a language."""

    title = _("keywords")
    parameter_name = "words"
    rows = KeywordSet.objects


class SaidFilter(_ByLanguage):
    """Sentences that are said in a language."""

    title = _("language")
    parameter_name = "said"
    rows = Sentence.objects
    link = "frame"


class OfTopicFilter(SimpleListFilter):
    """Sentences of topics, not of pools."""

    title = _("belongs to")
    parameter_name = "of"

    def lookups(self, request: HttpRequest, model_admin: Any) -> Choices:
        return (("topics", _("a topic")), ("pools", _("no topic")))

    def queryset(self, request: HttpRequest, queryset: QuerySet[Any]) -> QuerySet[Any]:
        if self.value() not in ("topics", "pools"):
            return queryset
        return queryset.filter(topic__isnull=self.value() == "pools")


class LinkFilter(SimpleListFilter):
    """Topics that lead to others, or to none."""

    title = _("links")
    parameter_name = "links"

    def lookups(self, request: HttpRequest, model_admin: Any) -> Choices:
        return (("no", _("leads to no other topic")), ("yes", _("leads to others")))

    def queryset(self, request: HttpRequest, queryset: QuerySet[Any]) -> QuerySet[Any]:
        links = Exists(TopicLink.objects.filter(topic=OuterRef("pk")))
        if self.value() == "no":
            return queryset.filter(~links)
        return queryset.filter(links) if self.value() == "yes" else queryset


class GapFilter(SimpleListFilter):
    """Topics whose order of sentences asks for a kind that nothing provides."""

    title = _("a kind of sentence is missing")
    parameter_name = "gap"

    def lookups(self, request: HttpRequest, model_admin: Any) -> Choices:
        kinds = tuple((kind.letter, kind.name) for kind in KINDS.values())
        return (("any", _("any kind")), *kinds)

    def queryset(self, request: HttpRequest, queryset: QuerySet[Any]) -> QuerySet[Any]:
        value = self.value()
        if value != "any" and value not in KINDS:
            return queryset
        found = coverage().gaps
        lacking = [one for one, kinds in found.items() if value == "any" or value in kinds]
        return queryset.filter(pk__in=lacking)


class _ShownWhenUsed(SimpleListFilter):
    """A filter that only links lead to: the list shows it while it narrows."""

    def lookups(self, request: HttpRequest, model_admin: Any) -> Choices:
        value = self.value()
        words = self.words(value) if value else None
        return ((value, words),) if value and words else ()

    def words(self, value: str) -> Any:
        """Return what a value means in words; None for nonsense."""
        raise NotImplementedError


class DepthFilter(_ShownWhenUsed):
    """Topics so many steps below the root; branches are 1."""

    title = _("depth in the tree")
    parameter_name = "depth"

    def words(self, value: str) -> Any:
        return value if value.isascii() and value.isdecimal() and len(value) < 4 else None

    def queryset(self, request: HttpRequest, queryset: QuerySet[Any]) -> QuerySet[Any]:
        value = self.value()
        if not value or not self.words(value):
            return queryset
        shape, level = shape_for(request), [None]
        for _step in range(min(int(value), len(shape.keys))):
            level = [child for one in level for child in shape.children.get(one, ())]  # type: ignore[misc]
        return queryset.filter(pk__in=level)


class LikingFilter(_ShownWhenUsed):
    """Topics whose likeliness in a culture lies in one step of 0.1: `IN-7` from 0.7 below 0.8."""

    title = _("likeliness")
    parameter_name = "liking"

    def words(self, value: str) -> Any:
        code, dash, step = value.rpartition("-")
        if not (code and dash and step in {str(one) for one in range(STEPS)}):
            return None
        return f"{code} {_least(step)}–{_least(int(step) + 1)}"

    def queryset(self, request: HttpRequest, queryset: QuerySet[Any]) -> QuerySet[Any]:
        value = self.value()
        if not value or not self.words(value):
            return queryset
        code, _dash, step = value.rpartition("-")
        here = TopicInstance.objects.filter(
            topic=OuterRef("pk"), culture__code=code, likeliness__gte=_least(step)
        )
        if int(step) + 1 < STEPS:
            here = here.filter(likeliness__lt=_least(int(step) + 1))
        return queryset.filter(Exists(here))


def _least(step: str | int) -> str:
    return f"{int(step) / STEPS:.1f}"


#: To be added to `list_filter` of the lists of topics and of sentences.
TOPIC_FILTERS = (
    NamedFilter,
    SpeakingFilter,
    KeywordFilter,
    LinkFilter,
    GapFilter,
    DepthFilter,
    LikingFilter,
)
FRAME_FILTERS = (SaidFilter, OfTopicFilter)
