"""Reading a sentence with a few errors in the literal words of a trigger, in linear time.

For each number of errors the set of reached positions is kept, as Wu and Manber do: one pass over
the sentence, whatever the trigger.
"""

from dataclasses import dataclass

from plans.engine.automaton import Automaton

EXTRA = -1


@dataclass(frozen=True, slots=True)
class Errors:
    """Which errors are let pass, `most` in all.

    A unit too much (`extra`), a unit in place of a literal one (`wrong`), a literal unit left out
    (`missing`), a whole slot left empty (`empty`).
    """

    most: int
    extra: bool = False
    wrong: bool = False
    missing: bool = False
    empty: bool = False


@dataclass(frozen=True, slots=True)
class Alignment:
    """How a sentence was read with errors.

    `path` holds the position that reads each unit, EXTRA where none does; `wrong` are places of
    the sentence read as another unit, `missing` the positions left out.
    """

    path: tuple[int, ...]
    wrong: tuple[int, ...]
    missing: tuple[int, ...]

    @property
    def extra(self) -> tuple[int, ...]:
        """Return the places of the units that are too much."""
        return tuple([place for place, position in enumerate(self.path) if position == EXTRA])


def align(
    machine: Automaton, words: tuple[str, ...], others: tuple[int, ...], errors: Errors
) -> Alignment | None:
    """Return the reading with the fewest errors, or None where `errors.most` do not suffice."""
    found = _levels(machine, words, others, errors)
    if found is None:
        return None
    levels, reads = found
    for used, mask in enumerate(levels[-1]):
        if mask & machine.accept:
            return _Trace(machine, reads, levels, errors).back(used)
    return None


def _levels(
    machine: Automaton, words: tuple[str, ...], others: tuple[int, ...], errors: Errors
) -> tuple[list[list[int]], list[int]] | None:
    """Return after each unit the positions reached with 0, 1, ... errors, and what read each unit.

    None as soon as nothing is reached any more, which for most triggers is soon.
    """
    ahead, kinds, read_by = machine.ahead, machine.kinds, machine.reads
    wrong = machine.literal if errors.wrong else 0
    staying = _staying(machine) if errors.extra else 0
    out = _left_out(machine, errors)
    more = range(1, errors.most + 1)
    current = [machine.start] + [0] * errors.most
    for used in more if out else ():
        current[used] = ahead[current[used - 1]] & out
    levels, reads = [current], []
    for word, other in zip(words, others, strict=True):
        read = read_by[kinds.get(word, other)]
        fewer = current[0]
        before = ahead[fewer]
        reached = before & read
        after, any_reached = [reached], reached
        for used in more:
            left_out = ahead[reached] & out if out else 0
            reached = fewer & staying | before & wrong | left_out
            fewer = current[used]
            before = ahead[fewer]
            reached |= before & read
            after.append(reached)
            any_reached |= reached
        if not any_reached:
            return None
        levels.append(after)
        reads.append(read)
        current = after
    return levels, reads


def _left_out(machine: Automaton, errors: Errors) -> int:
    return (machine.literal if errors.missing else 0) | (
        (machine.start - 1) & ~machine.literal if errors.empty else 0
    )


def _staying(machine: Automaton) -> int:
    """Return the positions an extra unit may follow: free text takes its own."""
    return (machine.start | (machine.start - 1)) & ~machine.free


class _Trace:
    """The way back from the end of the sentence to its start."""

    def __init__(
        self, machine: Automaton, reads: list[int], levels: list[list[int]], errors: Errors
    ) -> None:
        self.machine = machine
        self.reads = reads
        self.levels = levels
        self.wrongs = machine.literal if errors.wrong else 0
        self.staying = _staying(machine) if errors.extra else 0
        self.out = _left_out(machine, errors)
        self.path = [EXTRA] * len(reads)
        self.wrong: list[int] = []
        self.missing: list[int] = []

    def back(self, used: int) -> Alignment:
        """Return the reading that ends with `used` errors."""
        place = len(self.reads)
        position = self.machine.pick(self.levels[place][used] & self.machine.accept)
        start = self.machine.start.bit_length() - 1
        while position != start or place:
            place, used, position = self._step(place, used, position)
        return Alignment(tuple(self.path), tuple(self.wrong[::-1]), tuple(self.missing[::-1]))

    def _step(self, place: int, used: int, position: int) -> tuple[int, int, int]:
        before, bit = self.machine.before[position], 1 << position
        if (
            place
            and self.reads[place - 1] & bit
            and (came := self.levels[place - 1][used] & before)
        ):
            self.path[place - 1] = position
            return place - 1, used, self.machine.pick(came)
        if place:
            fewer = self.levels[place - 1][used - 1]
            if self.wrongs & bit and (came := fewer & before):
                self.path[place - 1] = position
                self.wrong.append(place - 1)
                return place - 1, used - 1, self.machine.pick(came)
            if self.staying & bit and fewer & bit:
                return place - 1, used - 1, position
        self.missing.append(position)
        return place, used - 1, self.machine.pick(self.levels[place][used - 1] & before)
