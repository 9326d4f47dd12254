"""Bar charts as plain geometry in whole units; a template draws them as SVG. Knows no Django."""

from collections.abc import Sequence
from dataclasses import dataclass

ROW, BAR = 30, 20
WIDTH, NAMES, END = 760, 190, 56
_SMALL_WIDTH, _SMALL_HEIGHT = 300, 120


@dataclass(frozen=True, slots=True)
class Piece:
    """A rectangle: `tone` numbers its colour from 0; `told` is its full text for a pointer.

    `mark` is written on it where it is wide enough, so that colour does not stand alone.
    """

    x: int
    y: int
    width: int
    height: int
    tone: int
    told: str
    mark: str = ""

    @property
    def middle(self) -> int:
        """Return where the mark stands."""
        return self.x + self.width // 2

    @property
    def foot(self) -> int:
        """Return the base line of the mark."""
        return self.y + self.height // 2 + 4


@dataclass(frozen=True, slots=True)
class Label:
    """A text at a place; `anchor` start, middle or end."""

    x: int
    y: int
    text: str
    anchor: str = "start"


@dataclass(frozen=True, slots=True)
class Chart:
    """A picture with its title and what it tells in one sentence; `legend` is (tone, words)."""

    name: str
    title: str
    told: str
    width: int
    height: int
    pieces: tuple[Piece, ...]
    labels: tuple[Label, ...]
    legend: tuple[tuple[int, str], ...] = ()


@dataclass(frozen=True, slots=True)
class Series:
    """One row of bars: its name and a value for each tone."""

    name: str
    values: Sequence[int]


def stacked(
    name: str, words: tuple[str, str], tones: Sequence[tuple[str, str]], rows: Sequence[Series]
) -> Chart:
    """Return one bar a row, its values one after another.

    `words` are title and description; `tones` are (mark, name). All bars share one scale from 0.
    """
    most = max((sum(row.values) for row in rows), default=0)
    pieces: list[Piece] = []
    labels: list[Label] = []
    for place, row in enumerate(rows):
        y, passed = place * ROW + (ROW - BAR) // 2, 0
        for tone, value in enumerate(row.values):
            start, passed = _scaled(passed, most), passed + value
            width = _scaled(passed, most) - start
            if value:
                told = f"{row.name}: {tones[tone][1]} {value}"
                mark = tones[tone][0] if width >= 14 else ""
                pieces.append(Piece(NAMES + start, y, max(width, 1), BAR, tone, told, mark))
        labels += _named(row.name, y, _scaled(passed, most), passed)
    legend = tuple((tone, f"{mark}: {told}") for tone, (mark, told) in enumerate(tones))
    return Chart(name, *words, WIDTH, len(rows) * ROW, tuple(pieces), tuple(labels), legend)


def grouped(
    name: str, words: tuple[str, str], tones: Sequence[tuple[str, str]], rows: Sequence[Series]
) -> Chart:
    """Return one thin bar for each value of a row, below each other, on one scale from 0."""
    most = max((value for row in rows for value in row.values), default=0)
    thin, gap = 14, 10
    high = thin * len(tones) + gap
    pieces: list[Piece] = []
    labels: list[Label] = []
    for place, row in enumerate(rows):
        top = place * high
        middle = top + (high - gap) // 2 + 5
        labels.append(Label(NAMES - 10, middle, _short(row.name), "end"))
        for tone, value in enumerate(row.values):
            y, width = top + tone * thin, _scaled(value, most)
            told = f"{row.name}: {tones[tone][1]} {value}"
            pieces.append(Piece(NAMES, y, max(width, 1), thin - 3, tone, told))
            labels.append(Label(NAMES + width + 6, y + 10, f"{tones[tone][0]} {value}"))
    legend = tuple((tone, told) for tone, (_mark, told) in enumerate(tones))
    height = len(rows) * high
    return Chart(name, *words, WIDTH, height, tuple(pieces), tuple(labels), legend)


def columns(
    name: str, words: tuple[str, str], rows: Sequence[Series], *, most: int, tone: int = 0
) -> Chart:
    """Return a small picture of upright bars; `most` is the value of the full height."""
    each = _SMALL_WIDTH // max(len(rows), 1)
    pieces: list[Piece] = []
    labels: list[Label] = []
    for place, row in enumerate(rows):
        value = sum(row.values)
        height = round(_SMALL_HEIGHT * value / most) if most else 0
        x, y = place * each + 2, 16 + _SMALL_HEIGHT - max(height, 1)
        told = f"{row.name}: {value}"
        pieces.append(Piece(x, y, each - 4, max(height, 1), tone, told))
        labels.append(Label(x + each // 2 - 2, y - 4, str(value), "middle"))
        labels.append(Label(x + each // 2 - 2, _SMALL_HEIGHT + 32, row.name, "middle"))
    width = max(each * len(rows), 1)
    return Chart(name, *words, width, _SMALL_HEIGHT + 40, tuple(pieces), tuple(labels))


def _scaled(value: int, most: int) -> int:
    return round(value * (WIDTH - NAMES - END) / most) if most else 0


def _named(name: str, y: int, width: int, value: int) -> list[Label]:
    foot = y + BAR // 2 + 4
    return [
        Label(NAMES - 10, foot, _short(name), "end"),
        Label(NAMES + width + 6, foot, str(value)),
    ]


def _short(name: str, longest: int = 26) -> str:
    return name if len(name) <= longest else f"{name[: longest - 1]}…"
