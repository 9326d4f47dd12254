"""The page "Ontology": the whole draft or a release as an OWL file, and the way in for one."""

from pathlib import PurePosixPath
from typing import Any

from django.conf import settings
from django.core.exceptions import PermissionDenied
from django.core.files.uploadedfile import UploadedFile
from django.http import Http404, HttpRequest, HttpResponse, HttpResponseBase
from django.shortcuts import redirect, render
from django.utils.translation import gettext as _
from django.views.decorators.cache import never_cache
from django.views.decorators.csrf import csrf_exempt, csrf_protect
from django.views.decorators.http import require_http_methods, require_safe

from authoring.ontology import exports, imports, words
from authoring.ontology.sending import sent
from authoring.pages.publish import MAY_PUBLISH
from authoring.pages.releases import MAY_REWRITE
from authoring.releases import releases
from authoring.site_context import page_context
from ontology_io.owl.limits import OwlError

EXPORT = "dialogue.export_content"
MOST_RELEASES = 50
#: What a form adds to the file it carries, at most so many bytes.
AROUND = 10_000
LONGEST_NAME = 100


def may_import(request: HttpRequest) -> bool:
    """Say whether a person may write the whole draft anew from a file."""
    return request.user.has_perms((MAY_PUBLISH, *MAY_REWRITE))


@never_cache
@require_safe
def ontology(request: HttpRequest) -> HttpResponse:
    """Show how to take the ontology out, how to bring it in, and who did lately."""
    return page(request)


def page(request: HttpRequest, trouble: str = "", status: int = 0) -> HttpResponse:
    """Return the page, with trouble told above it."""
    longest = settings.CAIR_LONGEST_ONTOLOGY
    busy = imports.busy()
    context: dict[str, Any] = {
        **page_context(request),
        "title": _("Ontology"),
        "releases": releases.rows()[:MOST_RELEASES],
        "runs": [(one, words.short(one), words.mood(one)) for one in imports.last_runs()],
        "may_import": may_import(request),
        "busy": busy,
        "busy_words": words.busy(busy) if busy else "",
        "most_bytes": longest,
        "most_megabytes": max(1, longest // 1_000_000),
        "too_large": words.too_large(longest),
        "trouble": trouble,
    }
    status = status or (400 if trouble else 200)
    return render(request, "authoring/ontology.html", context, status=status)


@require_safe
def ontology_file(request: HttpRequest) -> HttpResponseBase:
    """Send the draft or a release as OWL, with ?form=gz as a gzip file."""
    try:
        export = exports.export(request.GET.get("release", ""))
    except exports.UnknownReleaseError as error:
        raise Http404 from error
    except exports.DamagedReleaseError:
        return page(request, _("This release is damaged and cannot be read. Choose another one."))
    accepts = request.headers.get("Accept-Encoding", "")
    packed = request.GET.get("form") == "gz"
    return sent(export.chunks, export.name, packed=packed, accepts=accepts)


@csrf_exempt
@never_cache
@require_http_methods(["GET", "HEAD", "POST"])
def upload(request: HttpRequest) -> HttpResponseBase:
    """Take a file that is to be brought in; one that is too large is refused before it is read.

    The token of the form is asked for after that: reading it reads the whole body.
    """
    if request.method != "POST":
        return redirect("admin:ontology")
    if not may_import(request):
        raise PermissionDenied
    length = request.META.get("CONTENT_LENGTH") or "0"
    longest = settings.CAIR_LONGEST_ONTOLOGY + AROUND
    if not length.isdecimal() or int(length[:15]) > longest:
        request.META["CONTENT_LENGTH"] = "0"  # Nothing below looks into the body either.
        return page(request, words.too_large(settings.CAIR_LONGEST_ONTOLOGY), 413)
    return _upload(request)


@csrf_protect
def _upload(request: HttpRequest) -> HttpResponse:
    brought = request.FILES.get("file")
    if brought is None:
        return page(request, _("Choose a file first."))
    if (brought.size or 0) > settings.CAIR_LONGEST_ONTOLOGY:
        return page(request, words.too_large(settings.CAIR_LONGEST_ONTOLOGY), 413)
    if not brought.size:
        return page(request, _("The file is empty. Choose another one."))
    return _begin(request, brought)


def _begin(request: HttpRequest, brought: "UploadedFile[bytes]") -> HttpResponse:
    keep = bool(request.POST.get("keep"))
    try:
        name = plain_name(brought.name or "")
        number = imports.begin(request.user.pk, name, brought.read(), keep=keep)
    except imports.BusyError as error:
        return page(request, words.busy(error.run), 409)
    except OwlError as error:
        return page(request, " ".join(f"{one.text} {one.hint}" for one in error.problems))
    return redirect("admin:ontology_import", number)


def plain_name(name: str) -> str:
    """Return a file's name without its folders and without what is no letter, sign or blank."""
    last = PurePosixPath(name.replace("\\", "/")).name
    plain = "".join(letter for letter in last if letter.isprintable())
    return plain[-LONGEST_NAME:] or _("a file")
