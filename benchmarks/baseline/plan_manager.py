"""The baseline's Plan Manager: the sentence against every trigger of every intent, in turn."""

from random import Random
from typing import TypedDict

from benchmarks.baseline.data import Data


class Plan(TypedDict):
    """What the Plan Manager answers; all empty where nothing matches."""

    intent: str
    plan_sentence: str
    plan: str
    kbplan: str


def find_plan(data: Data, sentence: str, chance: Random) -> Plan:
    """Return the plan of the first intent one of whose triggers the sentence is."""
    heard = sentence.lower().strip(" .,!?")
    for intent, triggers in data.intents:
        for trigger in triggers:
            match = trigger.fullmatch(heard)
            if match:
                said = chance.choice(intent["sentences"] or [""])
                found = [said, intent["plan"], intent["kbplan"]]
                for name, value in match.groupdict().items():
                    found = [text.replace(f"${name}", value or "None") for text in found]
                return Plan(
                    intent=intent["name"], plan_sentence=found[0], plan=found[1], kbplan=found[2]
                )
    return Plan(intent="", plan_sentence="", plan="", kbplan="")
