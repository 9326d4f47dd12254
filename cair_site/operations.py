"""What load balancers and operators ask: alive, ready."""

from django.http import HttpRequest, JsonResponse

from dialogue.publishing import NothingPublishedError, current


def livez(request: HttpRequest) -> JsonResponse:
    """Say that the process answers; the database is not asked."""
    return JsonResponse({"alive": True})


def readyz(request: HttpRequest) -> JsonResponse:
    """Say whether a publication is loaded; a lost database does not make a worker unready."""
    try:
        number = current().number
    except NothingPublishedError:
        return JsonResponse({"ready": False, "publication": None}, status=503)
    return JsonResponse({"ready": True, "publication": number})
