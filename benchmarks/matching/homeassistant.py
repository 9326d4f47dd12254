"""The templates of Home Assistant's package, given to hassil and to us alike.

They are read from the installed package at run time. What a template asks of the context (a kind
of device, the room the speaker is in) is taken out for both; names of devices are one list.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from hassil.intents import Intents
from hassil.recognize import RecognizeResult, recognize_all, recognize_best
from home_assistant_intents import get_intents

from benchmarks.matching.household import AREAS, FLOORS, NAMES
from languages.known import LANGUAGES
from plans.engine import rules
from plans.engine.catalogue import Catalogue, compile_catalogue
from plans.engine.hassil.convert import Conversion, convert
from plans.engine.hassil.data import Block, HassilFile, HassilList, ListValue, Template
from plans.engine.hassil.names import key_of

#: Home Assistant's templates stand for millions of wordings; an author's trigger for 10,000.
MOST_WORDINGS = 10**12


@dataclass(frozen=True)
class Answer:
    """An intent of Home Assistant and its slots, each as comparable text."""

    intent: str
    slots: Mapping[str, str]


class Templates:
    """The templates of one language, in both engines."""

    def __init__(self, code: str) -> None:
        self.code = code
        self.data = plain_data(code)
        self.intents: Intents = Intents.from_dict(self.data)
        rules.MOST_EXPANSIONS = MOST_WORDINGS
        self.conversion: Conversion = convert(file_of(self.data), LANGUAGES[code], MOST_WORDINGS)
        self.names = {key_of(name): name for name in self.intents.intents}

    @cached_property
    def catalogue(self) -> Catalogue:
        """Return our catalogue of them."""
        return compile_catalogue(self.conversion.library)

    @property
    def count(self) -> int:
        """Return the number of templates."""
        return sum(
            len(block["sentences"])
            for intent in self.data["intents"].values()
            for block in intent["data"]
        )

    def ours(self, sentence: str) -> Answer | None:
        """Return our answer."""
        match = self.catalogue.match(sentence, self.code)
        if match is None:
            return None
        key, meant = match.intent.key, self.conversion.meant
        slots = {meant[key, slot]: text for slot, text in match.parameters.items()}
        return Answer(self.names[key], self._comparable(slots))

    def theirs(self, sentence: str) -> Answer | None:
        """Return hassil's best answer, found as Home Assistant finds it."""
        result = recognize_best(sentence, self.intents, language=self.code, best_slot_name="name")
        return None if result is None else self._answer(result)

    def _answer(self, result: RecognizeResult) -> Answer:
        slots = {
            name: entity.text_clean if entity.is_wildcard else str(entity.value)
            for name, entity in result.entities.items()
        }
        return Answer(result.intent.name, self._comparable(slots))

    def readings(self, sentence: str) -> list[Answer]:
        """Return every way the sentence fits a template, by hassil."""
        found = recognize_all(sentence, self.intents, language=self.code)
        return [self._answer(result) for result in found]

    def comparable(self, answer: Answer) -> Answer:
        """Return an answer whose slots are written as those of the engines."""
        return Answer(answer.intent, self._comparable(answer.slots))

    def _comparable(self, slots: Mapping[str, str]) -> Mapping[str, str]:
        return {name: comparable(text, self.code) for name, text in slots.items()}


def comparable(text: str, code: str) -> str:
    """Return a value without sign, case, accents and punctuation: "-5" is "5" (a multiplier)."""
    language = LANGUAGES[code]
    bare = text.removeprefix("-").removesuffix(".0")
    return language.fold(" ".join(token.text for token in language.tokens(bare)))


def plain_data(code: str) -> dict[str, Any]:
    """Return the package's data with our household and without contexts."""
    data: dict[str, Any] = dict(get_intents(code) or {})
    household = {"name": NAMES, "area": AREAS, "floor": FLOORS}
    data["lists"] = {
        **data["lists"],
        **{name: {"values": list(values[code])} for name, values in household.items()},
    }
    kept = ("sentences", "expansion_rules", "lists")
    data["intents"] = {
        name: {"data": [{key: block[key] for key in kept if key in block} for block in one["data"]]}
        for name, one in data["intents"].items()
    }
    data.pop("responses", None)
    return data


def file_of(data: Mapping[str, Any]) -> HassilFile:
    """Return the data as our converter reads it."""
    return HassilFile(
        intents={
            name: tuple(
                Block(
                    templates=tuple(map(Template, block["sentences"])),
                    rules=_rules(block.get("expansion_rules", {})),
                    lists=_lists(block.get("lists", {})),
                )
                for block in intent["data"]
            )
            for name, intent in data["intents"].items()
        },
        rules=_rules(data.get("expansion_rules", {})),
        lists=_lists(data["lists"]),
        skip_words=tuple(map(Template, data.get("skip_words", ()))),
    )


def _rules(rules: Mapping[str, str]) -> Mapping[str, Template]:
    return {name: Template(text) for name, text in rules.items()}


def _lists(lists: Mapping[str, Any]) -> Mapping[str, HassilList]:
    return {name: _list(listed) for name, listed in lists.items()}


def _list(listed: Mapping[str, Any]) -> HassilList:
    values = [one if isinstance(one, dict) else {"in": one} for one in listed.get("values", ())]
    return HassilList(
        values=tuple(
            ListValue(Template(one["in"]), str(one.get("out", one["in"]))) for one in values
        ),
        number="range" in listed,
        wildcard=bool(listed.get("wildcard")),
    )
