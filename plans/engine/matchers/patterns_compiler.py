"""From the triggers of a library to the pattern matcher of one language."""

from collections.abc import Iterable, Iterator
from functools import cache, partial

from languages.language import Language
from languages.spoken.known import SPOKEN
from plans.engine.intents import Intent, Library
from plans.engine.matchers.patterns_hearing import Knowledge
from plans.engine.matchers.patterns_index import TriggerIndex
from plans.engine.matchers.patterns_matcher import PatternMatcher
from plans.engine.matchers.patterns_near import NearTriggers
from plans.engine.patterns import (
    PatternError,
    PhraseUse,
    Sequence,
    Word,
    parse_options,
    parse_pattern,
    parts_of,
)
from plans.engine.problems import Problem
from plans.engine.reading import Edges, Fillers, units_of
from plans.engine.rules import Breach, breaches, phrase_breaches
from plans.engine.sayings import is_saying
from plans.engine.slots import SPACED_LIMITS, UNSPACED_LIMITS, SlotWords
from plans.engine.templates import Lexicon, Template
from plans.engine.vocabulary import Vocabulary
from plans.engine.wordings import wordings

Units = tuple[str, ...]

# Phrases with a meaning of their own for the engine.
SKIP_START = "skip_start"
SKIP_END = "skip_end"
SOUNDS = "hesitations"
FILLERS = "fillers"
TOPIC_EDGES = "topic_edges"
NOT_A_TOPIC = "not_a_topic"
NOT_IN_TOPIC = "not_in_topic"
SHORTEST_ASIDE = 2
SHORTEST_ASIDE_CHARACTERS = 4


def compile_patterns(
    library: Library, language: Language, problems: list[Problem]
) -> PatternMatcher:
    """Return the matcher of a language; what is wrong is left out and added to `problems`."""
    lexicon = _lexicon(library, language, problems)
    templates: list[Template] = []
    words = {*_phrase_words(lexicon), *_spoken_words(library, lexicon)}
    for intent in library.intents:
        for trigger in intent.triggers.get(language.code, ()):
            template = _template(intent, trigger, language.code, lexicon, problems)
            if template is not None:
                templates.append(template)
                words.update(_literals(template.sequence, lexicon))
    fillers = _listed(FILLERS, lexicon)
    aside = SHORTEST_ASIDE if language.spaced else SHORTEST_ASIDE_CHARACTERS
    index = TriggerIndex(templates)
    knowledge = Knowledge(
        spaced=language.spaced,
        index=index,
        near=None if language.spaced else NearTriggers(index, partial(_runs, lexicon)),
        vocabulary=Vocabulary(language, words),
        edges=Edges(_listed(SKIP_START, lexicon), _listed(SKIP_END, lexicon)),
        sounds=Fillers(_listed(SOUNDS, lexicon)),
        fillers=Fillers(fillers),
        asides=Fillers(filler for filler in fillers if len(filler) >= aside),
        slot_words=_slot_words(lexicon, language),
    )
    return PatternMatcher(language, knowledge)


def _template(
    intent: Intent, trigger: str, language: str, lexicon: Lexicon, problems: list[Problem]
) -> Template | None:
    """Return a trigger that keeps all rules; else None, with its problems noted."""
    try:
        sequence = parse_pattern(trigger)
    except PatternError as error:
        problems.append(Problem(intent.key, language, trigger, error.position, error.message))
        return None
    slots = {slot.name: slot for slot in intent.slots}
    found = list(breaches(sequence, slots, lexicon.phrases))
    template = None if found else Template(intent, trigger, sequence, lexicon)
    if template is not None and not template.clauses:
        found.append(Breach("A wording of signs only, without a word"))
    problems += _noted(found, intent.key, language, trigger)
    return None if found else template


def _noted(found: Iterable[Breach], where: str, language: str, text: str) -> list[Problem]:
    return [
        Problem(where, language, text, max(text.find(breach.near), 0), breach.message)
        for breach in found
    ]


def _lexicon(library: Library, language: Language, problems: list[Problem]) -> Lexicon:
    units = cache(partial(units_of, language=language))
    values = {
        listed.key: {
            units(synonym): canonical
            for canonical, synonyms in listed.values.get(language.code, {}).items()
            for synonym in synonyms
        }
        for listed in library.values
    }
    return Lexicon(
        spaced=language.spaced,
        units=units,
        phrases=dict(_phrases(library, language.code, problems)),
        values=values,
        spoken=SPOKEN[language.code],
    )


def _phrases(
    library: Library, language: str, problems: list[Problem]
) -> Iterator[tuple[str, Sequence]]:
    for phrase in library.phrases:
        text, where = phrase.texts.get(language, ""), f"<{phrase.key}>"
        if not text or is_saying(phrase.key):
            continue
        try:
            sequence = parse_options(text)
        except PatternError as error:
            problems.append(Problem(where, language, text, error.position, error.message))
            continue
        found = tuple(phrase_breaches(sequence))
        problems += _noted(found, where, language, text)
        if not found:
            yield phrase.key, sequence


def _phrase_words(lexicon: Lexicon) -> Iterator[str]:
    """Yield every word of phrases and value lists."""
    for sequence in lexicon.phrases.values():
        yield from _literals(sequence, lexicon)
    for listed in lexicon.values.values():
        for units in listed:
            yield from units


def _spoken_words(library: Library, lexicon: Lexicon) -> Iterator[str]:
    """Yield the words of the spoken kinds in use; the shortest are never spelt wrong."""
    used = {slot.kind for intent in library.intents for slot in intent.slots}
    for kind in used & lexicon.spoken.kinds.keys():
        yield from filter(lambda word: len(word) > 2, lexicon.spoken.kinds[kind].words)


def _literals(sequence: Sequence, lexicon: Lexicon) -> Iterator[str]:
    for part in parts_of(sequence):
        if isinstance(part, Word):
            yield from lexicon.units(part.text)


def _runs(lexicon: Lexicon, template: Template) -> Iterator[str]:
    """Yield the literal runs of a trigger and of its phrases."""
    sequences = [template.sequence]
    for sequence in sequences:
        for part in parts_of(sequence):
            if isinstance(part, Word):
                yield "".join(lexicon.units(part.text))
            elif isinstance(part, PhraseUse):
                sequences.append(lexicon.phrases[part.name])


def _listed(key: str, lexicon: Lexicon) -> frozenset[Units]:
    sequence = lexicon.phrases.get(key)
    return wordings(sequence, lexicon.units) - {()} if sequence else frozenset()


def _slot_words(lexicon: Lexicon, language: Language) -> SlotWords:
    return SlotWords(
        limits=SPACED_LIMITS if lexicon.spaced else UNSPACED_LIMITS,
        values=lexicon.values,
        spoken=lexicon.spoken,
        attitude=language.attitude,
        topic_edges=_listed(TOPIC_EDGES, lexicon),
        not_a_topic=_listed(NOT_A_TOPIC, lexicon),
        not_in_topic=_listed(NOT_IN_TOPIC, lexicon),
    )
