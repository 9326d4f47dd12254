"""How often the agent acts on what nobody asked of it: unknown requests and ordinary talk."""

import importlib.util
from collections import Counter
from collections.abc import Iterator, Mapping
from random import Random

import msgspec

from benchmarks.matching.homeassistant import Templates
from benchmarks.matching.measure import percent, table
from benchmarks.matching.robust import stored
from benchmarks.matching.samples import Sample
from benchmarks.matching.targets import Figures
from languages.known import LANGUAGES
from plans.engine.catalogue import Catalogue, IntentMatch, compile_catalogue
from plans.engine.intents import Intent, Library
from plans.engine.matchers.matcher import Way
from tests.engine.plans.chat import CHAT

CHAT_SENTENCES = 1_000
FORGIVING = frozenset((Way.FILLERS, Way.SPELLING))
_BETWEEN = {"en": ". ", "it": ". ", "ja": "。"}


def without(library: Library, key: str) -> Catalogue:
    """Return the catalogue of a library that lacks one intent."""
    kept = tuple(intent for intent in library.intents if intent.key != key)
    return compile_catalogue(msgspec.structs.replace(library, intents=kept))


def twins(one: Intent, two: Intent) -> bool:
    """Say whether taking one for the other makes the client do nothing else.

    Either it does nothing for both, or the same actions, whatever their parameters.
    """
    return [action.action for action in one.plan] == [action.action for action in two.plan]


def leaving_one_out(library: Library, figures: Figures, *, show: int, every: int) -> None:
    """Print how often the stored tests of an intent that is missing are taken for another."""
    counts = {code: Counter[str]() for code in LANGUAGES}
    pairs: Counter[tuple[str, str, str]] = Counter()
    for intent in library.intents[::every]:
        catalogue = without(library, intent.key)
        alone = msgspec.structs.replace(library, intents=(intent,))
        for code in LANGUAGES:
            for test in stored(alone, code):
                match = catalogue.match(test.text, code)
                found = "" if match is None else match.intent.key
                counts[code].update(_left_out(catalogue, intent, match, code, test.text))
                if match is not None and not twins(intent, match.intent):
                    pairs[code, intent.key, found] += 1
                    if pairs.total() <= show:
                        print(f"- {code} {intent.key}: {test.text!r} taken for {found}")
    for (code, key, name), number in pairs.most_common(show):
        print(f"- {code} {key} taken for {name}: {number}")
    total = sum(count["all"] for count in counts.values())
    other = sum(count["acted"] - count["twin"] for count in counts.values())
    figures["false accepts"] = 100 * other / max(1, total)
    table(
        "Leaving one intent out: its own stored tests",
        "Each intent is taken out in turn; what its tests are then taken for is a false accept: "
        "by forgiving a filler or a misspelling, or because a trigger fits word for word. Of the "
        "same effect: the client does nothing for both intents, or the same actions; the target "
        "counts the others.",
        (
            "language",
            "sentences",
            "acted on",
            "share",
            "of the same effect",
            "others, share",
            "by forgiving",
            "asked about",
            "share",
        ),
        [_left_out_row(code, count) for code, count in counts.items()],
    )


def _left_out(
    catalogue: Catalogue, intent: Intent, match: IntentMatch | None, code: str, text: str
) -> Iterator[str]:
    """Yield what a sentence of a missing intent counts as."""
    yield "all"
    if match is None:
        if catalogue.suggest(text, code):
            yield "asked"
        return
    yield "acted"
    if match.way in FORGIVING:
        yield "forgiven"
    if twins(intent, match.intent):
        yield "twin"


def _left_out_row(code: str, count: Counter[str]) -> tuple[object, ...]:
    total, acted, twin = count["all"], count["acted"], count["twin"]
    return (
        code,
        total,
        acted,
        percent(acted, total),
        twin,
        percent(acted - twin, total),
        count["forgiven"],
        count["asked"],
        percent(count["asked"], total),
    )


def templates_left_out(templates: Templates, made: list[Sample], every: int) -> None:
    """Print the same for Home Assistant's intents, where no other template fits word for word."""
    code, library = templates.code, templates.conversion.library
    total = acted = asked = 0
    for intent in library.intents[::every]:
        catalogue = without(library, intent.key)
        name = templates.names[intent.key]
        for one in made:
            alone = one.answer.intent == name and not any(
                reading.intent != name for reading in templates.readings(one.text)
            )
            if alone:
                total += 1
                found = catalogue.match(one.text, code)
                acted += found is not None
                asked += found is None and bool(catalogue.suggest(one.text, code))
    table(
        f"Leaving one intent of Home Assistant out, {code}",
        "Sentences that no template of another intent fits word for word.",
        ("sentences", "acted on", "share", "asked about", "share"),
        [(total, acted, percent(acted, total), asked, percent(asked, total))],
    )


def chat_sentences(number: int, seed: int) -> dict[str, list[str]]:
    """Return so many sentences of ordinary talk, over all languages; two are joined to fill up."""
    chance, known = Random(seed), _talk()
    found = {code: list(dict.fromkeys(known[code])) for code in LANGUAGES}
    wanted = -(-number // len(LANGUAGES))
    for code, sentences in found.items():
        single = len(sentences)
        while len(sentences) < wanted:
            one, two = (sentences[chance.randrange(single)] for _ in range(2))
            joined = one.rstrip(".!?。") + _BETWEEN[code] + two
            if one != two and joined not in sentences:
                sentences.append(joined)
    return found


def _talk() -> Mapping[str, list[str]]:
    """Return the sentences of the tests: answers, and small talk where there is some."""
    if importlib.util.find_spec("tests.engine.plans.small_talk") is None:
        return CHAT
    from tests.engine.plans.small_talk import SMALL_TALK  # only where it exists

    return {code: [*CHAT[code], *SMALL_TALK[code]] for code in LANGUAGES}


def chat(catalogue: Catalogue, figures: Figures, *, seed: int, show: int) -> None:
    """Print how often ordinary talk is acted on or asked about."""
    rows, all_acted = [], 0
    for code, sentences in chat_sentences(CHAT_SENTENCES, seed).items():
        acted, asked, said = _heard(catalogue, code, sentences)
        all_acted += len(acted)
        total = len(sentences)
        rows.append((code, total, len(acted), len(said), len(asked), percent(len(asked), total)))
        for text in acted[:show]:
            print(f"- {code} acted on: {text!r}")
        for text in said[:show]:
            print(f"- {code} answered: {text!r}")
        for text in asked[:show]:
            print(f"- {code} asked about: {text!r}")
    figures["chat sentences acted on"] = all_acted
    table(
        "Ordinary talk",
        "What people answer to open questions; pairs of them where there are too few. Acted on: "
        "the client is told to do something. Answered: thanks, pains, likes and the like are heard "
        "in talk, and the agent only says something to them.",
        ("language", "sentences", "acted on", "answered", "asked about", "share"),
        rows,
    )


def _heard(
    catalogue: Catalogue, code: str, sentences: list[str]
) -> tuple[list[str], list[str], list[str]]:
    """Return what is acted on, what is asked about, and what is only answered."""
    acted, asked, said = [], [], []
    for text in sentences:
        match = catalogue.match(text, code)
        if match is None:
            found = catalogue.suggest(text, code)
            asked += [f"{text} ({found.intent.key})"] if found else []
        else:
            (acted if match.intent.plan else said).append(f"{text} ({match.intent.key})")
    return acted, asked, said
