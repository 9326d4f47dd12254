"""The plain parts of the topic page: picture, spread, samples, shape, likeliness in words."""

from itertools import pairwise

import pytest

from authoring.topic_page.picture import (
    ABOVE,
    BELOW,
    FROM,
    LENDER,
    LINK,
    MOST_NODES,
    draw,
    shortened,
)
from authoring.topic_page.samples import samples
from authoring.topic_page.shape import Shape
from authoring.topic_page.spread import spread
from authoring.topic_page.words import liking


def many(count: int, first: int = 100) -> list[tuple[int, str]]:
    return [(number, f"topic {number}") for number in range(first, first + count)]


def test_what_is_above_stands_above_and_what_is_below_below() -> None:
    drawn = draw((1, "tea"), {ABOVE: [(2, "food"), (3, "drinks")], BELOW: [(4, "green tea")]})
    heights = {box.number: box.y for box in drawn.boxes}
    assert heights[2] < heights[3] < heights[1] < heights[4]


def test_a_picture_holds_two_hundred_topics_and_counts_the_others() -> None:
    drawn = draw((1, "tea"), {BELOW: many(230), LINK: many(3, 1000), FROM: many(2, 2000)})
    assert len(drawn.boxes) == MOST_NODES
    assert (drawn.more, drawn.hidden) == (36, {BELOW: 34, FROM: 2})


def test_boxes_never_overlap_and_stay_inside() -> None:
    groups = {
        ABOVE: many(6, 10),
        BELOW: many(60, 100),
        LINK: many(30, 300),
        FROM: many(40, 400),
        LENDER: many(3, 500),
    }
    drawn = draw((1, "tea"), groups)
    places = {(box.x, box.y) for box in drawn.boxes}
    assert len(places) == len(drawn.boxes) == 140
    columns = [sorted(box.y for box in drawn.boxes if box.x == x) for x in {p[0] for p in places}]
    assert all(b - a >= 38 for column in columns for a, b in pairwise(column))
    assert all(0 <= box.x <= drawn.width - 176 for box in drawn.boxes)
    assert all(0 <= box.y <= drawn.height - 38 for box in drawn.boxes)


def test_lenders_are_dashed_by_their_role() -> None:
    drawn = draw((1, "tea"), {LENDER: [(2, "gifts")]})
    assert [stroke.role for stroke in drawn.strokes] == [LENDER]


@pytest.mark.parametrize(
    ("name", "shown"),
    [("green tea", "green tea"), ("a" * 23, "a" * 22 + "…"), ("緑" * 12, "緑" * 11 + "…")],
)
def test_a_long_name_is_shortened_to_its_box(name: str, shown: str) -> None:
    assert shortened(name) == shown


def test_the_spread_tells_least_middle_and_most() -> None:
    seen = spread({0.3: 5, 0.5: 3, 0.9: 1}, 0.9)
    assert seen is not None
    assert (seen.least, seen.middle, seen.most, seen.topics) == (0.3, 0.3, 0.9, 9)
    assert [place for place, bar in enumerate(seen.bars) if bar.here] == [18]
    assert spread({}, 0.5) is None


@pytest.mark.parametrize("own", [0, 1, 1.5, -3, None])
def test_any_likeliness_has_a_place_in_the_spread(own: float | None) -> None:
    seen = spread({0.0: 1, 1.0: 1}, own)
    assert seen is not None
    assert sum(bar.here for bar in seen.bars) == (own is not None)


def test_samples_are_the_first_the_longest_and_the_oddest() -> None:
    names = {
        1: {"en": {"name": "drinks"}},
        2: {"en": {"name": "tea"}, "it": {"name": "tè"}},
        3: {"en": {"name": "elderflower cordial"}},
        4: {"it": {"name": "gnocchi", "n": "p", "sg": "gnocco"}},
    }
    assert samples(names) == (1, 3, 4)
    assert samples({1: names[1], 2: names[2]}) == (1, 2)
    assert samples({}) == ()


def test_a_circle_of_topics_ends() -> None:
    shape = Shape({1: "A", 2: "B"}, {1: 2, 2: 1}, {2: (1,), 1: (2,)})
    assert shape.above(1) == (2,)
    assert set(shape.below(1)) == {1, 2}
    assert shape.branch(1) == 2


@pytest.mark.parametrize(
    ("likeliness", "words"),
    [(0, "dislikes it"), (0.5, "may like it or not"), (1, "loves it"), (1.5, "")],
)
def test_likeliness_has_words(likeliness: float, words: str) -> None:
    assert str(liking(likeliness)) == words
