"""The person-specific layer over REST: what a dialogue state has learned, as OWL individuals.

It lives here and not in dialogue/, because the managers know nothing of files.
"""

from typing import Annotated, Literal

import msgspec
from django.conf import settings
from drf_spectacular.utils import extend_schema
from rest_framework import serializers
from rest_framework.request import Request
from rest_framework.response import Response
from rest_framework.views import APIView

from cair_site.errors import ApiError
from dialogue.engine.content import Content
from dialogue.engine.state import DialogueState
from dialogue.publishing import current
from dialogue.turns import read_state
from ontology_io.owl.names import individual_names
from ontology_io.owl.write_person import (
    Liking,
    Person,
    PersonalIndividual,
    can_be_written,
    person_owl,
    personal_individuals,
    prefix_of,
)
from plans.api import Json

LONGEST_NAME = 100  # characters


class PersonRequest(msgspec.Struct):
    """A state, and how the person is called in the answer."""

    dialogue_state: str
    name: Annotated[str, msgspec.Meta(max_length=LONGEST_NAME)] = ""
    format: Literal["rdfxml", "json"] = "rdfxml"


class PersonRequestSerializer(serializers.Serializer):
    dialogue_state = serializers.CharField()
    name = serializers.CharField(
        max_length=LONGEST_NAME,
        required=False,
        help_text="Dorothy Smith: the individuals are then DS_TEA; only in the answer, not kept.",
    )
    format = serializers.ChoiceField(
        choices=("rdfxml", "json"), required=False, help_text="json: without the ontology."
    )


class PersonalIndividualSerializer(serializers.Serializer):
    name = serializers.CharField(help_text="DS_TEA")
    topic = serializers.CharField(help_text="Tea")
    likeliness = serializers.FloatField(help_text="0.9")
    specific_of = serializers.CharField(allow_blank=True, help_text="EN_TEA")


class PersonSerializer(serializers.Serializer):
    individuals = PersonalIndividualSerializer(many=True)
    owl = serializers.CharField(allow_blank=True, help_text="RDF/XML; empty for json.")


def likings_of(content: Content, state: DialogueState) -> list[Liking]:
    """Return what the state has learned of topics that are published, in the order of the tree."""
    names = individual_names(content.knowledge)
    return [
        Liking(
            node.key,
            node.number,
            tuple(content.tree.nodes[number].key for number in node.ancestors),
            value,
            names.get((node.key, state.culture), ""),
        )
        for node in content.tree.nodes.values()
        if (value := state.likeliness(node.number)) is not None
    ]


def person_of(content: Content, asked: PersonRequest, state: DialogueState) -> Person:
    """Return whose likings they are. Raises ApiError for a name that no file can hold."""
    label = asked.name.strip()
    if not can_be_written(label):
        raise ApiError(
            "body.invalid", "The name holds a control character.", "Send letters and spaces."
        )
    return Person(label, prefix_of(label, content.cultures), state.culture)


def person_json(individuals: tuple[PersonalIndividual, ...], owl: str) -> Json:
    """Return the individuals as rows, and the ontology they make."""
    rows: list[Json] = [
        {
            "name": one.name,
            "topic": one.liking.topic,
            "likeliness": one.liking.likeliness,
            "specific_of": one.liking.specific_of,
        }
        for one in individuals
    ]
    return {"individuals": rows, "owl": owl}


class PersonView(APIView):
    """The PS-ABox of whoever the state belongs to."""

    @extend_schema(request=PersonRequestSerializer, responses=PersonSerializer)
    def post(self, request: Request) -> Response:
        """Return what was learned about a person as individuals; nothing is kept."""
        asked = msgspec.convert(request.data, PersonRequest)
        content, state = current(), read_state(asked.dialogue_state)
        person = person_of(content, asked, state)
        individuals = personal_individuals(likings_of(content, state), person)
        owl = ""
        if asked.format == "rdfxml":
            owl = person_owl(individuals, person, iri=settings.CAIR_ONTOLOGY_IRI)
        return Response(person_json(individuals, owl))
