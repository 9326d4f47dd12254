"""The ontology over REST: out as OWL, in by an import that runs apart and is asked about."""

from typing import Any

from django.http import HttpResponseBase
from django.urls import reverse
from drf_spectacular.types import OpenApiTypes
from drf_spectacular.utils import OpenApiParameter, OpenApiResponse, extend_schema
from rest_framework import serializers
from rest_framework.decorators import action
from rest_framework.request import Request
from rest_framework.response import Response
from rest_framework.viewsets import ViewSet

from authoring.ontology import exports, imports, telling
from authoring.ontology.sending import GZIP, OWL, sent
from cair_site.api_keys import key_of
from cair_site.errors import ApiError
from cair_site.ontology_parser import OwlParser
from ontology_io.owl.limits import OwlError

_YES = frozenset(("1", "true", "yes"))
_FLAG = "1, true or yes."


class ProblemSerializer(serializers.Serializer):
    error = serializers.BooleanField()
    where = serializers.CharField()
    text = serializers.CharField()
    hint = serializers.CharField()


class ChangeSerializer(serializers.Serializer):
    kind = serializers.CharField()
    what = serializers.CharField()
    key = serializers.CharField()
    details = serializers.ListField(child=serializers.CharField())


class StartedSerializer(serializers.Serializer):
    number = serializers.IntegerField()
    address = serializers.CharField()


class ImportSerializer(serializers.Serializer):
    number = serializers.IntegerField()
    step = serializers.CharField()
    ended = serializers.BooleanField()
    applied = serializers.BooleanField()
    problems = ProblemSerializer(many=True)
    problems_total = serializers.IntegerField()
    differences = serializers.DictField(child=serializers.DictField())
    changes = ChangeSerializer(many=True)
    changes_total = serializers.IntegerField()
    renamed = serializers.ListField(child=serializers.ListField(child=serializers.CharField()))
    unknown = serializers.DictField(child=serializers.IntegerField())
    persons = serializers.IntegerField()
    to_mend = ProblemSerializer(many=True)
    to_mend_total = serializers.IntegerField()


class OntologyViewSet(ViewSet):
    """The knowledge base as OWL 2. Needs a key that may have it."""

    parser_classes = [OwlParser]

    @extend_schema(
        parameters=[
            OpenApiParameter("release", str, description="Its number; without it the draft."),
            OpenApiParameter("gzip", str, description=f"As a gzip file: {_FLAG}"),
        ],
        responses={(200, OWL): OpenApiTypes.BINARY, (200, GZIP): OpenApiTypes.BINARY},
    )
    def list(self, request: Request) -> HttpResponseBase:
        """Send the draft or a release as RDF/XML."""
        asked = request.query_params.get("release", "")
        try:
            export = exports.export(asked)
        except exports.UnknownReleaseError as error:
            raise ApiError("release.unknown") from error
        except exports.DamagedReleaseError as error:
            raise ApiError("release.damaged") from error
        accepts = request.headers.get("Accept-Encoding", "")
        return sent(export.chunks, export.name, packed=_flag(request, "gzip"), accepts=accepts)

    @extend_schema(
        parameters=[
            OpenApiParameter("apply", str, description=f"Bring it into the draft too: {_FLAG}"),
            OpenApiParameter("keep", str, description=f"Keep what the file lacks: {_FLAG}"),
        ],
        request={OWL: OpenApiTypes.BINARY, "application/octet-stream": OpenApiTypes.BINARY},
        responses={202: OpenApiResponse(StartedSerializer, "Ask the address how it goes on.")},
    )
    def create(self, request: Request) -> Response:
        """Start an import of the file in the body; without `apply` it is compared only."""
        data: Any = request.data
        if not data:
            raise ApiError("ontology.no_file")
        try:
            number = imports.begin_for_program(
                key_of(request._request).number,
                data,
                keep=_flag(request, "keep"),
                apply=_flag(request, "apply"),
            )
        except imports.BusyError as error:
            raise ApiError("ontology.busy") from error
        except OwlError as error:
            first = error.problems[0]
            raise ApiError("ontology.damaged", first.text, first.hint) from error
        address = reverse("ontology-imports", args=[number])
        return Response(
            {"number": number, "address": address}, status=202, headers={"Location": address}
        )

    @extend_schema(responses=ImportSerializer)
    @action(detail=False, url_path="imports/(?P<number>[0-9]{1,9})")
    def imports(self, request: Request, number: str = "") -> Response:
        """Tell how an import goes on or ended."""
        run = imports.run(int(number))
        if run is None:
            raise ApiError("ontology.unknown_import")
        return Response(telling.told(run))


def _flag(request: Request, name: str) -> bool:
    return str(request.query_params.get(name, "")).lower() in _YES
