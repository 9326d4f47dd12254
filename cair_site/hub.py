"""The Hub: the facade that all clients speak to; one request is one turn (paper, "Hub")."""

import msgspec
from drf_spectacular.utils import OpenApiParameter, extend_schema
from rest_framework import serializers
from rest_framework.decorators import action
from rest_framework.request import Request
from rest_framework.response import Response

from cair_site.errors import ApiError
from cair_site.services import Services
from dialogue.api import (
    ReplySerializer,
    TurnRequest,
    TurnSerializer,
    sentence_of,
)
from dialogue.engine.manager import Reply
from dialogue.publishing import current
from dialogue.turns import MOST_SEED, first_turn, write_state
from languages.known import LANGUAGES
from plans.api import Json
from plans.timed_views import TimedViewSet


class StartSerializer(serializers.Serializer):
    dialogue_state = serializers.CharField()
    first_sentence = serializers.CharField()
    language = serializers.CharField()
    culture = serializers.CharField()
    topic = serializers.CharField(allow_blank=True)


class OptionsSerializer(serializers.Serializer):
    languages = serializers.ListField(child=serializers.DictField())
    cultures = serializers.ListField(child=serializers.DictField())


def start_json(said: Reply) -> Json:
    """Return the beginning of a talk."""
    return {
        "dialogue_state": write_state(said.state),
        "first_sentence": said.sentence,
        "language": said.state.language,
        "culture": said.state.culture,
        "topic": said.topic,
    }


def options_json() -> Json:
    """Return the languages and cultures one can talk in."""
    return {
        "languages": [
            {"code": one.code, "tag": one.tag, "own_name": one.own_name}
            for one in LANGUAGES.values()
        ],
        "cultures": [
            {"code": one.code, "names": one.names, "language": one.language}
            for one in current().knowledge.cultures
        ],
    }


def _seed(text: str) -> int:
    if not text:
        return 0
    if not text.isdecimal() or len(text) > 10 or int(text) > MOST_SEED:
        raise ApiError("body.invalid", f"The seed {text[:20]!r} is wrong.", f"0 to {MOST_SEED}.")
    return int(text)


class HubViewSet(TimedViewSet):
    """The Hub: start a talk, take turns."""

    services = Services()

    @extend_schema(
        parameters=[
            OpenApiParameter("language", str, description="en, it or ja"),
            OpenApiParameter("culture", str, description="EN, IT, JP or IN"),
            OpenApiParameter(
                "seed",
                str,
                description=f"0 to {MOST_SEED}: the same seed gives the same replies.",
            ),
        ],
        responses=StartSerializer,
    )
    def list(self, request: Request) -> Response:
        """Start a talk: the initial dialogue state and the first sentence."""
        asked = request.query_params
        language, culture = asked.get("language", ""), asked.get("culture", "")
        seed = _seed(asked.get("seed", ""))
        return Response(start_json(first_turn(current(), language, culture, seed)))

    @extend_schema(request=TurnSerializer, responses=ReplySerializer)
    def create(self, request: Request) -> Response:
        """Take a turn: what the person said and the state in; what to say and do out."""
        asked = msgspec.convert(request.data, TurnRequest)
        return Response(self.services.turn(current(), asked, sentence_of(asked)))

    @extend_schema(responses=OptionsSerializer)
    @action(detail=False, url_path="options")
    def choices(self, request: Request) -> Response:
        """List the languages and cultures there are."""
        return Response(options_json())
