"""What an import would change, row by row and in words: exactly that edit and nothing else."""

import json
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping

import msgspec

from dialogue.engine.concepts import Frame
from ontology_io.aligning import aligned
from ontology_io.records import KnowledgeBase

#: The kinds of rows, as they are counted; "other" are phrases, value lists and orders.
KINDS = ("cultures", "topics", "sentences", "intents", "other")


class Change(msgspec.Struct, frozen=True, kw_only=True):
    """One row: `what` is added, changed, removed or renamed; `details` say it field by field.

    A detail is "likeliness IT: 0.9 → 0.95", or "− old" and "+ new" within a list.
    """

    kind: str
    what: str
    key: str
    details: tuple[str, ...] = ()

    def lines(self) -> Iterator[str]:
        """Yield the change as lines of text."""
        yield f"{self.kind}: {self.key} {self.what}"
        for detail in self.details:
            yield f"    {detail}"


def changes(old: KnowledgeBase, new: KnowledgeBase) -> tuple[Change, ...]:
    """Return what differs; `new` has its numbers. A renaming is one change, not two."""
    before = aligned(old, new)
    return (
        *_renamed(old, new),
        *_rows("cultures", _cultures(before), _cultures(new)),
        *_rows("topics", _topics(before), _topics(new)),
        *_rows("sentences", _frames(before), _frames(new)),
        *_rows("intents", _intents(before), _intents(new)),
        *_rows("other", _lists(before), _lists(new)),
        *_orders(before, new),
    )


def counted(found: Iterable[Change]) -> dict[str, dict[str, int]]:
    """Return how many rows were added, changed, removed and renamed, by kind."""
    counts: dict[str, Counter[str]] = {}
    for change in found:
        counts.setdefault(change.kind, Counter())[change.what] += 1
    return {kind: dict(sorted(counts[kind].items())) for kind in KINDS if kind in counts}


def _renamed(old: KnowledgeBase, new: KnowledgeBase) -> Iterator[Change]:
    topics = {topic.number: topic.key for topic in new.knowledge.topics}
    for topic in old.knowledge.topics:
        if topics.get(topic.number, topic.key) != topic.key:
            yield _renaming("topics", topic.key, topics[topic.number])
    intents = {intent.number: intent.key for intent in new.library.intents}
    for intent in old.library.intents:
        if intents.get(intent.number, intent.key) != intent.key:
            yield _renaming("intents", intent.key, intents[intent.number])


def _renaming(kind: str, old: str, new: str) -> Change:
    return Change(kind=kind, what="renamed", key=new, details=(f"name: {old} → {new}",))


def _rows(kind: str, old: Mapping[str, object], new: Mapping[str, object]) -> Iterator[Change]:
    for key, row in new.items():
        if key not in old:
            yield Change(kind=kind, what="added", key=key, details=tuple(_told({}, _flat(row))))
        elif old[key] != row:
            details = tuple(_told(_flat(old[key]), _flat(row)))
            if details:
                yield Change(kind=kind, what="changed", key=key, details=details)
    for key, row in old.items():
        if key not in new:
            yield Change(kind=kind, what="removed", key=key, details=tuple(_told(_flat(row), {})))


def _cultures(base: KnowledgeBase) -> dict[str, object]:
    return {culture.code: culture for culture in base.knowledge.cultures}


def _topics(base: KnowledgeBase) -> dict[str, object]:
    return {
        topic.key: msgspec.structs.replace(topic, number=0, frames=())
        for topic in base.knowledge.topics
    }


class _Sentence(msgspec.Struct, frozen=True):
    topic: str
    frame: Frame


def _frames(base: KnowledgeBase) -> dict[str, object]:
    found: dict[str, object] = {}
    for topic in base.knowledge.topics:
        for frame in topic.frames:
            found[frame.key] = _Sentence(topic.key, _plain(frame))
    for rows in base.knowledge.pools.values():
        for frame in rows:
            found[frame.key] = _Sentence("", _plain(frame))
    return found


def _plain(frame: Frame) -> Frame:
    return msgspec.structs.replace(frame, number=0, slot=-1)


def _intents(base: KnowledgeBase) -> dict[str, object]:
    return {one.key: msgspec.structs.replace(one, number=0) for one in base.library.intents}


def _lists(base: KnowledgeBase) -> dict[str, object]:
    found: dict[str, object] = {f"<{one.key}>": one for one in base.library.phrases}
    return found | {one.key: one for one in base.library.values}


def _orders(old: KnowledgeBase, new: KnowledgeBase) -> Iterator[Change]:
    """Yield the orders that differ among what both have."""
    before, after = _sequences(old), _sequences(new)
    for name, keys in after.items():
        had = before.get(name, [])
        both = {*had} & {*keys}
        if [key for key in had if key in both] != [key for key in keys if key in both]:
            detail = f"order: {' '.join(had)} → {' '.join(keys)}"
            yield Change(kind="other", what="changed", key=name, details=(detail,))


def _sequences(base: KnowledgeBase) -> dict[str, list[str]]:
    found: dict[str, list[str]] = {
        "cultures": [one.code for one in base.knowledge.cultures],
        "intents": [one.key for one in base.library.intents],
        "phrases": [one.key for one in base.library.phrases],
        "value lists": [one.key for one in base.library.values],
    }
    parents: Collection[str] = {topic.key for topic in base.knowledge.topics}
    for topic in base.knowledge.topics:
        found[f"sentences of {topic.key}"] = [frame.key for frame in topic.frames]
        # Branches stand in the order of their names, so that a new name moves them.
        if topic.is_a in parents:
            found.setdefault(f"topics below {topic.is_a}", []).append(topic.key)
    for name, rows in base.knowledge.pools.items():
        found[f"lines of {name}"] = [frame.key for frame in rows]
    return found


def _flat(row: object) -> dict[str, object]:
    """Return a row as path → plain value or tuple of texts; what is empty is left out."""
    found: dict[str, object] = {}
    _flatten("", msgspec.to_builtins(row), found)
    return found


def _flatten(path: str, value: object, found: dict[str, object]) -> None:
    if isinstance(value, dict):
        for key, inner in value.items():
            if (key, inner) not in (("number", 0), ("slot", -1)):
                name = "" if key == "frame" and not path else key
                _flatten(f"{path} {name}".strip(), inner, found)
    elif path.startswith("keywords "):
        found[path] = " / ".join("|".join(words) for words in value)  # type: ignore[attr-defined]
    elif isinstance(value, list | tuple):
        if value:
            found[path] = tuple(map(_item, value))
    elif value not in ("", None, False):
        found[path] = value


def _item(value: object) -> str:
    """Return what stands in a list as people write it."""
    if isinstance(value, str):
        return value
    if not isinstance(value, dict):
        return json.dumps(value, ensure_ascii=False)
    match value:
        case {"text": text, "only": only}:
            told = [text, f"({' '.join(only)})" if only else ""]
        case {"action": action, "parameters": parameters}:
            told = [action, *(f"{name}={text}" for name, text in parameters)]
        case {"sentence": sentence, "parameters": parameters}:
            told = [sentence, *_expected(parameters)]
        case _:
            plain = {key: one for key, one in value.items() if one not in ("", None, False, {}, [])}
            told = [json.dumps(plain, ensure_ascii=False)]
    return " ".join(part for part in told if part)


def _expected(parameters: dict[str, str] | None) -> Iterator[str]:
    """Yield what a test expects: `-> title=Hey Brother`, or `-> no`."""
    if parameters is None:
        yield "-> no"
    elif parameters:
        yield "-> " + " | ".join(f"{name}={text}" for name, text in parameters.items())


def _told(old: Mapping[str, object], new: Mapping[str, object]) -> Iterator[str]:
    """Yield each field that differs; of a row that is new or gone only what it says."""
    for path in [*new, *(path for path in old if path not in new)]:
        was, now = old.get(path), new.get(path)
        if was == now or path == "key":
            continue
        if isinstance(was, tuple) and isinstance(now, tuple):
            yield from _list(path, was, now)
        elif old and new:
            yield f"{path}: {_text(was)} → {_text(now)}"
        else:
            yield f"{path}: {_text(now if new else was)}"


def _list(path: str, old: tuple[str, ...], new: tuple[str, ...]) -> Iterator[str]:
    if sorted(old) == sorted(new):
        yield f"{path}: {_text(old)} → {_text(new)}"
        return
    for text in old:
        if text not in new:
            yield f"{path}: − {text}"
    for text in new:
        if text not in old:
            yield f"{path}: + {text}"


def _text(value: object) -> str:
    if value is None:
        return "–"
    return " | ".join(value) if isinstance(value, tuple) else str(value)
