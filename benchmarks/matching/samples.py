"""Sentences made from the templates themselves, each with the intent and the slots it must give.

The package holds no tests, so every template is sampled by chance, through hassil's own parser;
one number in five is in words.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from random import Random

from hassil.expression import (
    Alternative,
    Expression,
    Group,
    ListReference,
    Permutation,
    RuleReference,
    Sentence,
    TextChunk,
)
from hassil.intents import IntentData, Intents, RangeSlotList, SlotList, TextSlotList
from hassil.numbers import get_rbnf_engine

from benchmarks.matching.homeassistant import Answer, Templates
from benchmarks.matching.household import FREE_TEXT

_TRIES = 20


@dataclass(frozen=True)
class Sample:
    """A sentence, what it must give, and the words of its slots as they were put in."""

    text: str
    answer: Answer
    said: tuple[str, ...]


class _Drawing:
    """One sentence in the making."""

    def __init__(self, code: str, intents: Intents, block: IntentData, chance: Random) -> None:
        self.code = code
        self.lists: dict[str, SlotList] = {**intents.slot_lists, **block.slot_lists}
        self.rules: dict[str, Sentence] = {**intents.expansion_rules, **block.expansion_rules}
        self.chance = chance
        self.slots: dict[str, str] = {}
        self.said: list[str] = []

    def draw(self, expression: Expression) -> str:
        if isinstance(expression, TextChunk):
            return expression.original_text
        if isinstance(expression, RuleReference):
            return self.draw(self.rules[expression.rule_name].expression)
        if isinstance(expression, ListReference):
            return self._value(expression)
        assert isinstance(expression, Group)
        if isinstance(expression, Alternative):
            return self.draw(self._one(expression.items))
        items = list(expression.items)
        if isinstance(expression, Permutation):
            self.chance.shuffle(items)
        return "".join(map(self.draw, items))

    def _one(self, items: list[Expression]) -> Expression:
        return items[self.chance.randrange(len(items))]

    def _value(self, use: ListReference) -> str:
        listed = self.lists[use.list_name]
        if isinstance(listed, TextSlotList):
            value = listed.values[self.chance.randrange(len(listed.values))]
            words = " ".join(self.draw(value.text_in).split())
            self.slots[use.slot_name] = str(value.value_out)
        elif isinstance(listed, RangeSlotList):
            words = self._number(use, listed)
        else:
            texts = FREE_TEXT[self.code]
            words = self.slots[use.slot_name] = texts[self.chance.randrange(len(texts))]
        self.said.append(words)
        return words

    def _number(self, use: ListReference, listed: RangeSlotList) -> str:
        number = self.chance.randrange(listed.start, listed.stop + 1, listed.step)
        self.slots[use.slot_name] = str(number)
        if listed.words and self.chance.random() < 0.2:
            return str(get_rbnf_engine(self.code).format_number(number).text)
        return str(number)


def samples(templates: Templates, each: int, seed: int) -> Iterator[Sample]:
    """Yield sentences of every template, none twice."""
    chance, known = Random(seed), set[str]()
    for name, intent in templates.intents.intents.items():
        for block in intent.data:
            for sentence in block.sentences:
                made = 0
                for _ in range(_TRIES):
                    sample = _sample(templates, name, block, sentence, chance)
                    if sample.text and sample.text not in known:
                        known.add(sample.text)
                        made += 1
                        yield sample
                    if made == each:
                        break


def _sample(
    templates: Templates, name: str, block: IntentData, sentence: Sentence, chance: Random
) -> Sample:
    drawing = _Drawing(templates.code, templates.intents, block, chance)
    text = " ".join(drawing.draw(sentence.expression).split())
    answer = templates.comparable(Answer(name, drawing.slots))
    return Sample(text, answer, tuple(drawing.said))
