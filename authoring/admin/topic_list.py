"""The list of topics: what each row shows is read for the whole page at once."""

from typing import Any

from django.contrib.admin.views.main import ChangeList
from django.db.models import Count, OuterRef, QuerySet, Subquery
from django.db.models.functions import Coalesce
from django.http import HttpRequest
from django.utils.html import format_html_join
from django.utils.translation import gettext as _

from authoring.admin.topic_filters import shape_for
from authoring.checks.findings import findings_for
from authoring.topic_page.words import LANGUAGE_NAMES
from dialogue.models import Frame, Topic
from languages.known import LANGUAGES


class TopicList(ChangeList):
    """A page of topics with their branch, their sentences counted, and what was found."""

    def get_queryset(self, request: HttpRequest, *args: Any, **kwargs: Any) -> QuerySet[Any]:
        """Count each topic's sentences, and fetch all names at once."""
        self.root_queryset = counted(self.root_queryset)
        found: QuerySet[Any] = super().get_queryset(request, *args, **kwargs)
        with_names: QuerySet[Any] = found.prefetch_related("names")
        return with_names

    def get_results(self, request: HttpRequest) -> None:
        """Give each topic of the page what its columns show."""
        super().get_results(request)
        self.result_list = list(self.result_list)
        shape = shape_for(request)
        found = findings_for([topic.key for topic in self.result_list])
        for topic in self.result_list:
            topic.branch_key = shape.keys.get(shape.branch(topic.pk), "")
            topic.found = found.get(topic.key, ())
            topic.unnamed = _unnamed(topic)


def _unnamed(topic: Topic) -> list[str]:
    named = {name.language for name in topic.names.all()}
    return [code for code in LANGUAGES if code not in named]


def counted(rows: QuerySet[Any]) -> QuerySet[Any]:
    """Return topics with the number of their own sentences."""
    own = Frame.objects.filter(topic=OuterRef("pk")).order_by().values("topic")
    count = Subquery(own.annotate(count=Count("pk")).values("count"))
    with_counts: QuerySet[Any] = rows.annotate(sentence_count=Coalesce(count, 0))
    return with_counts


def badges(topic: Topic) -> str:
    """Return what is wrong with a topic as badges: missing names, what a check found."""
    unnamed, found = getattr(topic, "unnamed", ()), getattr(topic, "found", ())
    rows = [("bad", _("no name in %s") % LANGUAGE_NAMES[code]) for code in unnamed]
    blocking = [one for one in found if one.blocks]
    if blocking:
        rows.append(("bad", _("%d to correct") % len(blocking)))
    if len(found) > len(blocking):
        rows.append(("warn", _("%d to look at") % (len(found) - len(blocking))))
    return format_html_join(" ", '<span class="badge {}">{}</span>', rows)
