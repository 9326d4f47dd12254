"""The published topics over REST: what there is to talk about."""

from django.urls import reverse
from drf_spectacular.utils import OpenApiParameter, extend_schema
from rest_framework import serializers
from rest_framework.exceptions import NotFound
from rest_framework.request import Request
from rest_framework.response import Response
from rest_framework.viewsets import ViewSet

from dialogue.engine.concepts import Topic
from dialogue.engine.content import Content
from dialogue.engine.tree import Node
from dialogue.publishing import current
from plans.api import Json

PAGE = 50


class TopicsSerializer(serializers.Serializer):
    count = serializers.IntegerField()
    page = serializers.IntegerField()
    pages = serializers.IntegerField()
    results = serializers.ListField(child=serializers.DictField())


class TopicSerializer(serializers.Serializer):
    name = serializers.CharField()
    names = serializers.DictField(child=serializers.CharField())
    ancestors = serializers.ListField(child=serializers.CharField())
    children = serializers.ListField(child=serializers.CharField())
    links = serializers.ListField(child=serializers.CharField())
    keywords = serializers.DictField()
    likeliness = serializers.DictField(child=serializers.FloatField())
    sentences = serializers.DictField(child=serializers.IntegerField())


class TopicViewSet(ViewSet):
    """The published topics."""

    lookup_field = "name"
    lookup_value_regex = "[A-Za-z0-9]+"

    @extend_schema(
        parameters=[
            OpenApiParameter("search", str, description="Part of a name in any language."),
            OpenApiParameter("page", str, description="1 and up; without a number the first."),
        ],
        responses=TopicsSerializer,
    )
    def list(self, request: Request) -> Response:
        """Return the topics, fifty a page, of all or of those whose name holds a text."""
        nodes = _found(current(), request.query_params.get("search", "")[:100].casefold())
        pages = max(1, -(-len(nodes) // PAGE))
        page = min(max(1, _number(request.query_params.get("page", "1"))), pages)
        rows = [_short(node) for node in nodes[(page - 1) * PAGE : page * PAGE]]
        return Response({"count": len(nodes), "page": page, "pages": pages, "results": rows})

    @extend_schema(responses=TopicSerializer)
    def retrieve(self, request: Request, name: str = "") -> Response:
        """Return one topic."""
        content = current()
        node = content.tree.by_key.get(name)
        if node is None:
            raise NotFound(
                f"There is no topic {name!r}. List them with GET {reverse('topics-list')}."
            )
        topic = next(topic for topic in content.knowledge.topics if topic.key == name)
        return Response(_whole(content, node, topic))


def _number(text: str) -> int:
    return int(text) if text.isdecimal() and len(text) < 7 else 1


def _found(content: Content, search: str) -> list[Node]:
    nodes = list(content.tree.nodes.values())
    if not search:
        return nodes
    return [
        node
        for node in nodes
        if search in node.key.casefold()
        or any(search in forms.forms[""].casefold() for forms in node.names.values())
    ]


def _names(node: Node) -> dict[str, str]:
    return {code: forms.forms[""] for code, forms in node.names.items()}


def _short(node: Node) -> Json:
    return {"name": node.key, "names": _names(node)}


def _whole(content: Content, node: Node, topic: Topic) -> Json:
    nodes = content.tree.nodes
    return _short(node) | {
        "ancestors": [nodes[number].key for number in node.ancestors],
        "children": [nodes[number].key for number in node.children],
        "links": [nodes[number].key for number in node.links],
        "keywords": {
            code: [list(words) for words in sets] for code, sets in topic.keywords.items()
        },
        "likeliness": dict(node.likeliness),
        "sentences": {type_: len(lines) for type_, lines in node.lines.items()},
    }
