"""How often the agent acts on what nobody asked of it: unknown requests and ordinary talk."""

import importlib.util
from collections.abc import Mapping
from random import Random

import msgspec

from benchmarks.matching.homeassistant import Templates
from benchmarks.matching.measure import percent, table
from benchmarks.matching.robust import stored
from benchmarks.matching.samples import Sample
from benchmarks.matching.targets import Figures
from languages.known import LANGUAGES
from plans.engine.catalogue import Catalogue, compile_catalogue
from plans.engine.intents import Library
from plans.engine.matchers.matcher import Way
from tests.engine.plans.chat import CHAT

CHAT_SENTENCES = 1_000
FORGIVING = frozenset((Way.FILLERS, Way.SPELLING))
_BETWEEN = {"en": ". ", "it": ". ", "ja": "。"}
#: Acted on by saying something kind, which is what ordinary talk asks for.
COURTESY = frozenset(("thanks",))


def without(library: Library, key: str) -> Catalogue:
    """Return the catalogue of a library that lacks one intent."""
    kept = tuple(intent for intent in library.intents if intent.key != key)
    return compile_catalogue(msgspec.structs.replace(library, intents=kept))


def leaving_one_out(library: Library, figures: Figures, *, show: int, every: int) -> None:
    """Print how often the stored tests of an intent that is missing are taken for another."""
    acted, forgiven = dict.fromkeys(LANGUAGES, 0), dict.fromkeys(LANGUAGES, 0)
    asked, total = dict.fromkeys(LANGUAGES, 0), dict.fromkeys(LANGUAGES, 0)
    tests = {code: stored(library, code) for code in LANGUAGES}
    for intent in library.intents[::every]:
        catalogue = without(library, intent.key)
        for code in LANGUAGES:
            for test in tests[code]:
                if test.intent != intent.key:
                    continue
                total[code] += 1
                match = catalogue.match(test.text, code)
                acted[code] += match is not None
                forgiven[code] += match is not None and match.way in FORGIVING
                asked[code] += match is None and bool(catalogue.suggest(test.text, code))
                if match is not None and sum(acted.values()) <= show:
                    print(f"- {code} {intent.key}: {test.text!r} taken for {match.intent.key}")
    rows = [
        (
            code,
            total[code],
            acted[code],
            percent(acted[code], total[code]),
            forgiven[code],
            asked[code],
            percent(asked[code], total[code]),
        )
        for code in LANGUAGES
    ]
    figures["false accepts"] = 100 * sum(acted.values()) / max(1, sum(total.values()))
    table(
        "Leaving one intent out: its own stored tests",
        "Each intent is taken out in turn; what its tests are then taken for is a false accept: "
        "by forgiving a filler or a misspelling, or because a trigger fits word for word.",
        ("language", "sentences", "acted on", "share", "by forgiving", "asked about", "share"),
        rows,
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
        acted, asked, kind = _heard(catalogue, code, sentences)
        all_acted += len(acted)
        total = len(sentences)
        rows.append((code, total, len(acted), kind, len(asked), percent(len(asked), total)))
        for text in acted[:show]:
            print(f"- {code} acted on: {text!r}")
        for text in asked[:show]:
            print(f"- {code} asked about: {text!r}")
    figures["chat sentences acted on"] = all_acted
    table(
        "Ordinary talk",
        "What people answer to open questions; pairs of them where there are too few.",
        ("language", "sentences", "acted on", "thanked", "asked about", "share"),
        rows,
    )


def _heard(
    catalogue: Catalogue, code: str, sentences: list[str]
) -> tuple[list[str], list[str], int]:
    """Return what is acted on, what is asked about, and how often a courtesy is returned."""
    acted, asked, kind = [], [], 0
    for text in sentences:
        match = catalogue.match(text, code)
        if match is None:
            asked += [text] if catalogue.suggest(text, code) else []
        elif match.intent.key in COURTESY:
            kind += 1
        else:
            acted.append(f"{text} ({match.intent.key})")
    return acted, asked, kind
