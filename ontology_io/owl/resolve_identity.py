"""Which row of the draft a class or an intent of the file is: ids first, then names."""

from collections.abc import Callable, Collection, Iterable, Mapping
from typing import Generic, NamedTuple, Protocol, TypeVar

from dialogue.engine.concepts import Topic
from ontology_io.owl.file_records import OwlIntent, OwlTopic
from ontology_io.owl.resolve_notes import Notes, number_in
from plans.engine.intents import Intent


class Renamed(NamedTuple):
    """A row with another name; `kind` is topic or intent."""

    kind: str
    old: str
    new: str


class _Old(Protocol):
    @property
    def key(self) -> str: ...
    @property
    def number(self) -> int: ...


OldT = TypeVar("OldT", bound=_Old)


class Known(NamedTuple, Generic[OldT]):
    """The rows of the draft by their key in the file, and the numbers of what is new there."""

    old: Mapping[str, OldT]
    numbers: Mapping[str, int]
    renamed: tuple[Renamed, ...]

    def names(self) -> dict[str, str]:
        """Return the key in the file of each row of the draft that has another one there."""
        return {one.old: one.new for one in self.renamed}


def known_topics(new: Collection[OwlTopic], old: Iterable[Topic], notes: Notes) -> Known[Topic]:
    """Return what is what; a class of another name is the topic if something else is the same."""
    by_key = {topic.key: topic for topic in new}
    ids = {topic.key: number_in(topic.id, "topic") for topic in new}
    return _known("topic", ids, old, lambda key, topic: _same_topic(by_key[key], topic), notes)


def known_intents(new: Collection[OwlIntent], old: Iterable[Intent], notes: Notes) -> Known[Intent]:
    """Return what is what; an intent of another name is the one that shares a sentence."""
    by_key = {one.intent.key: one.intent for one in new}
    ids = {one.intent.key: number_in(one.id, "intent") for one in new}
    return _known("intent", ids, old, lambda key, one: _same_intent(by_key[key], one), notes)


def _known(
    kind: str,
    ids: Mapping[str, int],
    draft: Iterable[OldT],
    same: Callable[[str, OldT], bool],
    notes: Notes,
) -> Known[OldT]:
    rows = tuple(draft)
    by_key = {row.key: row for row in rows}
    by_number = {row.number: row for row in rows}
    found = {key: by_key[key] for key in ids if key in by_key}
    numbers: dict[str, int] = {}
    given: set[int] = set()
    for key in [key for key in ids if key not in by_key]:
        number = ids[key]
        old = by_number.get(number)
        if number in given or (old and old.key in ids):
            notes.note(key, f"Its id {number} belongs to another {kind}, so it is new.")
        elif old and same(key, old):
            found[key] = old
            given.add(number)
        elif number and not old:
            numbers[key] = number
            given.add(number)
    renamed = [Renamed(kind, old.key, key) for key, old in found.items() if old.key != key]
    return Known(found, numbers, tuple(renamed))


def _same_topic(new: OwlTopic, old: Topic) -> bool:
    names = {(code, fields.get("name", "")) for code, fields in old.names.items()}
    if any((code, fields.get("name", "")) in names for code, fields in new.names.items()):
        return True
    usual = {f"{code}_{old.key.upper()}" for code in old.likeliness} | {*old.individuals.values()}
    if any(one.name in usual for one in new.individuals):
        return True
    texts = {(code, text) for frame in old.frames for code, text in frame.texts.items()}
    return any((said.language, said.text) in texts for said in new.said)


def _same_intent(new: Intent, old: Intent) -> bool:
    def texts(one: Intent) -> set[tuple[str, str]]:
        triggers = {(code, text) for code, rows in one.triggers.items() for text in rows}
        said = {(code, row.text) for code, rows in one.plan_sentences.items() for row in rows}
        return triggers | said | {*one.abilities.items()}

    return bool(texts(new) & texts(old)) or (bool(new.plan or new.kbplan) and new.plan == old.plan)
