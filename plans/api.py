"""The Plan Manager over REST: it says whether the person asked for something."""

from typing import Annotated

import msgspec
from django.conf import settings
from drf_spectacular.utils import extend_schema
from rest_framework import serializers
from rest_framework.request import Request
from rest_framework.response import Response
from rest_framework.viewsets import ViewSet

from languages.known import LANGUAGES
from plans.choices import language_code
from plans.engine.actions import ACTIONS
from plans.engine.chance import chance_for
from plans.engine.intents import Intent
from plans.engine.kb_actions import KB_ACTIONS
from plans.engine.manager import Action, PlanAnswer, Question, answer
from plans.engine.plan_text import print_plan
from plans.serving import current
from plans.timed_views import TimedViewSet
from plans.timing import MATCH, lap

Json = dict[str, object]
MOST_SEED = 2**32 - 1
Number = Annotated[int, msgspec.Meta(ge=0, le=MOST_SEED)]


class PlanRequest(msgspec.Struct, forbid_unknown_fields=False):
    """A sentence to understand."""

    client_sentence: str = ""
    language: str = ""
    culture: str = ""
    capabilities: list[str] | None = None
    seed: Number = 0
    turn: Number = 0


class PlanRequestSerializer(serializers.Serializer):
    client_sentence = serializers.CharField(
        required=False, help_text="Play Hey Brother; heard up to CAIR_LONGEST_SENTENCE characters."
    )
    language = serializers.CharField(required=False, help_text=", ".join(LANGUAGES))
    culture = serializers.CharField(required=False, help_text="EN")
    capabilities = serializers.ListField(
        child=serializers.CharField(),
        required=False,
        allow_null=True,
        help_text="Actions it can do.",
    )
    seed = serializers.IntegerField(
        min_value=0,
        max_value=MOST_SEED,
        required=False,
        help_text="The same gives the same plan sentence in the same turn; 0 or none: any.",
    )
    turn = serializers.IntegerField(
        min_value=0, max_value=MOST_SEED, required=False, help_text="Which turn of the talk it is."
    )


class ActionSerializer(serializers.Serializer):
    action = serializers.CharField(help_text="playsong")
    parameters = serializers.DictField(child=serializers.CharField(allow_null=True))


class QuestionSerializer(serializers.Serializer):
    intent = serializers.CharField(help_text="playsong")
    slot = serializers.CharField(
        allow_blank=True, help_text='The parameter that is missing; "" where a yes is enough.'
    )
    parameters = serializers.DictField(child=serializers.CharField())
    text = serializers.CharField(help_text="Which song?")


class PlanAnswerSerializer(serializers.Serializer):
    intent = serializers.CharField(allow_blank=True)
    parameters = serializers.DictField(child=serializers.CharField())
    plan_sentence = serializers.CharField(allow_blank=True)
    plan = serializers.CharField(allow_blank=True, help_text="#action=playsong title=Hey Brother")
    plan_actions = ActionSerializer(many=True)
    kbplan = serializers.CharField(allow_blank=True)
    kbplan_actions = ActionSerializer(many=True)
    question = QuestionSerializer(
        allow_null=True,
        help_text="To be asked before the plan is carried out; give it to the Dialogue Manager.",
    )


def actions_json(actions: tuple[Action, ...]) -> list[Json]:
    """Return the actions as clients read them; a parameter nobody gave is null."""
    return [{"action": one.action, "parameters": dict(one.parameters)} for one in actions]


def plan_json(plan: PlanAnswer) -> Json:
    """Return the whole answer of the Plan Manager."""
    return {
        "intent": plan.intent,
        "parameters": dict(plan.parameters),
        "plan_sentence": plan.plan_sentence,
        "plan": plan.plan,
        "plan_actions": actions_json(plan.plan_actions),
        "kbplan": plan.kbplan,
        "kbplan_actions": actions_json(plan.kbplan_actions),
        "question": _question_json(plan.question),
    }


def _question_json(question: Question | None) -> Json | None:
    if question is None:
        return None
    return {
        "intent": question.intent,
        "slot": question.slot,
        "parameters": dict(question.parameters),
        "text": question.text,
    }


class PlanViewSet(TimedViewSet):
    """The Plan Manager: a sentence in; a plan, a KBplan and a plan sentence out."""

    @extend_schema(request=PlanRequestSerializer, responses=PlanAnswerSerializer)
    def create(self, request: Request) -> Response:
        """Return the plan a sentence asks for; everything is empty when nothing matches."""
        asked = msgspec.convert(request.data, PlanRequest)
        with lap(MATCH):
            plan = answer(
                current(),
                asked.client_sentence[: settings.CAIR_LONGEST_SENTENCE],
                language_code(asked.language or settings.CAIR_LANGUAGE),
                culture=asked.culture.strip().upper(),
                chance=chance_for(asked.seed, asked.turn),
                capabilities=asked.capabilities,
            )
        return Response(plan_json(plan))


class IntentSerializer(serializers.Serializer):
    name = serializers.CharField()
    priority = serializers.IntegerField()
    parameters = serializers.ListField(child=serializers.DictField())
    triggers = serializers.DictField(child=serializers.ListField(child=serializers.CharField()))
    plan = serializers.CharField(allow_blank=True)
    kbplan = serializers.CharField(allow_blank=True)
    note = serializers.CharField(allow_blank=True)


class IntentViewSet(ViewSet):
    """The published intents: what people can ask for, and the plans that brings."""

    @extend_schema(responses=IntentSerializer(many=True))
    def list(self, request: Request) -> Response:
        """Return every published intent."""
        return Response([_intent_json(intent) for intent in current().intents.values()])


def _intent_json(intent: Intent) -> Json:
    return {
        "name": intent.key,
        "priority": intent.priority,
        "parameters": [
            {"name": slot.name, "kind": slot.kind, "required": slot.required}
            for slot in intent.slots
        ],
        "triggers": {code: list(texts) for code, texts in intent.triggers.items()},
        "plan": print_plan(intent.plan),
        "kbplan": print_plan(intent.kbplan),
        "note": intent.note,
    }


class KnownActionSerializer(serializers.Serializer):
    name = serializers.CharField()
    parameters = serializers.ListField(child=serializers.CharField())
    meaning = serializers.CharField()
    kb = serializers.BooleanField(help_text="True: acts on the talk, not on the robot.")


class ActionViewSet(ViewSet):
    """The actions a plan may hold, with their parameters."""

    @extend_schema(responses=KnownActionSerializer(many=True))
    def list(self, request: Request) -> Response:
        """Return the actions of clients and those of KBplans."""
        robot: list[Json] = [
            {
                "name": action.name,
                "parameters": [parameter.name for parameter in action.parameters],
                "meaning": action.meaning,
                "kb": False,
            }
            for action in ACTIONS
        ]
        knowledge: list[Json] = [
            {
                "name": kb_action.name,
                "parameters": list(kb_action.parameters),
                "meaning": kb_action.meaning,
                "kb": True,
            }
            for kb_action in KB_ACTIONS
        ]
        return Response(robot + knowledge)
