"""Sentences → frames: numbers and keys of the draft for what it has, new keys for what is new."""

from collections import defaultdict
from collections.abc import Callable, Collection, Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple, TypeVar

import msgspec

from dialogue.engine.concepts import Frame
from languages.known import LANGUAGES
from ontology_io.owl.file_records import Said
from ontology_io.owl.resolve_groups import Group, grouped
from ontology_io.owl.resolve_notes import Notes, agreed, same_set
from ontology_io.owl.resolve_order import Place, in_order

T = TypeVar("T", bound=Hashable)
Frames = tuple[Frame, ...]

#: The most digits in the key of a frame (dialogue.validators.frame_key).
_LONGEST_NUMBER = 4


class Spot(NamedTuple):
    """A topic or a pool with what the file says there, and the frames the draft has there.

    `key` is what it is called now; `whole` says that others lie below this topic.
    """

    key: str
    said: tuple[Said, ...]
    before: Frames = ()
    whole: bool = False
    pool: bool = False


@dataclass(frozen=True)
class Wording:
    """What all frames of one import share; `intents` are the keys of the file's intents."""

    cultures: tuple[str, ...]
    intents: frozenset[str]
    keep: bool
    notes: Notes


def frames_of(spots: Sequence[Spot], wording: Wording) -> dict[tuple[bool, str], Frames]:
    """Return the frames of each topic and pool, in order, by `pool` and key."""
    draft = {frame.number: frame for spot in spots for frame in spot.before}
    groups = [
        grouped(spot.key, spot.said, spot.before, wording.cultures, wording.notes) for spot in spots
    ]
    _settle(spots, groups, draft, wording.notes)
    used = {group.number for rows in groups for group in rows}
    return {
        (spot.pool, spot.key): _Spoken(spot, draft, wording).frames(rows, used)
        for spot, rows in zip(spots, groups, strict=True)
    }


def _settle(
    spots: Sequence[Spot],
    groups: Sequence[list[Group]],
    draft: Mapping[int, Frame],
    notes: Notes,
) -> None:
    """Leave each number with one group only: at its own place first, then where it has moved."""
    home = {frame.number: place for place, spot in enumerate(spots) for frame in spot.before}
    claims: dict[int, list[tuple[int, Group]]] = defaultdict(list)
    for place, rows in enumerate(groups):
        for group in rows:
            if group.number:
                claims[group.number].append((place, group))
    taken = {*claims}
    for number, claimed in claims.items():
        kept = _keeper(draft.get(number), home.get(number, -1), claimed)
        for place, group in claimed:
            if group is not kept:
                group.number = _same_words(group, spots[place], taken)
                notes.note(
                    spots[place].key,
                    f"{_spoken(group)!r} has the id of another sentence; it is taken as new.",
                    "Leave the id out of what is new.",
                )


def _same_words(group: Group, spot: Spot, taken: set[int]) -> int:
    """Return the number of a frame of the draft that says just this and is nobody's yet, else 0."""
    for frame in spot.before:
        same = (frame.type, frame.texts) == (group.type, group.texts)
        if same and frame.number not in taken:
            taken.add(frame.number)
            return frame.number
    return 0


def _keeper(frame: Frame | None, home: int, rows: Sequence[tuple[int, Group]]) -> Group | None:
    if frame is None:
        return rows[0][1]
    texts = {*frame.texts.items()}
    here = [group for place, group in rows if place == home]
    if not here:
        moved = [group for _, group in rows if texts & {*group.texts.items()}]
        return moved[0] if moved else None

    def likeness(group: Group) -> tuple[bool, int, bool]:
        same = not group.cultures or {*group.cultures} == {*frame.only}
        return group.type == frame.type, len(texts & {*group.texts.items()}), same

    return max(here, key=likeness)


def _spoken(group: Group) -> str:
    return next(iter(group.texts.values()), "")


class _Spoken:
    """The frames of one place."""

    def __init__(self, spot: Spot, draft: Mapping[int, Frame], wording: Wording) -> None:
        self.spot, self.draft, self.wording = spot, draft, wording
        self.here = {frame.number: frame for frame in spot.before}
        self.place = {frame.number: place for place, frame in enumerate(spot.before, 1)}
        self.taken = {self._end(frame) for frame in spot.before}

    def _end(self, frame: Frame) -> str:
        """Return what is left of a frame's key without its topic: q1, or 12 in a pool."""
        return frame.key.rpartition(".")[2]

    def frames(self, groups: Iterable[Group], used: Collection[int]) -> Frames:
        """Return the frames in order; with `keep`, those too that only the draft has."""
        rows: list[tuple[Frame, Place]] = []
        for group in sorted(groups, key=lambda one: (one.number not in self.here, not one.tag)):
            rows.append((self._frame(group), self._place(group)))
        if self.wording.keep:
            for number, frame in self.here.items():
                if number not in used:
                    key = f"{self.spot.key}.{self._end(frame)}"
                    place = self.place[number]
                    rows.append((msgspec.structs.replace(frame, key=key), Place(place, place)))
        by_key = {frame.key: frame for frame, _ in rows}
        return tuple(by_key[key] for key in in_order((frame.key, at) for frame, at in rows))

    def _place(self, group: Group) -> Place:
        before = self.place.get(group.number, 0)
        told = [said.order for said in group.sure or group.said.values() if said.order]
        return Place(agreed(told, before)[0] if told else 0, before)

    def _frame(self, group: Group) -> Frame:
        old = self.draft.get(group.number)
        texts = group.texts
        if old and self.wording.keep:
            texts = {**old.texts, **texts}
        slot = (
            old.slot
            if old
            else self._agreed(group, lambda said: said.slot, -1, -1)
            if group.number
            else -1
        )
        return Frame(
            key=f"{self.spot.key}.{self._ending(group)}",
            type=group.type,
            texts={code: texts[code] for code in LANGUAGES if code in texts},
            number=group.number,
            slot=slot,
            only=self._only(group, old),
            scope=self._scope(group, old),
            do=self._activity(group, old),
        )

    def _agreed(self, group: Group, value_of: Callable[[Said], T], nothing: T, before: T) -> T:
        """Return what all languages of a frame say; of several things, the one that is new."""
        values = [value_of(said) for said in group.sure] or [
            value for said in group.said.values() if (value := value_of(said)) != nothing
        ]
        if not values:
            return nothing
        value, same = agreed(values, before)
        if not same:
            self.wording.notes.note(
                self.spot.key,
                f"{_spoken(group)!r} is annotated differently in its languages; {value!r} is"
                f" taken, not {', '.join(repr(one) for one in {*values} - {value})}.",
                "Write the same in all languages of a sentence.",
            )
        return value

    def _ending(self, group: Group) -> str:
        """Return the key without its topic: the draft's, that of the file, or the next free one."""
        letter = "" if self.spot.pool else group.type
        old = self.here.get(group.number)
        if old and old.type == group.type:
            return self._end(old)
        told = group.tag.rpartition(".")[2]
        digits = told.removeprefix(letter)
        fits = told.startswith(letter) and digits.isdecimal() and len(digits) <= _LONGEST_NUMBER
        if not fits or told in self.taken or int(digits) < 1:
            ends = [one.removeprefix(letter) for one in self.taken if one.startswith(letter)]
            told = f"{letter}{max([int(end) for end in ends if end.isdecimal()], default=0) + 1}"
        self.taken.add(told)
        return told

    def _only(self, group: Group, old: Frame | None) -> tuple[str, ...]:
        before = old.only if old else ()
        if group.cultures:
            return same_set(self._ordered(group.cultures), before)
        told = self._agreed(
            group, lambda said: frozenset(said.only), frozenset(), frozenset(before)
        )
        return same_set(self._ordered(told), before)

    def _ordered(self, codes: Iterable[str]) -> tuple[str, ...]:
        wanted = {*codes}
        return tuple(code for code in self.wording.cultures if code in wanted)

    def _scope(self, group: Group, old: Frame | None) -> str:
        told = self._agreed(group, lambda said: said.scope, "", old.scope if old else "")
        if group.cultures and self.spot.whole and not told:
            return "self"
        return told

    def _activity(self, group: Group, old: Frame | None) -> str:
        before = old.do if old else ""
        told = self._agreed(group, lambda said: said.activity, "", before)
        goal = self._agreed(group, lambda said: said.goal, "", _first(before))
        if not goal or _first(told) == goal:
            return told
        if told and _first(told) in self.wording.intents and goal == _first(before):
            return told
        return " ".join([goal, *told.split(" ", 1)[1:]])


def _first(activity: str) -> str:
    return activity.split(maxsplit=1)[0] if activity.strip() else ""
