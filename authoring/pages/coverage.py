"""The page "Coverage": numbers by branch, language and culture, with charts."""

from django.http import HttpRequest, HttpResponse
from django.shortcuts import render
from django.utils.translation import gettext as _
from django.utils.translation import gettext_lazy
from django.views.decorators.http import require_safe

from authoring.coverage.coverage import coverage as read
from authoring.coverage.coverage_charts import depth_chart, family_chart, kinds_chart, liking_charts
from authoring.coverage.coverage_tables import (
    culture_table,
    depth_table,
    family_table,
    kind_table,
    language_table,
    liking_table,
    missing_table,
)
from authoring.pages.page import Page
from authoring.site_context import page_context
from authoring.topic_page.words import LANGUAGE_NAMES, own_language


@require_safe
def coverage(request: HttpRequest) -> HttpResponse:
    """Show the dashboard; `?language=it` chooses the language of the kinds of sentence."""
    asked = request.GET.get("language", "")
    language = asked if asked in LANGUAGE_NAMES else own_language()
    found = read()
    context = {
        **page_context(request),
        "title": _("Coverage"),
        "language": language,
        "languages": LANGUAGE_NAMES.items(),
        "missing": missing_table(found),
        "by_language": language_table(found),
        "kinds": kind_table(found, language),
        "kinds_chart": kinds_chart(found, language),
        "cultures": culture_table(found),
        "liking": liking_table(found),
        "liking_charts": liking_charts(found),
        "depth": depth_table(found),
        "depth_chart": depth_chart(found),
        "families": family_table(found),
        "family_chart": family_chart(found),
    }
    return render(request, "authoring/coverage.html", context)


COVERAGE_PAGE = Page(
    "coverage", "coverage/", coverage, "dialogue.view_topic", gettext_lazy("Coverage"), 15
)
