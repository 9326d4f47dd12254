"""From what a file says to a knowledge base to be written: what is what, what moved, what is new.

Ids come first, then natural keys (docs/ontology.md). Nothing is written here.
"""

from collections.abc import Iterable, Mapping

import msgspec

from dialogue.engine.concepts import Culture, Frame, Knowledge, Topic, usual_likeliness
from ontology_io.owl.file_records import OwlFile, Problem
from ontology_io.owl.resolve_fit import fitting
from ontology_io.owl.resolve_frames import Frames, Spot, Wording, frames_of
from ontology_io.owl.resolve_identity import Renamed, known_intents, known_topics
from ontology_io.owl.resolve_library import library_of
from ontology_io.owl.resolve_names import in_our_words
from ontology_io.owl.resolve_notes import HIGHEST, Notes
from ontology_io.owl.resolve_order import Place, in_order, places, topics_in_order
from ontology_io.owl.resolve_topics import World, ids_of, topic_of
from ontology_io.records import KnowledgeBase

Spoken = Mapping[tuple[bool, str], Frames]


class Resolved(msgspec.Struct, frozen=True, kw_only=True):
    """What is to be written, what has another name now, and what there is to tell.

    `last` are the highest numbers ever given, by kind. A number 0 is given when it is written.
    """

    base: KnowledgeBase
    renamed: tuple[Renamed, ...] = ()
    problems: tuple[Problem, ...] = ()
    last: dict[str, int] = {}


def resolve(file: OwlFile, draft: KnowledgeBase, *, keep: bool = False) -> Resolved:
    """Return the knowledge base that the file asks for.

    What the draft has and the file lacks is removed, or stays with `keep`. `problems` are those
    found here only; with errors among them the knowledge base must not be written.
    """
    notes = Notes()
    file = in_our_words(file, notes)
    intents = known_intents(file.intents, draft.library.intents, notes)
    cultures = _cultures(file, draft.knowledge, notes, keep=keep)
    world = _world(file, draft.knowledge, cultures, notes, keep=keep)
    library = library_of(file, draft.library, intents, notes, keep=keep)
    wording = Wording(
        world.cultures, frozenset(intent.key for intent in library.intents), keep, notes
    )
    spoken = frames_of(_spots(file, draft.knowledge, world), wording)
    knowledge = Knowledge(
        cultures=cultures,
        topics=_topics(file, draft.knowledge, world, spoken),
        pools=_pools(file, draft.knowledge, spoken, world),
    )
    base = KnowledgeBase(knowledge=knowledge, library=library)
    fitting(base, notes)
    return Resolved(
        base=base,
        renamed=(*world.known.renamed, *intents.renamed),
        problems=tuple(notes.problems),
        last={kind: _bounded(kind, last, notes) for kind, last in sorted(file.highest.items())},
    )


def _bounded(kind: str, last: int, notes: Notes) -> int:
    most = HIGHEST.get(kind, 0)
    if 0 <= last <= most:
        return last
    notes.note("highestNumbers", f"{kind}={last} is not taken: {most} is the most.")
    return 0


def _cultures(file: OwlFile, draft: Knowledge, notes: Notes, *, keep: bool) -> tuple[Culture, ...]:
    if not file.cultures:
        notes.note("Culture", "The file has no cultures; those of the draft stay.")
        return draft.cultures
    before = {one.code: one for one in draft.cultures}
    line = places(before)
    rows: dict[str, tuple[Culture, Place]] = {}
    for new in sorted(file.cultures, key=lambda one: one.code):
        names, old = new.names, before.get(new.code)
        if keep and old:
            names = {**old.names, **names}
        culture = Culture(code=new.code, names=names, language=new.language)
        rows[new.code] = culture, Place(new.order, line.get(new.code, 0))
    if keep:
        for code, old in before.items():
            rows.setdefault(code, (old, Place(line[code], line[code])))
    return tuple(rows[code][0] for code in in_order((code, row[1]) for code, row in rows.items()))


def _world(
    file: OwlFile, draft: Knowledge, cultures: Iterable[Culture], notes: Notes, *, keep: bool
) -> World:
    known = known_topics(file.topics, draft.topics, notes)
    topics = {topic.key: topic for topic in file.topics}
    renamed = known.names()
    kept = {renamed.get(topic.key, topic.key) for topic in draft.topics} if keep else set()
    return World(
        known=known,
        topics=topics,
        cultures=tuple(culture.code for culture in cultures),
        keys=frozenset(topics) | kept,
        keep=keep,
        notes=notes,
        renamed=renamed,
        ids=ids_of(topics, known),
    )


def _spots(file: OwlFile, draft: Knowledge, world: World) -> list[Spot]:
    """Return every topic and pool where the file or the draft says something."""
    above = {key for topic in file.topics for key in topic.parents}
    if world.keep:
        above |= {world.called(key) for topic in draft.topics for key in (topic.is_a, *topic.also)}
    old = world.known.old
    spots = [
        Spot(
            topic.key,
            topic.said,
            old[topic.key].frames if topic.key in old else (),
            whole=topic.key in above,
        )
        for topic in file.topics
    ]
    found = {topic.number for topic in old.values()}
    spots += [Spot(one.key, (), one.frames) for one in draft.topics if one.number not in found]
    names = dict.fromkeys([*file.pools, *draft.pools])
    return spots + [
        Spot(name, file.pools.get(name, ()), draft.pools.get(name, ()), pool=True)
        for name in names
        if file.has_pools
    ]


def _topics(file: OwlFile, draft: Knowledge, world: World, spoken: Spoken) -> tuple[Topic, ...]:
    replace = msgspec.structs.replace
    topics = [replace(topic_of(new, world), frames=spoken[False, new.key]) for new in file.topics]
    old_keys = {key: old.key for key, old in world.known.old.items()}
    if world.keep:
        had = {*old_keys.values()}
        kept = [topic for topic in draft.topics if topic.key not in had]
        topics += [_kept(topic, world, spoken[False, topic.key]) for topic in kept]
        old_keys |= {topic.key: topic.key for topic in kept}
    orders = {topic.key: topic.order for topic in file.topics if topic.order}
    return topics_in_order(topics, orders, old_keys, draft.topics)


def _kept(old: Topic, world: World, frames: Frames) -> Topic:
    """Return a topic that only the draft has, with the names its neighbours have now."""
    return msgspec.structs.replace(
        old,
        is_a=world.called(old.is_a),
        also=tuple(map(world.called, old.also)),
        see=tuple(map(world.called, old.see)),
        likeliness=usual_likeliness(old.of, world.cultures) | old.likeliness,
        frames=frames,
    )


def _pools(
    file: OwlFile, draft: Knowledge, spoken: Spoken, world: World
) -> dict[str, tuple[Frame, ...]]:
    if file.has_pools:
        names = dict.fromkeys([*file.pools, *draft.pools])
        return {name: spoken[True, name] for name in names if spoken[True, name]}
    if draft.pools:
        world.notes.note("Pool", "The file has no pools; those of the draft stay.")
    found = {
        name: tuple(one for one in (_in(frame, world) for frame in frames) if one)
        for name, frames in draft.pools.items()
    }
    return {name: frames for name, frames in found.items() if frames}


def _in(frame: Frame, world: World) -> Frame | None:
    """Return a line without the cultures that are gone; None where it was for those alone."""
    only = tuple(code for code in frame.only if code in world.cultures)
    if frame.only and not only:
        world.notes.note(frame.key, "It was for cultures that are gone, so it goes too.")
        return None
    return msgspec.structs.replace(frame, only=only)
