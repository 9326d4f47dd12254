"""A thousand intents of twenty triggers in three languages: load, memory, hits and misses.

python -m benchmarks.matching.synthetic prints the figures of a fresh process as JSON.
"""

import argparse
import json
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from random import Random

from hassil.intents import Intents
from hassil.recognize import recognize_best

from benchmarks.matching.measure import Spread, spread, table
from benchmarks.matching.targets import Figures
from languages.known import LANGUAGES
from plans.engine.catalogue import Catalogue, compile_catalogue
from plans.engine.intents import Intent, Library, Phrase, Slot
from plans.engine.patterns import parse_pattern, sample

TRIGGERS = 20
PAGE = 4096
_SYLLABLES = {
    "en": ("ba", "ce", "din", "fo", "gu", "lar", "me", "nish", "po", "ru", "sta", "thre", "vel"),
    "it": ("ba", "ce", "di", "fo", "gu", "la", "me", "ni", "po", "ru", "sta", "tre", "vel", "tà"),
    "ja": tuple("海山花茶歌本旅祭料理音楽映画電車駅町村川空星"),
}
_SHAPES = {
    "en": (
        "[please] {verb} [me] [the|a] {noun}",
        "(can|could) you {verb} the {noun} [now]",
        "{verb} {noun} [for] ($what)",
        "I want [you] to {verb} [my] {noun}",
    ),
    "it": (
        "[per favore] {verb} [mi] [il|la] {noun}",
        "(puoi|potresti) {verb} il {noun} [adesso]",
        "{verb} {noun} [per] ($what)",
        "vorrei che tu {verb} [il mio] {noun}",
    ),
    "ja": (
        "[すみません] {noun} を {verb} [ください]",
        "{noun} [を] {verb} て (くれる|もらえる)",
        "($what) の {noun} を {verb}",
        "[私の] {noun} を {verb} たい [です]",
    ),
}
_FREE = {"en": "blue eggs", "it": "uova blu", "ja": "青い卵"}
_SKIP = {"en": "please|well", "it": "per favore|allora", "ja": "あの|ねえ"}


class World:
    """Invented intents; a trigger is known by its verb and its noun, which many others share."""

    def __init__(self, intents: int, seed: int = 1) -> None:
        self.chance = Random(seed)
        self.nouns = {code: self._words(code, max(intents // 2, 40)) for code in LANGUAGES}
        self.verbs = {code: self._words(code, 60) for code in LANGUAGES}
        self.used: set[tuple[str, str, str]] = set()
        self.library = Library(
            intents=tuple(self._intent(number) for number in range(1, intents + 1)),
            phrases=(Phrase(key="skip_start", texts=_SKIP), Phrase(key="skip_end", texts=_SKIP)),
        )

    def _words(self, code: str, number: int) -> list[str]:
        words: dict[str, None] = {}
        while len(words) < number:
            syllables = self.chance.choices(_SYLLABLES[code], k=self.chance.randint(2, 3))
            words["".join(syllables)] = None
        return list(words)

    def _intent(self, number: int) -> Intent:
        return Intent(
            number=number,
            key=f"intent{number}",
            slots=(Slot(name="what"),),
            triggers={code: tuple(self._triggers(code)) for code in LANGUAGES},
            plan_sentences={},
        )

    def _triggers(self, code: str) -> Iterator[str]:
        for place in range(TRIGGERS):
            shape = _SHAPES[code][place % len(_SHAPES[code])]
            verb, noun = self._pair(code)
            text = shape.replace("{verb}", verb).replace("{noun}", noun)
            yield text.replace("($what)", "{what}")

    def _pair(self, code: str) -> tuple[str, str]:
        while True:
            verb = self.chance.choices(self.verbs[code])[0]
            noun = self.chance.choices(self.nouns[code])[0]
            if (code, verb, noun) not in self.used:
                self.used.add((code, verb, noun))
                return verb, noun

    def hits(self, code: str, number: int) -> list[str]:
        """Return sentences that fit."""
        gap = " " if LANGUAGES[code].spaced else ""
        found = []
        for intent in self.chance.choices(self.library.intents, k=number):
            trigger = self.chance.choices(intent.triggers[code])[0]
            words = sample(parse_pattern(trigger), self.chance, {}, lambda _: _FREE[code])
            found.append(gap.join(words))
        return found

    def misses(self, code: str, number: int) -> list[str]:
        """Return sentences of the same words in no order that fits."""
        gap = " " if LANGUAGES[code].spaced else "は"
        words = (*self.nouns[code], *self.verbs[code], *_SKIP[code].split("|"))
        return [gap.join(self.chance.choices(words, k=5 + turn % 4)) for turn in range(number)]


def _resident() -> int:
    return int(Path("/proc/self/statm").read_text().split()[1]) * PAGE


def figures_of(intents: int, sentences: int) -> Figures:
    """Return what one fresh process measures."""
    world = World(intents)
    before = _resident()
    begin = time.process_time()
    catalogue = compile_catalogue(world.library)
    found = {"load": time.process_time() - begin}
    for code in LANGUAGES:
        _language(world, catalogue, code, sentences, found)
    found["memory"] = (_resident() - before) / 1e6
    return found


def _language(
    world: World, catalogue: Catalogue, code: str, sentences: int, found: Figures
) -> None:
    hits, misses = world.hits(code, sentences), world.misses(code, sentences)
    found[f"first {code}"] = spread(lambda text: catalogue.match(text, code), hits, 1).p50
    matched = sum(catalogue.match(text, code) is not None for text in hits)
    found[f"matched {code}"] = 100 * matched / len(hits)
    misses = [text for text in misses if catalogue.match(text, code) is None]
    for name, chosen in (("hit", hits), ("miss", misses)):
        times = spread(lambda text: catalogue.match(text, code), chosen, 3)
        found[f"{name} p50 {code}"], found[f"{name} p95 {code}"] = times


def hassil_spread(world: World, code: str, sentences: int) -> Spread:
    """Return hassil's time on the same triggers, in one language."""
    gap = " " if LANGUAGES[code].spaced else ""
    data = {
        "language": code,
        "intents": {
            intent.key: {
                "data": [
                    {"sentences": [trigger.replace(" ", gap) for trigger in intent.triggers[code]]}
                ]
            }
            for intent in world.library.intents
        },
        "lists": {"what": {"wildcard": True}},
        "skip_words": _SKIP[code].split("|"),
    }
    intents = Intents.from_dict(data)
    hits = world.hits(code, sentences)
    recognize_best(hits[0], intents)  # parses the templates
    return spread(lambda text: recognize_best(text, intents), hits, 1)


def compare(figures: Figures, *, quick: bool) -> None:
    """Print the figures of a fresh process beside hassil's."""
    intents, sentences = (300, 100) if quick else (1_000, 500)
    command = [sys.executable, "-m", __name__, "--intents", str(intents)]
    done = subprocess.run(
        [*command, "--sentences", str(sentences)], check=True, capture_output=True, text=True
    )
    found: Figures = json.loads(done.stdout)
    world = World(intents)
    rows = []
    for code in LANGUAGES:
        theirs = hassil_spread(world, code, 10 if quick else 30)
        rows.append(
            (
                code,
                f"{found[f'matched {code}']:.1f} %",
                f"{found[f'first {code}']:,.0f}",
                Spread(found[f"hit p50 {code}"], found[f"hit p95 {code}"]),
                Spread(found[f"miss p50 {code}"], found[f"miss p95 {code}"]),
                theirs,
                f"{theirs.p50 / found[f'hit p50 {code}']:,.0f} ×",
            )
        )
        if not quick:
            figures[f"1,000 × 20 hit {code}"] = found[f"hit p50 {code}"]
            figures[f"1,000 × 20 miss {code}"] = found[f"miss p50 {code}"]
            figures[f"1,000 × 20 first hit {code}"] = found[f"first {code}"]
    if not quick:
        figures["1,000 × 20 load, three languages"] = found["load"]
        figures["1,000 × 20 memory, three languages"] = found["memory"]
    table(
        f"{intents:,} invented intents of {TRIGGERS} triggers, three languages loaded",
        f"A fresh process loads them in {found['load']:.1f} s of CPU time and holds "
        f"{found['memory']:.0f} MB more after all sentences. CPU µs, p50 / p95.",
        ("language", "hits matched", "first hit, p50", "hit", "miss", "hassil, hit", "ratio"),
        rows,
    )


if __name__ == "__main__":
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--intents", type=int, default=1_000)
    arguments.add_argument("--sentences", type=int, default=500)
    chosen = arguments.parse_args()
    print(json.dumps(figures_of(chosen.intents, chosen.sentences)))
