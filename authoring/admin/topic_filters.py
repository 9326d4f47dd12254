"""What the lists of topics and sentences can be narrowed to."""

from collections.abc import Iterable
from typing import Any

from django.contrib.admin import SimpleListFilter
from django.db.models import Exists, OuterRef, QuerySet
from django.http import HttpRequest
from django.utils.translation import gettext_lazy as _

from authoring.topic_page.neighbours import names_of
from authoring.topic_page.shape import Shape, read_shape
from authoring.topic_page.words import KINDS, LANGUAGE_NAMES
from dialogue.models import Frame, Sentence, TopicName

_SHAPE = "_shape_of_the_draft"
Choices = Iterable[tuple[str, Any]]


def shape_for(request: HttpRequest) -> Shape:
    """Return the shape of the draft, read once a request."""
    shape: Shape | None = getattr(request, _SHAPE, None)
    if shape is None:
        shape = read_shape()
        setattr(request, _SHAPE, shape)
    return shape


class BranchFilter(SimpleListFilter):
    """Topics of one branch, with all that is below it."""

    title = _("branch")
    parameter_name = "branch"
    path = "pk__in"

    def lookups(self, request: HttpRequest, model_admin: Any) -> Choices:
        shape = shape_for(request)
        called = names_of(shape, shape.branches)
        self.shape = shape
        return sorted(((shape.keys[number], called[number]) for number in called), key=str)

    def queryset(self, request: HttpRequest, queryset: QuerySet[Any]) -> QuerySet[Any]:
        numbers = {self.shape.keys[number]: number for number in self.shape.branches}
        number = numbers.get(self.value() or "")
        if number is None:
            return queryset
        return queryset.filter(**{self.path: [number, *self.shape.below(number)]})


class TopicBranchFilter(BranchFilter):
    """Sentences of the topics of one branch."""

    path = "topic__in"


class OwnSentencesFilter(SimpleListFilter):
    """Topics that say something of their own, or only what they inherit."""

    title = _("own sentences")
    parameter_name = "own"

    def lookups(self, request: HttpRequest, model_admin: Any) -> Choices:
        return (("no", _("has none")), ("yes", _("has some")))

    def queryset(self, request: HttpRequest, queryset: QuerySet[Any]) -> QuerySet[Any]:
        own = Exists(Frame.objects.filter(topic=OuterRef("pk")))
        if self.value() == "no":
            return queryset.filter(~own)
        return queryset.filter(own) if self.value() == "yes" else queryset


class _MissingFilter(SimpleListFilter):
    title = _("missing translation")
    parameter_name = "missing"

    def lookups(self, request: HttpRequest, model_admin: Any) -> Choices:
        return tuple((code, _("into %s") % name) for code, name in LANGUAGE_NAMES.items())

    def queryset(self, request: HttpRequest, queryset: QuerySet[Any]) -> QuerySet[Any]:
        code = self.value()
        return self.lacking(queryset, code) if code and code in LANGUAGE_NAMES else queryset

    def lacking(self, queryset: QuerySet[Any], code: str) -> QuerySet[Any]:
        raise NotImplementedError


def unsaid(code: str) -> Any:
    """Return the condition that a frame has no sentence in a language."""
    return ~Exists(Sentence.objects.filter(frame=OuterRef("pk"), language=code))


class MissingNameFilter(_MissingFilter):
    """Topics without a name in a language, or with a sentence that is not said in it."""

    def lacking(self, queryset: QuerySet[Any], code: str) -> QuerySet[Any]:
        named = Exists(TopicName.objects.filter(topic=OuterRef("pk"), language=code))
        silent = Frame.objects.filter(unsaid(code), topic=OuterRef("pk"))
        return queryset.filter(~named | Exists(silent))


class MissingSentenceFilter(_MissingFilter):
    """Sentences that are not said in a language."""

    def lacking(self, queryset: QuerySet[Any], code: str) -> QuerySet[Any]:
        return queryset.filter(unsaid(code))


class KindFilter(SimpleListFilter):
    """Sentences of one kind, in words."""

    title = _("kind")
    parameter_name = "type__exact"

    def lookups(self, request: HttpRequest, model_admin: Any) -> Choices:
        return tuple((kind.letter, kind.name) for kind in KINDS.values())

    def queryset(self, request: HttpRequest, queryset: QuerySet[Any]) -> QuerySet[Any]:
        letter = self.value()
        return queryset.filter(type=letter) if letter in KINDS else queryset
