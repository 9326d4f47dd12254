"""The time to find keywords in a sentence, against the number of topics."""

import argparse
import time
from collections.abc import Callable, Iterator
from functools import partial
from random import Random

from dialogue.engine.keywords import KeywordRow, build_index
from languages.known import LANGUAGES

SIZES = (300, 3_000, 30_000)
SYLLABLES = {
    "en": ("ba", "ce", "di", "fo", "gu", "la", "me", "ni", "po", "ru", "sta", "thre", "vel", "ton"),
    "it": ("ba", "ce", "di", "fo", "gu", "la", "me", "ni", "po", "ru", "sta", "tre", "vel", "to"),
    "ja": tuple("パンダ音楽茶緑花海山料理祭旅本歌ラーメみそ"),
}
COMMON = {
    "en": ("tea", "music", "film", "food", "flower", "travel", "family", "sport"),
    "it": ("tè", "musica", "film", "cibo", "fiore", "viaggio", "famiglia", "sport"),
    "ja": ("茶", "音楽", "映画", "料理", "花", "旅行", "家族", "スポーツ"),
}
SENTENCES = {
    "en": (
        "My grandmother used to make {0} every morning and she loved the music of {1}",
        "I would like to see a film about {2} with my family next week",
        "Yes, I do",
    ),
    "it": (
        "Mia nonna preparava {0} ogni mattina e le piaceva la musica di {1} con il caffè",
        "Vorrei vedere un film su {2} con la mia famiglia la settimana prossima",
        "Sì, certo",
    ),
    "ja": (
        "祖母は毎朝{0}を入れてくれて、{1}の音楽を聴くのが好きでした",
        "来週は家族と一緒に{2}の映画を見に行きたいです",
        "はい、そうです",
    ),
}


def rows(code: str, size: int, chance: Random) -> Iterator[KeywordRow]:
    """Yield topics: six of ten are special kinds of something common, four stand alone."""
    for topic in range(1, size + 1):
        word = "".join(chance.choices(SYLLABLES[code], k=4 + topic % 3))
        alone = chance.random() < 0.4
        yield KeywordRow(topic, (word,), ("*",) if alone else (chance.choice(COMMON[code]),))


def _words(code: str, seed: int) -> tuple[str, ...]:
    """Return a word that stands alone, a kind of music and a kind of film, known at each size."""
    second = {row.second[0]: row.first[0] for row in rows(code, SIZES[0], Random(seed))}
    return second["*"], second[COMMON[code][1]], second[COMMON[code][2]]


def quickest(works: dict[int, Callable[[], object]], rounds: int) -> dict[int, float]:
    """Return the CPU microseconds of each work at its quickest, all run in turn."""
    best = dict.fromkeys(works, 10**12)
    for _ in range(rounds):
        for size, work in works.items():
            begin = time.process_time_ns()
            work()
            best[size] = min(best[size], time.process_time_ns() - begin)
    return {size: nanoseconds / 1_000 for size, nanoseconds in best.items()}


def report(code: str, seed: int, rounds: int) -> None:
    """Print a row per sentence: its time at each number of topics, and their ratio."""
    indexes = {size: build_index(LANGUAGES[code], rows(code, size, Random(seed))) for size in SIZES}
    words = _words(code, seed)
    for template in SENTENCES[code]:
        sentence = template.format(*words)
        times = quickest(
            {size: partial(index.search, sentence) for size, index in indexes.items()}, rounds
        )
        matches = len(indexes[3_000].search(sentence))
        figures = " | ".join(f"{times[size]:.1f}" for size in SIZES)
        ratio = times[SIZES[-1]] / times[SIZES[0]]
        print(f"| {code} | {len(sentence)} | {matches} | {figures} | {ratio:.2f} |")


if __name__ == "__main__":
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--seed", type=int, default=1)
    arguments.add_argument("--rounds", type=int, default=1_000)
    chosen = arguments.parse_args()
    print("| language | characters | matches | 300 topics, µs | 3,000 | 30,000 | ratio |")
    print("| --- | ---: | ---: | ---: | ---: | ---: | ---: |")
    for language in SENTENCES:
        report(language, chosen.seed, chosen.rounds)
