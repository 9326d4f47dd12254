"""What changes from one release to another: pure values, told in words by release_words."""

from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from authoring.releases.release_library import library_changes
from authoring.releases.release_rows import (
    KINDS,
    Change,
    Make,
    by_number,
    field_changes,
    list_changes,
    mapping_changes,
    order_changes,
)
from dialogue.engine.concepts import ROOT, Frame, Knowledge, Topic
from dialogue.snapshot import Snapshot
from plans.engine.intents import Library

NOTHING = Snapshot(knowledge=Knowledge(), library=Library())
#: So many changes of a kind are kept to be shown; the rest is counted.
MOST_SHOWN = 200


@dataclass(frozen=True, slots=True)
class Notes:
    """The changes that are shown, at most MOST_SHOWN of a kind, and how many there are.

    `counts` are by kind, `whats` by kind and what became of the row.
    """

    shown: tuple[Change, ...]
    counts: Mapping[str, int]
    whats: Mapping[tuple[str, str], int]
    changed_intents: tuple[str, ...] = ()

    @property
    def total(self) -> int:
        """Return how many changes there are."""
        return sum(self.counts.values())


def notes(old: Snapshot | None, new: Snapshot) -> Notes:
    """Return the changes from an old release (None: there was none) to a new one, bounded."""
    shown: list[Change] = []
    counts: Counter[str] = Counter()
    whats: Counter[tuple[str, str]] = Counter()
    intents: dict[int, str] = {}
    for change in release_notes(old, new):
        counts[change.kind] += 1
        whats[change.kind, change.what] += 1
        if counts[change.kind] <= MOST_SHOWN:
            shown.append(change)
        if change.kind == "intents" and change.what not in ("added", "removed", "order"):
            intents[change.number] = change.where
    shown.sort(key=lambda change: KINDS.index(change.kind))
    return Notes(tuple(shown), dict(counts), dict(whats), tuple(intents.values()))


def release_notes(old: Snapshot | None, new: Snapshot) -> list[Change]:
    """Return all changes; rows are the same where their numbers are, whatever their keys."""
    before = old or NOTHING
    return [
        *_cultures(before.knowledge, new.knowledge),
        *_topics(before.knowledge, new.knowledge),
        *_pools(before.knowledge, new.knowledge),
        *library_changes(before.library, new.library),
    ]


def _cultures(old: Knowledge, new: Knowledge) -> Iterator[Change]:
    before = {culture.code: culture for culture in old.cultures}
    after = {culture.code: culture for culture in new.cultures}
    for code in {**after, **before}:
        make = Make("cultures", code)
        if code not in before:
            yield make("added")
        elif code not in after:
            yield make("removed")
        else:
            yield from field_changes(make, before[code], after[code], ("language",))
            yield from mapping_changes(make, "names", before[code].names, after[code].names)
    both = [code for code in before if code in after]
    if both != [code for code in after if code in before]:
        yield Make("cultures", "")("order")


class _Frames:
    """The frames of topics that differ, each with the number of its topic."""

    def __init__(self) -> None:
        self.frames: dict[int, tuple[int, Frame]] = {}

    def add(self, topic: Topic) -> None:
        """Take the frames of a topic in."""
        for frame in topic.frames:
            self.frames[frame.number] = (topic.number, frame)


def _topics(old: Knowledge, new: Knowledge) -> Iterator[Change]:
    before, after = by_number(old.topics), by_number(new.topics)
    world = _World(old, new)
    gone, come = _Frames(), _Frames()
    for number, topic in after.items():
        was = before.get(number)
        if was is None:
            come.add(topic)
            make = Make("topics", topic.key, number)
            yield make("added", "", str(len(topic.frames)), topic.is_a)
        elif was != topic:
            gone.add(was)
            come.add(topic)
            yield from _topic(was, topic, world)
    for number, topic in before.items():
        if number not in after:
            gone.add(topic)
            yield Make("topics", topic.key, number)("removed", str(len(topic.frames)))
    yield from _frames("sentences", gone, come, world)
    yield from _orders(old, new)


class _World:
    """The numbers and keys of all topics, old and new, to tell renaming from moving."""

    def __init__(self, old: Knowledge, new: Knowledge) -> None:
        self.old_numbers = {topic.key: topic.number for topic in old.topics}
        self.new_numbers = {topic.key: topic.number for topic in new.topics}
        self.old_keys = {number: key for key, number in self.old_numbers.items()}
        self.new_keys = {number: key for key, number in self.new_numbers.items()}

    def links(self, old: tuple[str, ...], new: tuple[str, ...]) -> tuple[list[str], list[str]]:
        """Return two lists of topics by what they are called now: a renaming is no other link."""
        called = [self.new_keys.get(self.old_numbers.get(key, 0), key) for key in old]
        return called, list(new)


def _topic(old: Topic, new: Topic, world: _World) -> Iterator[Change]:
    make = Make("topics", new.key, new.number)
    if old.key != new.key:
        yield make("renamed", old.key, new.key)
    yield from _place(make, old, new, world)
    fields = ("of", "gentle", "stop", "pattern", "note")
    yield from field_changes(make, old, new, fields)
    yield from mapping_changes(make, "variable", _variables(old), _variables(new))
    naming = Make("names", new.key, new.number)
    for code in {**old.names, **new.names}:
        yield from _name(naming, code, old.names.get(code, {}), new.names.get(code, {}))
    words = Make("keywords", new.key, new.number)
    yield from mapping_changes(words, "words", old.keywords, new.keywords, _keywords)
    likes = Make("likeliness", new.key, new.number)
    yield from mapping_changes(likes, "value", old.likeliness, new.likeliness, _number)
    kept = [frame.number for frame in old.frames], [frame.number for frame in new.frames]
    yield from order_changes(Make("sentences", new.key, new.number), *kept)


def _place(make: Make, old: Topic, new: Topic, world: _World) -> Iterator[Change]:
    above = world.links((old.is_a,), (new.is_a,))
    if above[0] != above[1]:
        yield make("moved", old.is_a, new.is_a)
    yield from list_changes(make, "link", *world.links(old.see, new.see))
    yield from list_changes(make, "also", *world.links(old.also, new.also))


def _variables(topic: Topic) -> dict[str, str]:
    return {
        f"{code} {name}": text
        for code, texts in topic.variables.items()
        for name, text in texts.items()
    }


def _name(
    make: Make, code: str, old: Mapping[str, str], new: Mapping[str, str]
) -> Iterator[Change]:
    if old.get("name", "") != new.get("name", ""):
        yield make("name", old.get("name", ""), new.get("name", ""), code)
    if _forms(old) != _forms(new):
        yield make("forms", _forms(old), _forms(new), code)


def _forms(texts: Mapping[str, str]) -> str:
    return ", ".join(f"{name}: {text}" for name, text in sorted(texts.items()) if name != "name")


def _keywords(words: tuple[tuple[str, ...], tuple[str, ...]]) -> str:
    return " / ".join(" | ".join(one) for one in words)


def _number(value: float) -> str:
    return f"{value:g}"


def _frames(kind: str, gone: _Frames, come: _Frames, world: _World) -> Iterator[Change]:
    for number, (owner, frame) in come.frames.items():
        make = Make(kind, frame.key, number)
        if number in gone.frames:
            yield from _frame(make, gone.frames[number], (owner, frame), world)
        elif owner in world.old_keys:
            yield make("added", "", _spoken(frame), frame.type)
    for number, (owner, frame) in gone.frames.items():
        if number not in come.frames and owner in world.new_keys:
            yield Make(kind, frame.key, number)("removed", _spoken(frame), "", frame.type)


def _spoken(frame: Frame) -> str:
    return frame.texts.get("en") or next(iter(frame.texts.values()), "")


def _frame(
    make: Make, old: tuple[int, Frame], new: tuple[int, Frame], world: _World
) -> Iterator[Change]:
    if old[0] != new[0]:
        yield make("moved", world.old_keys.get(old[0], ROOT), world.new_keys.get(new[0], ROOT))
    yield from _said(make, old[1], new[1])


def _said(make: Make, old: Frame, new: Frame) -> Iterator[Change]:
    if old != new:
        yield from mapping_changes(make, "text", old.texts, new.texts)
        yield from field_changes(make, old, new, ("type", "only", "scope", "do"))


def _pools(old: Knowledge, new: Knowledge) -> Iterator[Change]:
    if old.pools == new.pools:
        return
    before, after = ({one.number: one for one in _pooled(each)} for each in (old, new))
    for number in {**after, **before}:
        frame = after.get(number) or before[number]
        make = Make("pools", frame.key, number)
        if number not in before:
            yield make("added", "", _spoken(frame), frame.type)
        elif number not in after:
            yield make("removed", _spoken(frame), "", frame.type)
        else:
            yield from _said(make, before[number], after[number])
    for name, frames in new.pools.items():
        kept = [one.number for one in old.pools.get(name, ())], [one.number for one in frames]
        yield from order_changes(Make("pools", name), *kept)


def _pooled(knowledge: Knowledge) -> Iterator[Frame]:
    for frames in knowledge.pools.values():
        yield from frames


def _orders(old: Knowledge, new: Knowledge) -> Iterator[Change]:
    """Yield the topics below which others come in another order."""
    before, after = _children(old), _children(new)
    keys = {topic.number: topic.key for topic in new.topics}
    for parent, children in after.items():
        make = Make("topics", keys.get(parent, ROOT), parent)
        yield from order_changes(make, before.get(parent, []), children)


def _children(knowledge: Knowledge) -> dict[int, list[int]]:
    numbers = {topic.key: topic.number for topic in knowledge.topics}
    children: dict[int, list[int]] = defaultdict(list)
    for topic in knowledge.topics:
        children[numbers.get(topic.is_a, 0)].append(topic.number)
    return children
