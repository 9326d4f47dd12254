"""The page "API keys": make one (shown once), see when each was used, revoke."""

from django.contrib import messages
from django.core.exceptions import PermissionDenied, ValidationError
from django.http import HttpRequest, HttpResponse
from django.shortcuts import get_object_or_404, redirect, render
from django.utils.translation import gettext as _
from django.views.decorators.http import require_http_methods

from authoring.keys import make_key, revoke
from authoring.models.api_key import ONTOLOGY, ApiKey
from authoring.site_context import page_context

MOST_SHOWN = 500


@require_http_methods(["GET", "HEAD", "POST"])
def keys(request: HttpRequest) -> HttpResponse:
    """Show the keys; on POST make or revoke one."""
    if request.method != "POST":
        return _page(request)
    if "revoke" in request.POST:
        return _revoked(request)
    return _made(request)


def _page(request: HttpRequest, status: int = 200, **more: object) -> HttpResponse:
    rows = ApiKey.objects.select_related("created_by")[:MOST_SHOWN]
    context = {
        **page_context(request),
        "title": _("API keys"),
        "choices": ONTOLOGY.items(),
        "keys": rows,
        "may_make": request.user.has_perm("authoring.add_apikey"),
        "may_revoke": request.user.has_perm("authoring.change_apikey"),
        **more,
    }
    return render(request, "authoring/keys.html", context, status=status)


def _made(request: HttpRequest) -> HttpResponse:
    if not request.user.has_perm("authoring.add_apikey"):
        raise PermissionDenied
    label, rate = request.POST.get("label", "").strip(), request.POST.get("rate", "").strip()
    chosen = request.POST.get("ontology", "")[:20]
    try:
        row, key = make_key(label, _rate(rate), request.user, chosen)
    except ValidationError as error:
        given = {"label": label[:200], "rate": rate[:20], "chosen": chosen}
        return _page(request, status=400, faults=error.message_dict, **given)
    response = _page(request, new=row, new_key=key)
    response.headers["Cache-Control"] = "no-store"
    return response


def _rate(text: str) -> int | None:
    if not text:
        return None
    if not (text.isascii() and text.isdecimal() and len(text) < 9):
        raise ValidationError({"rate": _("Write a whole number, or leave it empty.")})
    return int(text)


def _revoked(request: HttpRequest) -> HttpResponse:
    if not request.user.has_perm("authoring.change_apikey"):
        raise PermissionDenied
    number = request.POST["revoke"]
    known = number.isascii() and number.isdecimal() and len(number) < 10
    row = get_object_or_404(ApiKey, pk=int(number) if known else 0)
    revoke(row)
    messages.success(request, _("%(key)s lets nobody in any more.") % {"key": row})
    return redirect("admin:keys")
