"""Pools: sentences that belong to no topic, one row a pool."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple


class Pool(NamedTuple):
    """One pool: its name, when the agent uses it, and the variables its sentences may hold."""

    name: str
    used_when: str
    variables: frozenset[str] = frozenset()
    asks: bool = False


_NAMES = frozenset({"toName"})
_BOTH = frozenset({"hasName", "toName"})
_WISH = frozenset({"what"})

_TABLE = (
    Pool("start", "the first sentence of a talk"),
    Pool("welcome_back", "the first sentence when the client brings an old state"),
    Pool("acknowledge", "after an open answer; presupposes nothing about it"),
    Pool("gentle", "the same while a hard subject is listened to"),
    Pool("neutral", "after an answer to a yes/no question that is neither yes nor no"),
    Pool("begin", "before the first topic of a talk", _NAMES),
    Pool("opener", "before a question about a topic the person has brought up", _NAMES),
    Pool("disliked", "before talking again about a topic of low likeliness", _NAMES),
    Pool("transition", "from one topic to a related one", _BOTH),
    Pool("change", "from one topic to an unrelated one", _NAMES),
    Pool("leave", "when the person asks not to talk about something", frozenset({"hasName"})),
    Pool("change_asked", "when the person asks to change the subject"),
    Pool("not_understood", "when the person asks something that nothing matches"),
    Pool("wish", "when the person wants to talk about something unknown", _WISH, asks=True),
    Pool("fond", "when the person loves something unknown", _WISH, asks=True),
    Pool("averse", "when the person dislikes something unknown", _WISH),
    Pool("opinion", "before the agent's opinion"),
    Pool("repeat", "before saying the last thing again"),
    Pool("nothing_to_repeat", "when there is nothing to say again"),
    Pool("goal_accepted", "when an offered activity is accepted"),
    Pool("goal_refused", "when an offered activity is refused"),
    Pool("forget", "when the person asks the agent to forget what it learned"),
    Pool("list", "before naming topics", frozenset({"list"})),
    Pool("initiative", "hands the initiative to the person (type e)", asks=True),
    Pool("stay_or_go", "after a hard subject: stay with it or go on", asks=True),
    Pool("end", "when the person wants to stop"),
    Pool("after_end", "when the person speaks again after having stopped"),
    Pool("urgent", "in place of chit-chat when help was asked for"),
    Pool("abilities", "before what the robot can do", frozenset({"list"}), asks=True),
    Pool("joke", "a joke that hurts nobody"),
    Pool("riddle", "a riddle with its answer"),
    Pool("proverb", "a proverb and what it means"),
    Pool("curiosity", "something true and surprising"),
    Pool("story", "a very short story"),
    Pool("poem", "a few lines of verse of our own"),
    Pool("prayer", "quiet words for any faith or none"),
    Pool("breathing", "a few calm breaths together"),
    Pool("apology", "spoken when a request could not be understood at all"),
)

POOLS: Mapping[str, Pool] = MappingProxyType({row.name: row for row in _TABLE})
