"""The benchmarks of one process, by name."""

import json
import zlib
from collections.abc import Callable, Sequence
from functools import partial
from random import Random

from benchmarks.micro.measure import Work, repeated
from benchmarks.micro.world import COVERED, KEYS, SENTENCES, World
from dialogue.engine.codec import decode, encode
from dialogue.engine.content import build_content
from dialogue.engine.manager import reply
from dialogue.engine.turn import Heard
from dialogue.garbage import collected_later
from dialogue.snapshot import checksum, pack, unpack
from ontology_io.records import KnowledgeBase
from plans.engine.manager import answer
from tests.engine.plans.chat import CHAT

HUB, OLD = "/api/v1/hub/", "/CAIR_hub"
SMALLEST, LARGEST = COVERED[0], COVERED[-1]
MOST = 30
ECHO_LARGEST, ECHO_SMALLEST = "echo view, largest body", "echo view, smallest body"
Make = Callable[[World], Work]


def _each(call: Callable[[str], object], sentences: Sequence[str], rounds: int = 100) -> Work:
    def run() -> None:
        for sentence in sentences:
            call(sentence)

    return Work(run, len(sentences), rounds)


def _encode(covered: int, world: World) -> Work:
    state = world.states[covered]
    return repeated(lambda: encode(state, KEYS))


def _decode(covered: int, world: World) -> Work:
    text = encode(world.states[covered], KEYS)
    return repeated(lambda: decode(text, KEYS))


def _plan(world: World, language: str, sentences: Sequence[str]) -> Work:
    catalogue, chance = world.content.catalogue, Random(1)
    return _each(lambda said: answer(catalogue, said, language, chance=chance), sentences)


def asked(world: World, language: str) -> list[str]:
    """Return requests that are understood: the stored tests, spread over all intents."""
    catalogue = world.content.catalogue
    stored = [
        test.sentence
        for intent in world.content.library.intents
        for test in intent.tests.get(language, ())
        if test.parameters is not None and catalogue.match(test.sentence, language)
    ]
    return stored[:: -(-len(stored) // MOST)]


def nearly(world: World) -> list[str]:
    """Return requests of which a word is missing: not understood, but asked about."""
    catalogue, found = world.content.catalogue, dict[str, None]()
    for sentence in asked(world, "en"):
        words = sentence.split()
        for place in range(len(words)):
            said = " ".join(words[:place] + words[place + 1 :])
            if not catalogue.match(said, "en") and catalogue.suggest(said, "en"):
                found[said] = None
    return list(found)[:MOST]


def _keywords(language: str, world: World) -> Work:
    return _each(world.content.keywords[language].search, CHAT[language][:MOST])


def _dialogue(covered: int, world: World) -> Work:
    content, state = world.content, world.states[covered]
    return _each(lambda said: reply(content, state, Heard(said)), SENTENCES)


def _posts(world: World, path: str, bodies: Sequence[bytes]) -> Work:
    from benchmarks.micro.site import call

    application = world.application
    for body in bodies:
        answered = call(application, path, body)
        assert answered.status == "200 OK", answered

    def run() -> None:
        for body in bodies:
            call(application, path, body)

    return Work(run, len(bodies), 100)


def bodies(state: object) -> list[bytes]:
    """Return the body of each sentence, with this state."""
    return [
        json.dumps({"client_sentence": said, "dialogue_state": state}).encode()
        for said in SENTENCES
    ]


def _turn(covered: int, world: World) -> Work:
    from benchmarks.micro.echo import PATH

    sent = bodies(encode(world.states[covered], KEYS))
    work = _posts(world, HUB, sent)
    name = ECHO_LARGEST if covered else ECHO_SMALLEST
    return Work(work.run, work.calls, work.rounds, {name: _posts(world, PATH, sent)})


def _old_turn(world: World) -> Work:
    state = {"state": encode(world.states[LARGEST], KEYS), "v": 1, "conversation_history": []}
    return _posts(world, OLD, [zlib.compress(body) for body in bodies(state)])


@collected_later()
def _built(base: KnowledgeBase) -> object:
    return build_content(base.knowledge, base.library)


def _build(world: World) -> Work:
    return Work(partial(_built, world.shipped), rounds=4)


@collected_later()
def _loaded(data: bytes, expected: str) -> object:
    snapshot = unpack(data, expected)
    return build_content(snapshot.knowledge, snapshot.library)


def _load(world: World) -> Work:
    data = pack(world.snapshot)
    return Work(partial(_loaded, data, checksum(data)), rounds=4)


WORKS: dict[str, Make] = {
    **{f"state, write, {covered:,} topics": partial(_encode, covered) for covered in COVERED},
    **{f"state, read, {covered:,} topics": partial(_decode, covered) for covered in COVERED},
    "plan match, hit": lambda world: _plan(world, "en", asked(world, "en")),
    "plan match, miss": lambda world: _plan(world, "en", CHAT["en"][:MOST]),
    "plan match, near miss": lambda world: _plan(world, "en", nearly(world)),
    "plan match, hit, Japanese": lambda world: _plan(world, "ja", asked(world, "ja")),
    "plan match, miss, Japanese": lambda world: _plan(world, "ja", CHAT["ja"][:MOST]),
    "keywords, English": partial(_keywords, "en"),
    "keywords, Japanese": partial(_keywords, "ja"),
    "Dialogue Manager, smallest state": partial(_dialogue, SMALLEST),
    "Dialogue Manager, largest state": partial(_dialogue, LARGEST),
    "turn, smallest state": partial(_turn, SMALLEST),
    "turn, largest state": partial(_turn, LARGEST),
    "turn of old clients, largest state": _old_turn,
    "build the shipped content": _build,
    "load a publication of 2,780 topics": _load,
}
