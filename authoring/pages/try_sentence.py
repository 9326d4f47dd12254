"""Try a sentence: a page of its own, and the answers to the page of an intent."""

from dataclasses import asdict
from typing import Any

from django.contrib import admin
from django.http import HttpRequest, HttpResponse, HttpResponseNotAllowed, JsonResponse, QueryDict
from django.template.loader import render_to_string
from django.template.response import TemplateResponse
from django.utils.translation import gettext as _

from authoring.intent_page import results
from authoring.intent_page.draft_library import Compiled, draft_library, with_unsaved
from authoring.intent_page.faults import faults
from authoring.intent_page.posted import posted_intent
from authoring.intent_page.trying import LONGEST, Tried, tried
from authoring.intent_page.wordings import WAYS
from languages.known import LANGUAGES


def try_sentence(request: HttpRequest) -> HttpResponse:
    """Show the page; with a sentence in the address, what becomes of it."""
    language, sentence = _language(request.GET), request.GET.get("sentence", "").strip()
    context = {
        **admin.site.each_context(request),
        "title": _("Try a sentence"),
        "languages": [(code, one.own_name) for code, one in LANGUAGES.items()],
        "language": language,
        "sentence": sentence,
        "longest": LONGEST,
    }
    if sentence:
        context |= _answered(draft_library(), sentence, language)
    return TemplateResponse(request, "authoring/try.html", context)


def try_answer(request: HttpRequest) -> HttpResponse:
    """Answer with what becomes of a sentence as JSON, the unsaved form of an intent included."""
    if request.method != "POST":
        return HttpResponseNotAllowed(["POST"])
    language, sentence = _language(request.POST), request.POST.get("sentence", "").strip()
    compiled, unsaved = _compiled(request.POST)
    answered = _answered(compiled, sentence, language, unsaved)
    found: Tried | None = answered.get("tried")
    html = render_to_string("authoring/try_answer.html", answered, request)
    return JsonResponse({"html": html, "tried": asdict(found) if found else None})


def check_intent(request: HttpRequest) -> HttpResponse:
    """Answer with the faults of an unsaved form; with `tests`, what tests and checks say too."""
    if request.method != "POST":
        return HttpResponseNotAllowed(["POST"])
    posted = posted_intent(request.POST, _number(request.POST))
    answer: dict[str, Any] = {"faults": [asdict(one) for one in faults(posted)]}
    if request.POST.get("tests"):
        compiled = with_unsaved(posted.intent)
        marks = results.test_marks(posted, compiled)
        context = {
            "marks": marks,
            "failing": [one for one in marks if one.reason],
            "remarks": results.remarks(compiled, posted.intent.number),
            "left_out": [one for one in compiled.problems if one.where == posted.intent.key],
        }
        answer["marks"] = [asdict(one) for one in marks]
        answer["html"] = render_to_string("authoring/try_checks.html", context, request)
    return JsonResponse(answer)


def failing_intents(request: HttpRequest) -> HttpResponse:
    """Answer with how many stored tests of each intent of the draft fail."""
    return JsonResponse({"failing": results.failing_tests()})


def _compiled(data: QueryDict) -> tuple[Compiled, int]:
    """Return the library to try, and the number of the intent that is being written (or -1)."""
    if "triggers-TOTAL_FORMS" not in data:
        return draft_library(), -1
    number = _number(data)
    return with_unsaved(posted_intent(data, number).intent), number


def _answered(
    compiled: Compiled, sentence: str, language: str, unsaved: int = -1
) -> dict[str, Any]:
    if not sentence:
        return {"refused": _("Write a sentence first.")}
    if len(sentence) > LONGEST:
        refused = _("The sentence has %(n)d characters. Use at most %(most)d.")
        return {"refused": refused % {"n": len(sentence), "most": LONGEST}}
    found = tried(compiled, sentence, language, unsaved)
    return {
        "tried": found,
        "way": WAYS.get(found.winner.way, "") if found.winner else "",
        "left_out": compiled.problems,
        "unsaved": unsaved,
        "language": language,
    }


def _language(data: QueryDict) -> str:
    code = data.get("language", "")
    return code if code in LANGUAGES else next(iter(LANGUAGES))


def _number(data: QueryDict) -> int:
    text = data.get("intent", "")
    return int(text) if text.isascii() and text.isdecimal() and len(text) < 10 else 0
