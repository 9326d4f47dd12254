"""The smallest pieces of a state's text: numbers, short texts, lists of numbers, checks."""

import re
from collections.abc import Sequence
from operator import sub

MAX_COUNT = 2**32 - 1

_HINT = "Send an empty state to start again."
_MESSAGES = {
    "state.unreadable": "The dialogue state is not a text this server wrote.",
    "state.damaged": "The dialogue state is damaged.",
    "state.version": "The dialogue state is of a version this server does not know.",
    "state.too_large": "The dialogue state is too large.",
}


class StateError(ValueError):
    """A state that cannot be read: a stable code, what happened and what to do.

    Example: `StateError("state.damaged").hint == "Send an empty state to start again."`
    """

    def __init__(self, code: str) -> None:
        super().__init__(f"{_MESSAGES[code]} {_HINT}")
        self.code = code
        self.message = _MESSAGES[code]
        self.hint = _HINT


class Reader:
    """Takes one piece after the other from verified bytes; anything odd is `state.damaged`."""

    __slots__ = ("data", "position")

    def __init__(self, data: bytes) -> None:
        self.data = data
        self.position = 0

    def number(self, largest: int = MAX_COUNT) -> int:
        """Return the next variable-length number, at most `largest`."""
        at = self.position
        if at < len(self.data) and self.data[at] < 0x80:
            self.position = at + 1
            return within(self.data[at], largest)
        value = shift = 0
        for byte in self.data[self.position : self.position + 10]:
            self.position += 1
            value |= (byte & 0x7F) << shift
            shift += 7
            if byte < 0x80:
                return within(value, largest)
        raise StateError("state.damaged")

    def take(self, length: int) -> bytes:
        """Return exactly the next `length` bytes."""
        taken = self.data[self.position : self.position + length]
        if len(taken) != length:
            raise StateError("state.damaged")
        self.position += length
        return taken

    def rest(self) -> bytes:
        """Return all bytes that are left."""
        return self.take(len(self.data) - self.position)

    def text(self, longest: int) -> str:
        """Return the next text of at most `longest` characters."""
        try:
            text = self.take(self.number(4 * longest)).decode("utf-8")
        except UnicodeDecodeError as error:
            raise StateError("state.damaged") from error
        within(len(text), longest)
        return text

    def numbers(self, most: int, largest: int) -> tuple[int, ...]:
        """Return the next list of at most `most` numbers, each at most `largest`."""
        count = self.number(most)
        if not count:
            return ()
        width = self.take(1)[0]
        values = self._steps(count) if width == _STEPS else self._fixed(count, width)
        if min(values) < 0 or max(values) > largest:
            raise StateError("state.damaged")
        return tuple(values)

    def bits(self, length: int) -> str:
        """Return the next `length` bits as "0101…"; the last byte is filled up with zeros."""
        data = self.take((length + 7) // 8)
        return f"{int.from_bytes(data, 'big'):0{8 * len(data)}b}"[:length]

    def _fixed(self, count: int, width: int) -> list[int]:
        if not 1 <= width <= 32:
            raise StateError("state.damaged")
        bits = self.bits(count * width)
        return [int(bits[at : at + width], 2) for at in range(0, count * width, width)]

    def _steps(self, count: int) -> list[int]:
        lengths = [int(digit, 16) for digit in self.take((count + 1) // 2).hex()[:count]]
        digits, values, value, at = self.bits(sum(lengths)), [], 0, 0
        for length in lengths:
            step = int("1" + digits[at : at + length], 2)
            at += length
            value += step >> 1 ^ -(step & 1)
            values.append(value)
        return values


def within(value: int, largest: int) -> int:
    """Return the value, or raise `state.damaged` where it is above `largest`."""
    if value > largest:
        raise StateError("state.damaged")
    return value


_SINGLE = tuple(bytes((value,)) for value in range(0x80))
_STEPS = 255  # instead of a width: the list is written as steps from number to number


def number(value: int, largest: int = MAX_COUNT) -> bytes:
    """Return the number in 7-bit groups, lowest first: 300 -> bytes 172, 2."""
    if 0 <= value < 0x80 and value <= largest:
        return _SINGLE[value]
    if not 0 <= value <= largest:
        raise ValueError(f"{value} is outside 0..{largest}, so the state cannot be written.")
    groups = bytearray()
    while value > 0x7F:
        groups.append(value & 0x7F | 0x80)
        value >>= 7
    groups.append(value)
    return bytes(groups)


def text(value: str, longest: int) -> bytes:
    """Return the text in UTF-8 after its length; ValueError where it is too long or no text."""
    if len(value) > longest:
        raise ValueError(f"A text of {len(value)} characters is over {longest}: {value[:40]!r}…")
    data = value.encode("utf-8")
    return number(len(data)) + data


def shaped(value: str, shape: re.Pattern[str]) -> str:
    """Return the text, or raise `state.damaged` where it has not the shape."""
    if not shape.fullmatch(value):
        raise StateError("state.damaged")
    return value


def numbers(values: Sequence[int], most: int, largest: int) -> bytes:
    """Return a list of numbers, as fixed-width bits or as steps, whichever is shorter.

    Frames said one after the other are often neighbours, so steps save a quarter of a ring.
    """
    count = number(len(values), most)
    if not values:
        return count
    highest = max(values)
    if min(values) < 0 or highest > largest:
        raise ValueError(f"A number of {values} is outside 0..{largest}.")
    differences = map(sub, values, (0, *values[:-1]))
    steps = [step << 1 if step >= 0 else ~(step << 1) for step in differences]
    width = highest.bit_length() or 1
    digits = [f"{step:b}" for step in steps]
    if 0 < min(steps) <= max(steps) < 2**16 and _cheaper("".join(digits), len(steps), width):
        return count + bytes((_STEPS,)) + _steps(digits)
    return count + bytes((width,)) + bits("".join([f"{value:0{width}b}" for value in values]))


def bits(digits: str) -> bytes:
    """Return the bits "0101…" as bytes, filled up with zeros at the end."""
    length = (len(digits) + 7) // 8
    return (int(digits or "0", 2) << (8 * length - len(digits))).to_bytes(length, "big")


def _cheaper(digits: str, count: int, width: int) -> bool:
    return 3 * count + len(digits) < width * count


def _steps(digits: Sequence[str]) -> bytes:
    # The highest bit of a step is always 1, so it is left out; half a byte says how many follow.
    lengths = "".join([_HEX[len(step)] for step in digits])
    tails = "".join([step[1:] for step in digits])
    return bytes.fromhex(lengths + "0" * (len(lengths) % 2)) + bits(tails)


_HEX = " 0123456789abcdef"  # of a length less one
