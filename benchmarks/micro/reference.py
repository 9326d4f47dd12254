"""A fixed piece of work: interpreter, zlib and JSON, as a turn uses them.

Machines differ, and one machine swings; both change this work and ours alike. Never change it:
every recorded ratio would mean something else.
"""

import json
import time
import zlib
from collections.abc import Callable
from random import Random

_CHANCE = Random(1)
_COLUMN = bytes(_CHANCE.choices(range(12), (20, 1, 2, 1, 1, 1, 2, 1, 1, 1, 5, 5), k=4_000))
_MESSAGE = {f"field{number}": _CHANCE.randbytes(24).hex() for number in range(40)}
_WORDS = " ".join(_CHANCE.choices(("tea", "music", "film", "flower", "sister"), k=120))
_ROUNDS = 6
_WINDOW, _MEMORY = 9, 2


def reference() -> int:
    """Do the work, about a millisecond; return what every machine must get: 33,540."""
    total = 0
    for _ in range(_ROUNDS):
        counts: dict[str, int] = {}
        for place, word in enumerate(_WORDS.split()):
            counts[word] = counts.get(word, 0) + place % 7
        total += sum(counts.values())
        total += _there_and_back(_COLUMN)
        total += len(json.loads(json.dumps(_MESSAGE)))
        total += sum([number * number % 11 for number in range(300)])
    return total


def _there_and_back(data: bytes) -> int:
    """Deflate and inflate in little memory; return the length.

    The usual 256 KB are given back to the system and asked for again, or not, as the heap happens
    to lie: a third of the whole work.
    """
    packer = zlib.compressobj(9, zlib.DEFLATED, -_WINDOW, _MEMORY)
    packed = packer.compress(data) + packer.flush()
    return len(zlib.decompressobj(-_WINDOW).decompress(packed))


def cpu_micros(work: Callable[[], object]) -> float:
    """Return the microseconds of CPU time that one call takes."""
    begin = time.process_time_ns()
    work()
    return (time.process_time_ns() - begin) / 1_000
