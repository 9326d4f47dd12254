"""The Dialogue Manager: what to say next (paper, Algorithm 1)."""

from dataclasses import dataclass

from msgspec.structs import replace

from dialogue.engine.actions.table import ACTIONS
from dialogue.engine.answers import learn, reaction
from dialogue.engine.asking import ask, suggest, take_answer
from dialogue.engine.chance import chance_for
from dialogue.engine.content import Content
from dialogue.engine.find_topic import topic_of_sentence
from dialogue.engine.flow import begin, carry_on
from dialogue.engine.offers import answer_offer
from dialogue.engine.people import is_about_people
from dialogue.engine.pools import POOLS
from dialogue.engine.saying import say_from_pool, say_of_type
from dialogue.engine.sentence_types import REACTION, SENTENCE_TYPES
from dialogue.engine.state import DialogueState
from dialogue.engine.tree import Node
from dialogue.engine.turn import Heard, Step, Turn
from dialogue.engine.wishes import listen
from languages.language import Attitude
from plans.engine.manager import PlanAnswer

INITIATIVE = "e"
OPEN_TYPES = frozenset({"w", INITIATIVE, ""})
WORDS_WORTH_A_NOD = 3
DISLIKED = 0.2
HEARD_OUT = 5  # sentences about a hard subject, before a word in passing leads to another one


@dataclass(frozen=True, slots=True)
class Reply:
    """What the agent says and the state the client keeps for the next turn.

    `plan` is there where an offered activity was accepted.
    """

    state: DialogueState
    sentence: str
    sentence_type: str
    topic: str
    plan: PlanAnswer | None = None
    steps: tuple[Step, ...] = ()


def start(content: Content, language: str, culture: str, seed: int = 0) -> Reply:
    """Return the initial state and the first sentence of a talk."""
    state = DialogueState(language, culture, seed=seed)
    turn = Turn(content, state, Heard(""), chance_for(seed, 0))
    say_from_pool(turn, "start")
    return _finish(turn)


def reply(content: Content, state: DialogueState, heard: Heard) -> Reply:
    """Return the answer to one client sentence."""
    # A question waits for one turn only, whatever is said in it.
    waiting, state = state.pending, replace(state, turn=state.turn + 1, pending=None)
    turn = Turn(content, state, heard, chance_for(state.seed, state.turn), waiting=waiting)
    _talk(turn)
    return _finish(turn)


def _talk(turn: Turn) -> None:
    """Try each way to answer in turn; the first that has said something ends the turn."""
    for way in WAYS:
        if way(turn):
            return
    carry_on(turn)


def _help(turn: Turn) -> bool:
    """Somebody asked for help: no chit-chat in this turn."""
    if not turn.heard.urgent:
        return False
    turn.note("urgent", "Help was asked for: stay with the person from now on.")
    said = say_from_pool(turn, "urgent")
    listen(turn)
    return said


def _kbplan(turn: Turn) -> bool:
    """Lines 2-20: what the plan does to likeliness and to the flow of the talk."""
    for action in turn.heard.kbplan_actions:
        act = ACTIONS.get(action.action)
        if act is None:
            turn.note("kbplan", f"No action {action.action!r} is known.")
        elif act(turn, action.parameters):
            turn.change(ended=action.action == "stop", offer=0)
            return True
    return False


def _welcome(turn: Turn) -> bool:
    """Greet a client that came back with its old state and said nothing yet."""
    if turn.heard.sentence.strip():
        return False
    turn.note("welcome", "An empty sentence with a state: the person is back.")
    turn.change(ended=False, offer=0)
    fresh = turn.state.turn == 1 and not turn.state.topic
    return say_from_pool(turn, "start" if fresh else "welcome_back")


def _resume(turn: Turn) -> bool:
    """Speaking again after a goodbye opens the talk again."""
    if turn.state.ended:
        turn.change(ended=False, offer=0)
        say_from_pool(turn, "after_end")
    return False


def _offer(turn: Turn) -> bool:
    """Answer what was said to a proposal: a yes gets its plan, a no a friendly word."""
    offered, turn.state = turn.state.offer, replace(turn.state, offer=0)
    line = turn.content.tree.lines.get(offered)
    if line and line.proposal and not turn.heard.plan_matched:
        answer_offer(turn, line.proposal, turn.language.attitude(turn.heard.sentence))
    return False


def _answer_and_keywords(turn: Turn) -> bool:
    """Take the answer to a q, then go to a topic the person mentioned (lines 21-27)."""
    node, heard = turn.node, turn.heard
    if heard.plan_matched:
        turn.change(ordering=turn.state.ordering.replace(REACTION, ""))
        return False
    mentioned = None if turn.plan else _mentioned(turn)
    answered = _answer(turn, node) if node and turn.state.last_type == "q" else False
    if mentioned is None:
        if not answered and not turn.parts and turn.plan is None:
            _acknowledge(turn)
        return False
    asked = not answered and turn.language.asks(heard.sentence)
    turn.change(siblings=0, noes=0, misses=turn.state.misses + 1 if asked else 0)
    if asked and is_about_people(turn, mentioned):
        # "Where is my husband?": no stock line about husbands.
        say_from_pool(turn, "not_understood")
        listen(turn, "wc")
        carry_on(turn)
        return True
    if not mentioned.gentle:
        _nod(turn, mentioned, answered=answered, asked=asked)
    begin(turn, mentioned)
    return True


def _answer(turn: Turn, node: Node) -> bool:
    """Learn from the answer and prepare the reaction; False where it was neither yes nor no."""
    attitude = turn.language.attitude(turn.heard.sentence)
    learn(turn, node, attitude)
    letter = reaction(attitude)
    rest = turn.state.ordering.replace(REACTION, "")
    if letter == "p":
        turn.change(ordering=letter + rest, noes=0)
    elif letter == "n":
        turn.change(ordering=letter, noes=turn.state.noes + 1)
    else:
        turn.change(ordering=rest)
        return attitude is Attitude.DEPENDS and say_from_pool(turn, "neutral")
    return True


def _mentioned(turn: Turn) -> Node | None:
    """Return a topic the sentence is about, unless it is the one we are talking about."""
    found = topic_of_sentence(turn, turn.heard.sentence)
    current = turn.node
    if found is None or current is None:
        return found
    if turn.content.tree.is_same_or_below(current.number, found.number):
        turn.note("stay", f"{found.key} is what we are talking about.")
        return None
    if current.gentle and not found.gentle and _is_being_heard(turn, current):
        turn.note("stay", f"{found.key} can wait: the person is being listened to.")
        turn.change(ordering=turn.state.ordering or "wc")
        return None
    return found


def _is_being_heard(turn: Turn, node: Node) -> bool:
    """Say whether a hard subject is not told yet: a word in passing must not end it.

    Who was asked what comes next names it.
    """
    said = turn.state.used_slots(node.number).bit_count()
    asked = turn.state.last_type == INITIATIVE
    return bool(turn.state.ordering) or (said < HEARD_OUT and not asked)


def _nod(turn: Turn, mentioned: Node, *, answered: bool, asked: bool) -> None:
    """React before going over to what the person mentioned."""
    node = turn.node
    if asked:
        say_from_pool(turn, "not_understood")
    elif answered and node and turn.state.ordering[:1] in ("p", "n"):
        say_of_type(turn, node, turn.state.ordering[0])
    elif turn.state.last_type in OPEN_TYPES and turn.state.turn > 1:
        _say_heard(turn)
    learned = turn.state.likeliness(mentioned.number)
    pool = "opener" if learned is None or learned > DISLIKED else "disliked"
    say_from_pool(turn, pool, {"toName": mentioned.names[turn.state.language]})


def _acknowledge(turn: Turn) -> None:
    """Show that the answer was heard, without presupposing what was said."""
    sentence = turn.heard.sentence
    if turn.language.asks(sentence):
        turn.change(misses=turn.state.misses + 1)
        say_from_pool(turn, "not_understood")
        if turn.node and is_about_people(turn, turn.node):
            listen(turn, "wc")  # No stock line about husbands after "Where is he?".
        return
    turn.change(misses=0)
    long_enough = len(turn.language.tokens(sentence)) >= WORDS_WORTH_A_NOD
    if turn.state.last_type in OPEN_TYPES or long_enough:
        _say_heard(turn)


def _say_heard(turn: Turn) -> None:
    """Say that the answer was heard, in the tone of the subject."""
    node = turn.node
    say_from_pool(turn, "gentle" if node and node.gentle else "acknowledge")


def _finish(turn: Turn) -> Reply:
    """Put the parts together and write down what the next turn must know."""
    line = turn.last_line
    type_ = _type(turn)
    asks = line is not None and type_ in SENTENCE_TYPES and SENTENCE_TYPES[type_].asks
    turn.change(
        last_type=type_,
        questions=turn.state.questions + 1 if asks else 0,
        offer=line.number if line and line.proposal else 0,
    )
    separator = " " if turn.language.spaced else ""
    node = turn.node
    return Reply(
        state=turn.state,
        sentence=separator.join(filter(None, turn.parts)),
        sentence_type=type_,
        topic=node.key if node else "",
        plan=turn.plan,
        steps=tuple(turn.steps),
    )


def _type(turn: Turn) -> str:
    """Return the letter of the last sentence; a pool line that asks hands the initiative over."""
    line = turn.last_line
    if line is None:
        return turn.state.last_type
    if line.owner:
        return line.type
    asks = line.type in POOLS and POOLS[line.type].asks
    return INITIATIVE if asks or line.type in ("start", "welcome_back") else "c"


#: The order of Algorithm 1: help first, then questions of ours, the KBplan, answers, keywords.
WAYS = (
    _help,
    ask,
    take_answer,
    _kbplan,
    _welcome,
    _resume,
    _offer,
    suggest,
    _answer_and_keywords,
)
