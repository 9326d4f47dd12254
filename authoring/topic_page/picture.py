"""The neighbourhood of a topic as a picture: what is above, below, beside it, who lends to it.

All lengths are the units of the picture; it is drawn by a template from these plain values.
"""

import unicodedata
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

MOST_NODES = 200
BOX, TALL = 176, 38
_GAP, _ROW, _LABEL = 14, 14, 22
_ABREAST = 5
_EDGE = 4
WIDTH = _ABREAST * (BOX + _GAP) + _GAP
_MIDDLE = (WIDTH - BOX) // 2
_LETTERS = 22

SELF, ABOVE, BELOW, LINK, FROM, LENDER = "self", "above", "below", "link", "from", "lender"
#: Which groups are kept where there are too many: the nearer to what is said, the earlier.
_ORDER = (ABOVE, LENDER, LINK, BELOW, FROM)


@dataclass(frozen=True, slots=True)
class Box:
    """One topic in the picture; `label` fits the box, `name` is whole."""

    number: int
    name: str
    label: str
    role: str
    x: int
    y: int

    @property
    def text_x(self) -> int:
        """Return where the label is centred."""
        return self.x + BOX // 2

    @property
    def text_y(self) -> int:
        """Return the label's base line."""
        return self.y + TALL // 2 + 5


@dataclass(frozen=True, slots=True)
class Stroke:
    """A line between two boxes; a lender's is dashed."""

    x1: int
    y1: int
    x2: int
    y2: int
    role: str


@dataclass(frozen=True, slots=True)
class Caption:
    """What stands over a group of boxes: its role and how many there are."""

    role: str
    count: int
    x: int
    y: int


@dataclass(frozen=True, slots=True)
class Picture:
    """Boxes, the lines behind them, captions; `hidden` counts by role what did not fit."""

    width: int
    height: int
    boxes: tuple[Box, ...]
    strokes: tuple[Stroke, ...]
    captions: tuple[Caption, ...]
    hidden: Mapping[str, int]

    @property
    def more(self) -> int:
        """Return how many topics did not fit."""
        return sum(self.hidden.values())


Named = Sequence[tuple[int, str]]


def draw(topic: tuple[int, str], groups: Mapping[str, Named]) -> Picture:
    """Return the picture of a topic; `groups` are number and name by role, ABOVE nearest last."""
    kept, hidden = _kept(groups)
    boxes, captions = [], []
    above = _stack(kept[ABOVE], ABOVE, _MIDDLE, _EDGE)
    here = _box(topic, SELF, _MIDDLE, _under(above, _EDGE))
    boxes += [*above, here]
    left, right = _GAP, WIDTH - BOX - _GAP
    bottom_left = 0
    for role in (LENDER, FROM):
        if kept[role]:
            captions.append(Caption(role, len(kept[role]), left, bottom_left + _LABEL - 8))
            group = _stack(kept[role], role, left, bottom_left + _LABEL)
            bottom_left = group[-1].y + TALL + _ROW
            boxes += group
    if kept[LINK]:
        captions.append(Caption(LINK, len(kept[LINK]), right, _LABEL - 8))
        boxes += _stack(kept[LINK], LINK, right, _LABEL)
    strokes = [_stroke(box, here) for box in boxes if box.role in (LENDER, FROM, LINK)]
    strokes += [_upright(one, two) for one, two in pairwise([*above, here])]
    bottom = max(box.y for box in boxes) + TALL
    if kept[BELOW]:
        captions.append(Caption(BELOW, len(kept[BELOW]), _GAP, bottom + _ROW + _LABEL))
        top = bottom + 2 * _LABEL + _ROW
        strokes.append(Stroke(here.text_x, here.y + TALL, here.text_x, top - _ROW // 2, BELOW))
        boxes += _rows(kept[BELOW], top)
        bottom = boxes[-1].y + TALL
    return Picture(WIDTH, bottom + _ROW, tuple(boxes), tuple(strokes), tuple(captions), hidden)


def _kept(groups: Mapping[str, Named]) -> tuple[dict[str, Named], dict[str, int]]:
    room = MOST_NODES - 1
    kept: dict[str, Named] = {}
    hidden: dict[str, int] = {}
    for role in _ORDER:
        whole = groups.get(role, ())
        kept[role] = whole[:room]
        room -= len(kept[role])
        if len(kept[role]) < len(whole):
            hidden[role] = len(whole) - len(kept[role])
    return kept, hidden


def _box(topic: tuple[int, str], role: str, x: int, y: int) -> Box:
    number, name = topic
    return Box(number, name, shortened(name), role, x, y)


def _stack(topics: Named, role: str, x: int, top: int) -> list[Box]:
    step = TALL + _ROW
    return [_box(topic, role, x, top + place * step) for place, topic in enumerate(topics)]


def _rows(topics: Named, top: int) -> list[Box]:
    return [
        _box(
            topic,
            BELOW,
            _GAP + place % _ABREAST * (BOX + _GAP),
            top + place // _ABREAST * (TALL + _ROW),
        )
        for place, topic in enumerate(topics)
    ]


def _under(boxes: Sequence[Box], top: int) -> int:
    return boxes[-1].y + TALL + _ROW if boxes else top


def _upright(upper: Box, lower: Box) -> Stroke:
    return Stroke(upper.text_x, upper.y + TALL, lower.text_x, lower.y, ABOVE)


def _stroke(side: Box, here: Box) -> Stroke:
    middle = here.y + TALL // 2
    if side.x < here.x:
        return Stroke(side.x + BOX, side.y + TALL // 2, here.x, middle, side.role)
    return Stroke(here.x + BOX, middle, side.x, side.y + TALL // 2, side.role)


def shortened(name: str, most: int = _LETTERS) -> str:
    """Return a name that fits a box; wide letters count twice."""
    room = most
    for place, letter in enumerate(name):
        room -= 2 if unicodedata.east_asian_width(letter) in "WF" else 1
        if room < 0:
            return f"{name[:place].rstrip()}…"
    return name
