"""The pages of spreadsheets: take one out, bring one in, look, save."""

from typing import Any

from django.contrib import messages
from django.core.files.uploadedfile import UploadedFile
from django.http import Http404, HttpRequest, HttpResponse
from django.shortcuts import redirect, render
from django.utils import timezone
from django.utils.text import slugify
from django.utils.translation import gettext as _
from django.utils.translation import gettext_lazy, ngettext
from django.views.decorators.cache import never_cache
from django.views.decorators.http import require_http_methods, require_safe

from authoring.pages.page import Page
from authoring.sheets import limits
from authoring.sheets.columns import DELETE
from authoring.sheets.preview import preview, sealed, unsealed
from authoring.sheets.reading import read_table
from authoring.sheets.saving import CannotSaveError, NotAsShownError, changing, save
from authoring.sheets.sheet import Sheet
from authoring.sheets.table import SHEETS
from authoring.sheets.tables import Table, UnreadableError
from authoring.sheets.writing import CONTENT_TYPES, XLSX, written
from authoring.site_context import page_context

EXPORT, IMPORT = "dialogue.export_content", "dialogue.change_topic"


@require_safe
def sheets(request: HttpRequest) -> HttpResponse:
    """Show the kinds of sheets."""
    context = {
        **page_context(request),
        "title": _("Spreadsheets"),
        "sheets": SHEETS.values(),
        "may_import": request.user.has_perm(IMPORT),
    }
    return render(request, "authoring/sheets.html", context)


@never_cache
@require_safe
def sheet(request: HttpRequest, kind: str) -> HttpResponse:
    """Show one kind: what it holds, how to take it out, how to bring it back."""
    return _page(request, _sheet(request, kind))


def _sheet(request: HttpRequest, kind: str) -> Sheet:
    if kind not in SHEETS:
        raise Http404
    return SHEETS[kind](may=request.user.has_perm)


def _page(request: HttpRequest, one: Sheet, trouble: str = "") -> HttpResponse:
    chosen = {name: request.GET.get(name, "")[:100] for name in one.filters}
    context = {
        **page_context(request),
        "title": one.title,
        "sheet": one,
        "sheets": SHEETS.values(),
        "filters": [
            (name, label, list(one.choices(name)), chosen[name])
            for name, label in one.filters.items()
        ],
        "headers": one.headers(),
        "most_rows": limits.limit("CAIR_SHEET_ROWS"),
        "most_megabytes": limits.limit("CAIR_SHEET_BYTES") // 1_000_000,
        "may_import": _may_import(request, one),
        "trouble": trouble,
    }
    return render(request, "authoring/sheet.html", context, status=400 if trouble else 200)


def _may_import(request: HttpRequest, one: Sheet) -> bool:
    changes = [name.replace(".", ".change_") for name in one.writes]
    return request.user.has_perms([IMPORT, *changes])


@require_safe
def file(request: HttpRequest, kind: str) -> HttpResponse:
    """Send a sheet as a file."""
    one = _sheet(request, kind)
    form = request.GET.get("form", XLSX)
    if form not in CONTENT_TYPES:
        raise Http404
    chosen = {name: request.GET.get(name, "")[:100] for name in one.filters}
    headers = one.headers(chosen.get("language", ""))
    data = written(form, one.tab, headers, one.lines(chosen))
    response = HttpResponse(data, content_type=CONTENT_TYPES[form])
    parts = [one.name, *(slugify(text) for text in chosen.values() if slugify(text))]
    name = "-".join([*parts, timezone.localdate().isoformat()])[:120]
    response["Content-Disposition"] = f'attachment; filename="{name}.{form}"'
    return response


@never_cache
@require_http_methods(["GET", "HEAD", "POST"])
def look(request: HttpRequest, kind: str) -> HttpResponse:
    """Show what a sheet that was brought would change; nothing is saved."""
    one = _sheet(request, kind)
    if request.method != "POST":
        return redirect("admin:sheet", kind)
    brought = request.FILES.get("file")
    if not _may_import(request, one):
        return _page(request, one, _("You may take this sheet out, but not bring it in."))
    if brought is None:
        return _page(request, one, _("Choose a file first."))
    try:
        table = _table(brought, one)
        return _shown(request, one, table, one.judge(table))
    except UnreadableError as error:
        return _page(request, one, str(error))


def _table(brought: "UploadedFile[bytes]", one: Sheet) -> Table:
    most = limits.limit("CAIR_SHEET_BYTES")
    if (brought.size or 0) > most:
        words = _("The file has more than %(n)d MB. Bring a part of it, e.g. one branch.")
        raise UnreadableError(words % {"n": most // 1_000_000})
    known = [*(column.name for column in one.columns), DELETE]
    return read_table(brought.name or "", brought.read(), known, one.tab)


def _shown(
    request: HttpRequest, one: Sheet, table: Table, records: Any, trouble: str = ""
) -> HttpResponse:
    context = {
        **page_context(request),
        "title": _("What the sheet changes: %(title)s") % {"title": one.title},
        "sheet": one,
        "is_nav_sidebar_enabled": False,  # The lines need the room.
        "preview": preview(one, table, records),
        "total": len(changing(records)),
        "lines": len(records),
        "sealed": sealed(one, table, records, request.user.pk or 0),
        "trouble": trouble,
    }
    return render(request, "authoring/sheet_preview.html", context, status=409 if trouble else 200)


@never_cache
@require_http_methods(["GET", "HEAD", "POST"])
def keep(request: HttpRequest, kind: str) -> HttpResponse:
    """Save what was shown, if the draft is still as it was then."""
    one = _sheet(request, kind)
    if request.method != "POST":
        return redirect("admin:sheet", kind)
    if not _may_import(request, one):
        return _page(request, one, _("You may take this sheet out, but not bring it in."))
    try:
        table, shown = unsealed(one, request.POST.get("sealed", ""), request.user.pk or 0)
        records = save(one, table, shown)
    except NotAsShownError as error:
        return _shown(request, one, table, error.records, str(error))
    except (UnreadableError, CannotSaveError) as error:
        return _page(request, one, str(error))
    count = len(changing(records))
    words = ngettext(
        "%(n)d row is saved. Robots say it once you publish.",
        "%(n)d rows are saved. Robots say it once you publish.",
        count,
    )
    messages.success(request, words % {"n": count})
    return redirect("admin:sheet", kind)


SHEET_PAGES = (
    Page("sheets", "sheets/", sheets, EXPORT, gettext_lazy("Spreadsheets"), 45),
    Page("sheet", "sheets/<str:kind>/", sheet, EXPORT),
    Page("sheet_file", "sheets/<str:kind>/file/", file, EXPORT),
    Page("sheet_preview", "sheets/<str:kind>/preview/", look, IMPORT),
    Page("sheet_save", "sheets/<str:kind>/save/", keep, IMPORT),
)
