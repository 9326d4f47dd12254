"""The Dialogue Manager over REST: what to say next, why, and what a state holds."""

from typing import Annotated

import msgspec
from django.conf import settings
from drf_spectacular.utils import extend_schema
from rest_framework import serializers
from rest_framework.decorators import action
from rest_framework.request import Request
from rest_framework.response import Response

from dialogue.engine.content import Content
from dialogue.engine.manager import Reply, reply
from dialogue.engine.state import DialogueState
from dialogue.engine.turn import Step
from dialogue.publishing import current
from dialogue.turns import (
    MOST_SEED,
    TurnAnswer,
    first_turn,
    heard_with,
    read_state,
    take_turn,
    write_state,
)
from plans.api import ActionSerializer, Json, QuestionSerializer, actions_json
from plans.engine.manager import Action, PlanAnswer, Question
from plans.timed_views import TimedViewSet
from plans.timing import DIALOGUE, lap

EMPTY = PlanAnswer()
LONGEST_QUESTION = 400  # characters


class TurnRequest(msgspec.Struct):
    """What a client sends for one turn; a turn without a state starts a talk."""

    client_sentence: str = ""
    dialogue_state: str = ""
    language: str = ""
    culture: str = ""
    seed: Annotated[int, msgspec.Meta(ge=0, le=MOST_SEED)] = 0
    capabilities: list[str] | None = None


class ActionMessage(msgspec.Struct):
    """An action as clients write it."""

    action: str
    parameters: dict[str, str | None] = {}


class QuestionMessage(msgspec.Struct):
    """A question of the Plan Manager, as it gave it."""

    intent: str
    slot: str
    text: str
    parameters: dict[str, str] = {}


class DialogueRequest(TurnRequest):
    """A turn for the Dialogue Manager alone: the KBplan comes from the caller."""

    kbplan_actions: list[ActionMessage] = []
    intent: str = ""
    plan_sentence: str = ""
    question: QuestionMessage | None = None


class TurnSerializer(serializers.Serializer):
    client_sentence = serializers.CharField(
        required=False,
        allow_blank=True,
        help_text="I love music; heard up to CAIR_LONGEST_SENTENCE characters.",
    )
    dialogue_state = serializers.CharField(
        required=False, help_text="As the last answer gave it; without it a talk starts."
    )
    language = serializers.CharField(
        required=False, help_text="en, it or ja: of a talk that starts with this turn."
    )
    culture = serializers.CharField(
        required=False, help_text="EN: of a talk that starts with this turn."
    )
    seed = serializers.IntegerField(
        min_value=0, max_value=MOST_SEED, required=False, help_text="The same gives the same talk."
    )
    capabilities = serializers.ListField(
        child=serializers.CharField(),
        required=False,
        allow_null=True,
        help_text="The actions this client can do; without it all are offered.",
    )


class KbActionSerializer(ActionSerializer):
    parameters = serializers.DictField(
        child=serializers.CharField(allow_null=True),
        required=False,
        help_text="None where it has none.",
    )


class AskedSerializer(QuestionSerializer):
    parameters = serializers.DictField(child=serializers.CharField(), required=False)


class DialogueSerializer(TurnSerializer):
    kbplan_actions = KbActionSerializer(many=True, required=False)
    intent = serializers.CharField(
        required=False, help_text="What the Plan Manager understood, if anything."
    )
    plan_sentence = serializers.CharField(
        required=False,
        allow_blank=True,
        help_text="What the Plan Manager says first: it is not said again.",
    )
    question = AskedSerializer(
        required=False, allow_null=True, help_text="What the Plan Manager wants to be asked."
    )


class ReplySerializer(serializers.Serializer):
    dialogue_state = serializers.CharField(help_text="Keep it and send it with the next turn.")
    dialogue_sentence = serializers.CharField(allow_blank=True)
    plan_sentence = serializers.CharField(allow_blank=True)
    plan = serializers.CharField(allow_blank=True)
    plan_actions = ActionSerializer(many=True)
    topic = serializers.CharField(allow_blank=True)
    sentence_type = serializers.CharField(allow_blank=True)


class StepSerializer(serializers.Serializer):
    rule = serializers.CharField()
    text = serializers.CharField()
    candidates = serializers.ListField(child=serializers.DictField(), required=False)


class ExplainedSerializer(ReplySerializer):
    steps = StepSerializer(many=True)


class InspectRequestSerializer(serializers.Serializer):
    dialogue_state = serializers.CharField()


def reply_json(said: Reply, plan: PlanAnswer) -> Json:
    """Return a turn's answer; every text is there, "" where there is nothing to say or do."""
    return {
        "dialogue_state": write_state(said.state),
        "dialogue_sentence": said.sentence,
        "plan_sentence": plan.plan_sentence,
        "plan": plan.plan,
        "plan_actions": actions_json(plan.plan_actions),
        "topic": said.topic,
        "sentence_type": said.sentence_type,
    }


def steps_json(steps: tuple[Step, ...]) -> list[Json]:
    """Return the steps of an explanation."""
    return [
        {
            "rule": step.rule,
            "text": step.text,
            "candidates": [
                {"topic": one.topic, "likeliness": one.likeliness} for one in step.candidates
            ],
        }
        for step in steps
    ]


def state_for(content: Content, asked: TurnRequest) -> DialogueState:
    """Return the state of a request; a new one where it brings none."""
    if asked.dialogue_state:
        return read_state(asked.dialogue_state)
    return first_turn(content, asked.language, asked.culture, asked.seed).state


def sentence_of(asked: TurnRequest) -> str:
    """Return what was said, as long as it may be."""
    return asked.client_sentence[: settings.CAIR_LONGEST_SENTENCE]


def answer_dialogue(content: Content, asked: DialogueRequest, state: DialogueState) -> Json:
    """Return the answer of the Dialogue Manager alone."""
    actions = tuple(Action(one.action, one.parameters) for one in asked.kbplan_actions)
    understood = PlanAnswer(
        intent=asked.intent,
        plan_sentence=asked.plan_sentence,
        kbplan_actions=actions,
        question=_question(asked.question),
    )
    heard = heard_with(content, sentence_of(asked), understood, asked.capabilities)
    with lap(DIALOGUE):
        said = reply(content, state, heard)
    return reply_json(said, said.plan or EMPTY)


def _question(asked: QuestionMessage | None) -> Question | None:
    if asked is None:
        return None
    return Question(asked.intent, asked.slot, asked.parameters, asked.text[:LONGEST_QUESTION])


class DialogueViewSet(TimedViewSet):
    """The Dialogue Manager: what the agent says next."""

    @extend_schema(request=DialogueSerializer, responses=ReplySerializer)
    def create(self, request: Request) -> Response:
        """Return the dialogue sentence for a client sentence and a KBplan."""
        asked = msgspec.convert(request.data, DialogueRequest)
        content = current()
        return Response(answer_dialogue(content, asked, state_for(content, asked)))

    @extend_schema(request=TurnSerializer, responses=ExplainedSerializer)
    @action(detail=False, methods=["post"])
    def explain(self, request: Request) -> Response:
        """Return the answer of a turn with the steps that led to it."""
        asked = msgspec.convert(request.data, TurnRequest)
        content = current()
        taken = take_turn(
            content,
            state_for(content, asked),
            sentence_of(asked),
            capabilities=asked.capabilities,
            explain=True,
        )
        return Response(reply_json(taken.reply, taken.plan) | {"steps": explained(taken)})

    @extend_schema(request=InspectRequestSerializer, responses={200: dict})
    @action(detail=False, methods=["post"])
    def inspect(self, request: Request) -> Response:
        """Return what a dialogue state holds, in readable words."""
        asked = msgspec.convert(request.data, TurnRequest)
        return Response(inspected(current(), read_state(asked.dialogue_state)))


def explained(taken: TurnAnswer) -> list[Json]:
    """Return the steps of both managers."""
    plan = tuple(Step("plan", text) for text in taken.understood.steps)
    return steps_json(plan + taken.reply.steps)


def inspected(content: Content, state: DialogueState) -> Json:
    """Return a state's fields; topics by name, those gone from the content left out."""
    nodes = content.tree.nodes
    covered = [nodes[number] for number in state.covered_topics() if number in nodes]
    here = nodes.get(state.topic)
    return {
        "language": state.language,
        "culture": state.culture,
        "turn": state.turn,
        "seed": state.seed,
        "topic": here.key if here else "",
        "sentence_type": state.last_type,
        "pattern": state.ordering,
        "likeliness": {
            node.key: value
            for node in covered
            if (value := state.likeliness(node.number)) is not None
        },
        "used_sentences": {
            node.key: [
                line.key
                for lines in node.lines.values()
                for line in lines
                if line.slot >= 0 and state.has_used(node.number, line.slot)
            ]
            for node in covered
        },
        "recent_topics": [nodes[number].key for number in state.topics if number in nodes],
        "avoided": [nodes[number].key for number, _ in state.avoided if number in nodes],
        "offer": _offer(content, state),
        "ended": state.ended,
    }


def _offer(content: Content, state: DialogueState) -> str:
    line = content.tree.lines.get(state.offer)
    return line.proposal.intent if line and line.proposal else ""
