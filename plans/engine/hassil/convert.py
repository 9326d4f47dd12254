"""From a file of hassil to a library of ours: intents with triggers, phrases and value lists."""

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field

from languages.language import Language
from plans.engine.hassil.data import Block, HassilFile, HassilList, HassilProblem, Template
from plans.engine.hassil.grammar import (
    Group,
    Items,
    ListUse,
    RuleUse,
    TemplateError,
    parse_template,
)
from plans.engine.hassil.names import has_lists, joined, key_of, note_of, phrase_text
from plans.engine.hassil.pieces import Words, without_rules, written_out
from plans.engine.hassil.shrink import TooLargeError, flattened, simplified, split, with_a_word
from plans.engine.intents import Intent, Library, Phrase, Slot, ValueList
from plans.engine.matchers.patterns_compiler import SKIP_END, SKIP_START
from plans.engine.patterns import (
    DEEPEST,
    LONGEST,
    Sequence,
    expansions,
    print_pattern,
)
from plans.engine.reading import units_of
from plans.engine.rules import MOST_EXPANSIONS, breaches

MOST_NESTED_RULES = 8
TEXT, NUMBER = "text", "number"


@dataclass(frozen=True, slots=True)
class Conversion:
    """A library, and what of the file is not in it.

    `meant` gives the slot of hassil that a slot of an intent stands for: (intent key, slot name).
    """

    library: Library
    problems: tuple[HassilProblem, ...]
    meant: Mapping[tuple[str, str], str]


def convert(
    file: HassilFile, language: Language, most_wordings: int = MOST_EXPANSIONS
) -> Conversion:
    """Return the intents of a file as a library of one language, in the order of the file.

    A template that cannot be said in our grammar is left out and told in `problems`. Contexts are
    not known here: a template that asks for one is kept without it, and the note says so. One with
    more than `most_wordings` becomes several triggers; a wording of slots alone is not kept.
    """
    return _Converter(file, language, most_wordings).convert()


@dataclass(slots=True)
class _Names:
    """The slots of one intent: each name has one kind."""

    slots: dict[str, Slot] = field(default_factory=dict)
    meant: dict[str, str] = field(default_factory=dict)

    def name(self, use: ListUse, kind: str) -> str:
        """Return the name of a slot; one whose kind differs is named for its list, too."""
        slot, listed = key_of(use.slot), key_of(use.name)
        for name in (slot, listed, f"{slot}_{listed}"):
            same_kind = self.slots.setdefault(name, Slot(name=name, kind=kind)).kind == kind
            if same_kind and self.meant.setdefault(name, use.slot) == use.slot:
                return name
        raise TemplateError(f"The slot {use.slot!r} has too many kinds", 0)


class _Converter:
    def __init__(self, file: HassilFile, language: Language, most_wordings: int) -> None:
        self.file = file
        self.language = language
        self.most_wordings = most_wordings
        self.problems: list[HassilProblem] = []
        self.values: dict[str, ValueList] = {}
        self.phrases: dict[str, Sequence] = {}
        self.groups: dict[Group, str] = {}
        self.meant: dict[tuple[str, str], str] = {}

    def convert(self) -> Conversion:
        for name, rule in self.file.rules.items():
            self._phrase(name, rule)
        intents = [
            self._intent(number, name, blocks)
            for number, (name, blocks) in enumerate(self.file.intents.items(), start=1)
        ]
        library = Library(
            intents=tuple(intents),
            values=tuple(self.values.values()),
            phrases=(*self._skip_words(), *self._used_phrases(intents)),
        )
        return Conversion(library, tuple(self.problems), self.meant)

    def _phrase(self, name: str, rule: Template) -> None:
        """Keep a rule as a phrase where it can be one: short enough, and without slots."""
        try:
            group = Group((self._items(rule, self.file.rules),), rule=name)
            if has_lists((group,)):
                return
            sequence = self._sequence(group.options[0], self._words({}), DEEPEST - 1)
        except (TemplateError, TooLargeError):
            return  # told where a template uses it
        small = expansions(sequence, {}) <= MOST_EXPANSIONS
        if sequence.parts and small and len(print_pattern(sequence)) <= LONGEST - 2:
            self.phrases[key_of(name)] = sequence
            self.groups[group] = key_of(name)

    def _words(self, phrases: dict[Group, str]) -> Words:
        return Words(self.language.spaced, lambda use: use.slot, phrases)

    def _sequence(self, items: Items, words: Words, deepest: int = DEEPEST) -> Sequence:
        simple = simplified(words.sequence(items), self._heard)
        return simplified(flattened(simple, deepest), self._heard)

    def _heard(self, text: str) -> bool:
        return bool(units_of(text, self.language))

    def _items(self, template: Template, rules: Mapping[str, Template], depth: int = 0) -> Items:
        def rule(use: RuleUse) -> Items:
            if use.name not in rules:
                raise TemplateError(f"There is no rule {use.name!r}", use.position)
            if depth >= MOST_NESTED_RULES:
                raise TemplateError(
                    f"Rules in rules more than {MOST_NESTED_RULES} deep", use.position
                )
            try:
                return self._items(rules[use.name], rules, depth + 1)
            except TemplateError as error:
                message = f"In the rule {use.name!r}: {error.message}"
                raise TemplateError(message, use.position) from error

        return without_rules(parse_template(template.text), rule)

    def _intent(self, number: int, name: str, blocks: tuple[Block, ...]) -> Intent:
        key, names = key_of(name), _Names()
        triggers: dict[str, None] = {}
        for block in blocks:
            for template in block.templates:
                triggers |= dict.fromkeys(self._triggers(name, block, template, names))
        self.meant |= {(key, slot): meant for slot, meant in names.meant.items()}
        return Intent(
            number=number,
            key=key,
            slots=tuple(names.slots.values()),
            triggers={self.language.code: tuple(triggers)} if triggers else {},
            plan_sentences={},
            note=note_of(name, blocks),
        )

    def _triggers(
        self, intent: str, block: Block, template: Template, names: _Names
    ) -> Iterator[str]:
        rules = {**self.file.rules, **block.rules}
        lists = {**self.file.lists, **block.lists}

        def slot_name(use: ListUse) -> str:
            return names.name(use, self._kind(intent, use.name, lists, block, rules))

        phrases = {} if block.rules else self.groups
        try:
            items = self._items(template, rules)
            words = Words(self.language.spaced, slot_name, phrases)
            whole = self._sequence(items, words)
            for sequence in split(whole, self.phrases, self.most_wordings):
                yield from self._kept(intent, template, sequence, names)
        except TemplateError as error:
            self._note_problem(intent, template, error.position, error.message)
        except TooLargeError as error:
            self._note_problem(intent, template, 0, str(error))

    def _kept(
        self, intent: str, template: Template, sequence: Sequence, names: _Names
    ) -> Iterator[str]:
        for one in with_a_word(sequence, self.phrases):
            found = list(breaches(one, names.slots, self.phrases))
            for breach in found:
                self._note_problem(intent, template, 0, breach.message)
            if not found:
                yield print_pattern(one)

    def _note_problem(self, where: str, template: Template, position: int, message: str) -> None:
        problem = HassilProblem(where, template, position, message)
        if problem not in self.problems:
            self.problems.append(problem)

    def _kind(
        self,
        intent: str,
        name: str,
        lists: Mapping[str, HassilList],
        block: Block,
        rules: Mapping[str, Template],
    ) -> str:
        """Return the kind of a slot; a list that is written nowhere is any words."""
        listed = lists.get(name)
        if listed is None or listed.wildcard:
            return TEXT
        if listed.number:
            return NUMBER
        key = key_of(f"{intent} {name}" if name in block.lists else name)
        if key not in self.values:
            self.values[key] = self._value_list(key, name, listed, rules)
        return f"value:{key}"

    def _value_list(
        self, key: str, name: str, listed: HassilList, rules: Mapping[str, Template]
    ) -> ValueList:
        known: set[tuple[str, ...]] = set()
        values: dict[str, tuple[str, ...]] = {}
        for value in listed.values:
            words = []
            for text in self._texts(f"{{{name}}}", value.said, rules):
                units = units_of(text, self.language)
                if units and units not in known:
                    known.add(units)
                    words.append(text)
            if words:
                values[value.meaning] = (*values.get(value.meaning, ()), *words)
        return ValueList(key=key, values={self.language.code: values})

    def _texts(self, where: str, said: Template, rules: Mapping[str, Template]) -> list[str]:
        """Return every way to say a value."""
        try:
            forms = written_out(self._items(said, rules))
        except TemplateError as error:
            self._note_problem(where, said, error.position, error.message)
            return []
        if any(isinstance(item, ListUse) for form in forms for item in form):
            self._note_problem(where, said, 0, "A list inside a list")
            return []
        return list(dict.fromkeys(map(joined, forms)))

    def _skip_words(self) -> Iterator[Phrase]:
        texts = [
            text
            for word in self.file.skip_words
            for text in self._texts("skip_words", word, self.file.rules)
            if self._heard(text)
        ]
        for key in (SKIP_START, SKIP_END) if texts else ():
            yield Phrase(key=key, texts={self.language.code: "|".join(dict.fromkeys(texts))})

    def _used_phrases(self, intents: Iterable[Intent]) -> Iterator[Phrase]:
        used = {
            name
            for intent in intents
            for trigger in intent.triggers.get(self.language.code, ())
            for name in re.findall(r"<([a-z0-9_]+)>", trigger)
        }
        for key, sequence in self.phrases.items():
            if key in used:
                yield Phrase(key=key, texts={self.language.code: phrase_text(sequence)})
