"""The memory of a process and all it has started, as Linux counts it."""

from dataclasses import dataclass
from pathlib import Path

PROC = Path("/proc")


@dataclass(frozen=True, slots=True)
class Memory:
    """Bytes: `pss` counts shared pages by shares, `uss` what would be freed if it ended.

    `rss` counts all it has, shared or not: a page that is copied because a worker writes to it does
    not change it, a leak does.
    """

    pss: int
    uss: int
    rss: int


def memory_of(process: int, proc: Path = PROC) -> Memory | None:
    """Return the memory of one process, None where it is gone or may not be looked at."""
    try:
        text = (proc / str(process) / "smaps_rollup").read_text(encoding="ascii")
    except OSError:
        return None
    sizes = {
        name: int(rest.split()[0]) * 1024
        for name, _colon, rest in (line.partition(":") for line in text.splitlines())
        if rest.endswith(" kB")
    }
    return Memory(
        pss=sizes.get("Pss", 0),
        uss=sizes.get("Private_Clean", 0) + sizes.get("Private_Dirty", 0),
        rss=sizes.get("Rss", 0),
    )


def family(process: int, proc: Path = PROC) -> list[int]:
    """Return a process and its children and theirs, in the order of their numbers."""
    found = [process]
    for one in found:
        for task in (proc / str(one) / "task").glob("*/children"):
            try:
                found += [int(child) for child in task.read_text(encoding="ascii").split()]
            except OSError:
                continue
    return [process, *sorted(found[1:])]
