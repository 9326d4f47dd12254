"""What the OpenAPI page says beyond the views: keys, and every refusal in its one shape."""

from http import HTTPStatus
from typing import Any

from drf_spectacular.openapi import AutoSchema
from drf_spectacular.plumbing import is_list_serializer
from rest_framework import serializers

from cair_site.errors import ERRORS

_ONTOLOGY = "/api/v1/ontology/"
_ANYWHERE = ("400", "401", "403", "429", "503")
_JSON = "application/json"
_KEY: dict[str, list[str]] = {"ApiKey": []}
_WITHOUT: dict[str, list[str]] = {}
_HEADERS = {
    "401": {"WWW-Authenticate": {"schema": {"type": "string"}}},
    "429": {
        "Retry-After": {
            "description": "Seconds to wait.",
            "schema": {"type": "integer", "minimum": 1},
        }
    },
}


class ErrorSerializer(serializers.Serializer[Any]):
    code = serializers.ChoiceField([(code, kind.message) for code, kind in ERRORS.items()])
    message = serializers.CharField()
    hint = serializers.CharField(help_text="What to do.")


class RefusalSerializer(serializers.Serializer[Any]):
    error = ErrorSerializer()


class Schema(AutoSchema):
    """Every call answers 200 or what its view names, and refuses as docs/errors.md says."""

    def get_auth(self) -> list[Any]:
        """Return that a key is wanted for the ontology, and may be wanted elsewhere."""
        return [_KEY] if self.path.startswith(_ONTOLOGY) else [_KEY, _WITHOUT]

    def map_parsers(self) -> list[str]:
        """Return what bodies are; that no Content-Type is needed is a kindness to clients."""
        return [_JSON]

    def _is_create_operation(self) -> bool:
        return False  # A POST is a question here, nothing is made: 200.

    def _is_list_view(self, serializer: Any = None) -> bool:
        if serializer is None:
            return super()._is_list_view()
        return is_list_serializer(serializer)

    def _get_response_bodies(self, direction: Any = "response") -> Any:
        bodies = super()._get_response_bodies(direction)
        refused = self.resolve_serializer(RefusalSerializer(), direction).ref
        for status in self._refusals():
            bodies[status] = {
                "content": {_JSON: {"schema": refused}},
                "description": HTTPStatus(int(status)).phrase,
            }
            if status in _HEADERS:
                bodies[status]["headers"] = _HEADERS[status]
        return bodies

    def _refusals(self) -> list[str]:
        more = {"413"} if self.method == "POST" else set()
        if "{" in self.path:
            more.add("404")
        if self.path == _ONTOLOGY:
            more |= {"409"} if self.method == "POST" else {"404", "500"}
        return sorted({*_ANYWHERE, *more})
