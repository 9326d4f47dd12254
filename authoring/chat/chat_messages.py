"""What the page of the test chat and the server send each other."""

from collections.abc import Iterable
from typing import Annotated

import msgspec
from django.conf import settings
from django.utils.translation import gettext as _

from authoring.chat.chat_contents import DRAFT, Chosen
from authoring.chat.chat_pieces import Links, Piece
from authoring.chat.chat_why import reasons, type_name
from authoring.chat.conversation_turns import LONGEST_EXPECTED, Kind, said_in
from authoring.chat.replaying import MOST_TURNS, Exchange, Talk
from authoring.word_marks import word_marks
from dialogue.turns import MOST_SEED, write_state
from plans.engine.actions import ACTIONS, ACTIONS_BY_NAME
from plans.engine.manager import Action

Json = dict[str, object]
Short = Annotated[str, msgspec.Meta(max_length=100)]
Spoken = Annotated[str, msgspec.Meta(max_length=20_000)]
Able = Annotated[list[Short], msgspec.Meta(max_length=200)]


class TalkMessage(msgspec.Struct):
    """How a talk is had, and on which content (see chat_contents.content_of)."""

    content: Short = DRAFT
    language: Short = ""
    culture: Short = ""
    seed: Annotated[int, msgspec.Meta(ge=1, le=MOST_SEED)] = 1
    topic: Short = ""
    capabilities: Able | None = None

    def talk(self) -> Talk:
        """Return the talk."""
        able = None if self.capabilities is None else tuple(self.capabilities)
        return Talk(self.language, self.culture, self.seed, self.topic, able)


class TurnMessage(msgspec.Struct):
    """The next turn; without a state the talk begins."""

    talk: TalkMessage
    state: str = ""
    sentence: Spoken = ""


class HeardMessage(msgspec.Struct):
    """A turn that was had: what was heard, and the reply that was shown."""

    heard: Spoken = ""
    reply: Spoken = ""
    plan: Spoken = ""
    kind: Kind = "exact"
    value: Annotated[str, msgspec.Meta(max_length=LONGEST_EXPECTED)] = ""


Turns = Annotated[list[HeardMessage], msgspec.Meta(min_length=1, max_length=MOST_TURNS + 1)]


class ReplayMessage(msgspec.Struct):
    """A whole talk to be had again; the first turn is the opening."""

    talk: TalkMessage
    turns: Turns


class SaveMessage(ReplayMessage, kw_only=True):
    """A talk to be kept as a regression conversation."""

    title: Annotated[str, msgspec.Meta(max_length=1000)] = ""
    note: Annotated[str, msgspec.Meta(max_length=5000)] = ""


def sentence_of(text: str) -> str:
    """Return what was said, as long as robots may send it."""
    return text[: settings.CAIR_LONGEST_SENTENCE]


def turn_json(chosen: Chosen, turn: Exchange, shown: HeardMessage | None = None) -> Json:
    """Return a turn for the page; with what was shown before, what has changed since."""
    state, plan, said = turn.reply.state, turn.plan, said_in(turn)
    links = Links(chosen, state.language)
    reply = said.text(state.language)
    answer: Json = {
        "heard": turn.heard,
        "reply": reply,
        "plan_sentence": said.plan_sentence,
        "sentence": said.sentence,
        "plan": said.plan,
        "actions": [readable(action) for action in plan.plan_actions],
        "topic": _piece(links.topic(said.topic)),
        "topic_key": said.topic,
        "type": type_name(said.type),
        "learned": learned(links, turn),
        "state": write_state(state),
        "why": msgspec.to_builtins(reasons(chosen, turn)),
    }
    if shown is not None:
        answer["changed"] = (shown.reply, shown.plan) != (reply, said.plan)
        answer["marks"] = msgspec.to_builtins(word_marks(shown.reply, reply))
    return answer


def content_json(chosen: Chosen) -> Json:
    """Return which content answered: the draft at a version, or a release."""
    name = _("the draft") if chosen.name == DRAFT else _("release %s") % chosen.name
    return {"name": name, "version": f"{chosen.name} {chosen.version}"}


def readable(action: Action) -> Json:
    """Return an action in words: {"meaning": "Play a song.", "parameters": "title: Azzurro"}."""
    known = ACTIONS_BY_NAME.get(action.action)
    given = (f"{name}: {value}" for name, value in action.parameters.items() if value)
    meaning = _(known.meaning) if known else ""
    return {"action": action.action, "meaning": meaning, "parameters": ", ".join(given)}


def learned(links: Links, turn: Exchange) -> list[Json]:
    """Return what the robot knows of the person's likes, what changed in this turn first."""
    state, found = turn.reply.state, []
    for number in state.covered_topics():
        node, now = links.chosen.content.tree.node(number), state.likeliness(number)
        if node is not None and now is not None:
            known = turn.before.likeliness(number) if turn.before else None
            usual = round(node.likeliness.get(state.culture, 0.5), 3)
            before = usual if known is None else known
            found.append((links.topic(node.key), before, now, known != now))
    found.sort(key=lambda one: not one[3])
    return [
        {"topic": _piece(topic), "before": before, "now": now, "changed": changed}
        for topic, before, now, changed in found
    ]


def _piece(piece: Piece) -> Json:
    return {"text": piece.text, "url": piece.url}


def all_actions() -> Iterable[Json]:
    """Return what robots can do, for the form: name, meaning and whether every robot can."""
    return [{"name": one.name, "meaning": _(one.meaning), "common": one.common} for one in ACTIONS]
