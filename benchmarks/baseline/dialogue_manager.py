"""The baseline's Dialogue Manager: Algorithm 1 of the paper over lists."""

import re
from random import Random
from typing import TypedDict

from benchmarks.baseline.data import Data, Topic
from benchmarks.baseline.state import State

YES = frozenset(("yes", "sure", "course", "please", "like", "love"))
NO = frozenset(("no", "not", "never", "don't"))
WORD = re.compile(r"[\w']+")
ACTION = re.compile(r"#action=(\w+)(?: topic=(.*?))?(?: value=([\d.]+))?(?: startsentence=(\w))?$")


class Reply(TypedDict):
    """What the Dialogue Manager answers."""

    dialogue_sentence: str
    dialogue_state: State


def reply(data: Data, state: State, sentence: str, kbplan: str, chance: Random) -> Reply:
    """Return what to say next; the state is changed in place."""
    words = WORD.findall(sentence.lower())
    _learn(data, state, words)
    jumped = _run(data, state, kbplan)
    if jumped is not None:
        return _enter(data, state, jumped[0], chance, jumped[1])
    matched = search(data, words)
    if matched:
        weights = [_likeliness(data, state, place) + 0.01 for place in matched]
        return _enter(data, state, chance.choices(matched, weights)[0], chance)
    if not state["pattern"]:
        return _enter(data, state, _next(data, state, chance), chance)
    return _say(data, state, chance)


def search(data: Data, words: list[str]) -> list[int]:
    """Return the topics two of whose keywords were said; `*` stands for any."""
    padded = f" {' '.join(words)} "
    if data.remembered is not None and padded in data.remembered:
        return data.remembered[padded]
    found = [
        place
        for place, topic in enumerate(data.topics)
        if all(_one_of(keywords, padded) for keywords in topic["keywords"])
    ]
    if data.remembered is not None:
        data.remembered[padded] = found
    return found


def _one_of(keywords: list[str], padded: str) -> bool:
    return any(word == "*" or f" {word} " in padded for word in keywords)


def _likeliness(data: Data, state: State, place: int) -> float:
    return state["likelinesses"].get(str(place), data.topics[place]["likeliness"])


def _learn(data: Data, state: State, words: list[str]) -> None:
    """Move the likeliness of the topic half way to what the person answered to a question."""
    if state["sentence_type"] != "q":
        return
    liked, here = _answer(words), state["topic"]
    before = _likeliness(data, state, here)
    state["likelinesses"][str(here)] = round((before + liked) / 2, 2)


def _answer(words: list[str]) -> float:
    if NO & set(words):
        return 0.0
    return 1.0 if YES & set(words) else 0.5


def _run(data: Data, state: State, kbplan: str) -> tuple[int, str] | None:
    """Carry a KBplan out; return the topic to jump to and the type to begin with, if any."""
    target = None
    for item in kbplan.split("#")[1:]:
        found = ACTION.match(f"#{item.strip()}")
        place = _named(data, found[2] or "") if found else None
        if found is None or place is None:
            continue
        if found[1] == "setlikeliness":
            state["likelinesses"][str(place)] = float(found[3] or 1)
        elif found[1] == "jump":
            target = (place, found[4] or "")
    return target


def _named(data: Data, name: str) -> int | None:
    for place, topic in enumerate(data.topics):
        if topic["name"].lower() == name.lower() or name.lower() in topic["keywords"][0]:
            return place
    return None


def _next(data: Data, state: State, chance: Random) -> int:
    """Return a child that was not talked about, else a topic close to the root."""
    open_ones = [place for place in data.topics[state["topic"]]["children"] if _open(state, place)]
    near = open_ones or [place for place in data.roots if _open(state, place)]
    near = near or [place for place in range(len(data.topics)) if _open(state, place)]
    near = near or list(range(len(data.topics)))
    weights = [_likeliness(data, state, place) + 0.01 for place in near]
    return chance.choices(near, weights)[0]


def _open(state: State, place: int) -> bool:
    return str(place) not in state["flags"]


def _enter(data: Data, state: State, place: int, chance: Random, begin: str = "") -> Reply:
    pattern = data.topics[place]["pattern"]
    state["topic"] = place
    state["pattern"] = begin + pattern.partition(begin)[2] if begin else pattern
    return _say(data, state, chance)


def _say(data: Data, state: State, chance: Random) -> Reply:
    topic = data.topics[state["topic"]]
    wanted, state["pattern"] = state["pattern"][0], state["pattern"][1:]
    if wanted == "p" and str(state["topic"]) in state["likelinesses"]:
        wanted = "p" if _likeliness(data, state, state["topic"]) >= 0.5 else "n"
    flags = state["flags"].setdefault(str(state["topic"]), [0] * len(topic["sentences"]))
    place = _sentence(topic, flags, wanted, chance)
    flags[place] = 1
    said = topic["sentences"][place]
    state["sentence_type"] = said["type"]
    return Reply(dialogue_sentence=said["text"], dialogue_state=state)


def _sentence(topic: Topic, flags: list[int], wanted: str, chance: Random) -> int:
    """Return a sentence of this type that was not said, else any of the type, else any."""
    places = [n for n, one in enumerate(topic["sentences"]) if one["type"] == wanted]
    fresh = [n for n in places if not flags[n]]
    return chance.choice(fresh or places or list(range(len(topic["sentences"]))))
