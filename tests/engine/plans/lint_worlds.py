"""Libraries with faults for the tests of the checks: two intents and what they say."""

from plans.engine.catalogue import Catalogue, compile_catalogue
from plans.engine.intents import (
    Intent,
    IntentTest,
    Library,
    PlanSentence,
    Slot,
    ValueList,
)
from plans.engine.plan_text import parse_plan


def intent(key: str, *triggers: str, **fields: object) -> Intent:
    """Return an English intent; a trigger may use {title}, a free text, and {level}, a list."""
    values: dict[str, object] = {
        "slots": (Slot(name="title"), Slot(name="level", kind="value:level")),
        "plan_sentences": {"en": (PlanSentence(text="Well."),)},
    }
    return Intent(number=sum(map(ord, key)), key=key, triggers={"en": triggers}, **values | fields)


def stored(*lines: str) -> dict[str, tuple[IntentTest, ...]]:
    """Return stored tests: `play Volare -> title=Volare`, `stop -> no`."""
    return {"en": tuple(map(_one, lines))}


def _one(line: str) -> IntentTest:
    sentence, _, expected = line.partition(" -> ")
    if expected == "no":
        return IntentTest(sentence=sentence)
    pairs = (pair.partition("=") for pair in expected.split(" | ") if pair)
    return IntentTest(sentence=sentence, parameters={name: text for name, _, text in pairs})


def world(*intents: Intent, levels: dict[str, tuple[str, ...]] | None = None) -> Library:
    """Return a library of these intents, with one value list."""
    words = levels or {"louder": ("louder", "up"), "quieter": ("down",)}
    return Library(intents=intents, values=(ValueList(key="level", values={"en": words}),))


def compiled(library: Library) -> Catalogue:
    """Return the catalogue of a library."""
    return compile_catalogue(library)


PLAY = intent(
    "play",
    "play {title}",
    "play some music",
    plan=parse_plan("#action=playsong title={title}"),
    tests=stored("play Volare -> title=Volare", "play some music", "stop -> no"),
)
