"""One class with its individuals → one topic, without its sentences."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field

from dialogue.engine.concepts import ROOT, Topic, usual_likeliness
from languages.known import LANGUAGES
from ontology_io.owl.file_records import Individual, OwlTopic
from ontology_io.owl.names import PREFIXES, usual_individual
from ontology_io.owl.resolve_identity import Known
from ontology_io.owl.resolve_names import keywords, names
from ontology_io.owl.resolve_notes import Notes

DIGITS = 3
#: Reactions as other files write them in a pattern: `p|n` is our `r`.
_REACTION = re.compile(r"\b(?:p\s?\|\s?n|n\s?\|\s?p)\b")


@dataclass(frozen=True)
class World:
    """What all topics of one import share.

    `cultures` are codes in order; `keys` are the topics there will be; `numbers` and `ids` lead
    from a number or an id in the file to a topic's key; `keep` keeps what the file lacks.
    """

    known: Known[Topic]
    topics: Mapping[str, OwlTopic]
    cultures: tuple[str, ...]
    keys: frozenset[str]
    keep: bool
    notes: Notes
    renamed: Mapping[str, str] = field(default_factory=dict)
    ids: Mapping[str, str] = field(default_factory=dict)

    def called(self, key: str) -> str:
        """Return what a topic of the draft is called now."""
        return self.renamed.get(key, key)


def topic_of(new: OwlTopic, world: World) -> Topic:
    """Return the topic as the file has it; its frames are not in it."""
    old = world.known.old.get(new.key)
    is_a, also = _above(new, old, world)
    likeliness = _likeliness(new, old, world)
    told = names(new, old, world.notes)
    words = keywords(new, old, world.notes)
    variables = new.variables
    if world.keep and old:
        told, words = {**old.names, **told}, {**old.keywords, **words}
        variables = {**old.variables, **variables}
    return Topic(
        key=new.key,
        is_a=is_a,
        number=old.number if old else world.known.numbers.get(new.key, 0),
        also=also,
        of=new.home,
        gentle=new.gentle,
        stop=_stop(new, old),
        pattern=_pattern(new.pattern),
        variables=_in_order(variables),
        names=_in_order(told),
        keywords=_in_order(words),
        likeliness=likeliness,
        individuals=_individuals(new, old, world),
        see=_links(new, old, world),
        note=new.note,
    )


def _in_order(by_language: Mapping[str, object]) -> dict:  # type: ignore[type-arg]
    return {code: by_language[code] for code in LANGUAGES if code in by_language}


def _stop(new: OwlTopic, old: Topic | None) -> str:
    return old.stop if old and set(old.stop) == set(new.stop) else new.stop


def _pattern(text: str) -> tuple[str, ...]:
    ours = _REACTION.sub("r", text)
    return tuple(part.strip() for part in ours.split(" | ")) if ours.strip() else ()


def _above(new: OwlTopic, old: Topic | None, world: World) -> tuple[str, tuple[str, ...]]:
    """Return its place in the tree, and the further classes it takes sentences from."""
    was = world.called(old.is_a) if old else ""
    lent = tuple(world.called(key) for key in old.also) if old else ()
    parents = tuple(dict.fromkeys(new.parents)) or (ROOT,)
    if new.tree_parent in parents:
        is_a = new.tree_parent
    elif was in parents:
        is_a = was
    else:
        is_a = _parent(new.key, [key for key in parents if key not in lent], parents, world)
    also = tuple(key for key in parents if key not in (is_a, ROOT))
    if world.keep:
        also = (*lent, *(key for key in also if key not in lent))
        also = tuple(key for key in also if key in world.keys and key != is_a)
    kept = tuple(key for key in lent if key in also)
    also = (*kept, *sorted(key for key in also if key not in kept))
    return is_a, also


def _parent(key: str, fresh: list[str], parents: tuple[str, ...], world: World) -> str:
    others = [one for one in fresh if one != ROOT] or [one for one in parents if one != ROOT]
    if len(others) > 1:
        world.notes.note(
            key,
            f"It has several superclasses and no treeParent; {others[0]} is taken.",
            "Say with treeParent which one is above it in the Dialogue Tree.",
        )
    return others[0] if others else ROOT


def _likeliness(new: OwlTopic, old: Topic | None, world: World) -> dict[str, float]:
    usual = usual_likeliness(new.home, world.cultures)
    given = {one.culture: one for one in new.individuals}
    found = {}
    for code in world.cultures:
        one = given.get(code)
        if one and one.likeliness >= 0:
            found[code] = _rounded(one, world.notes)
            continue
        found[code] = usual[code]
        before = old.likeliness.get(code) if old else None
        if world.keep and before is not None:
            found[code] = before
        elif before is not None and before != usual[code]:
            lacks = "no likeliness" if one else "no individual"
            world.notes.note(
                new.key,
                f"It has {lacks} in {code} any more, so its likeliness goes back from"
                f" {before:g} to the usual {usual[code]:g}.",
            )
    return found


def _rounded(one: Individual, notes: Notes) -> float:
    value = round(one.likeliness, DIGITS)
    if value != one.likeliness:
        notes.note(one.name, f"Its likeliness {one.likeliness!r} is rounded to {value:g}.")
    return value


def _individuals(new: OwlTopic, old: Topic | None, world: World) -> dict[str, str]:
    """Return the names that are not the usual ones."""
    number = old.number if old else world.known.numbers.get(new.key, 0)
    stored = old.individuals if old else {}
    found = dict(stored) if world.keep else {}
    for one in new.individuals:
        usual = usual_individual(one.culture, new.key)
        mine = one.name not in (usual, f"{usual}_t{number}")
        if one.name.startswith(PREFIXES) or one.name in world.keys:
            world.notes.note(
                one.name, f"An individual cannot be called so; it is called {usual} now."
            )
        elif mine or stored.get(one.culture) == one.name:
            found[one.culture] = one.name
            continue
        found.pop(one.culture, None)
    return {code: found[code] for code in world.cultures if code in found}


def _links(new: OwlTopic, old: Topic | None, world: World) -> tuple[str, ...]:
    """Return the topics it leads to: the same in all cultures, in the order the file gives."""
    before = tuple(world.called(key) for key in old.see) if old else ()
    found: dict[str, set[str]] = {}
    for one in new.individuals:
        for key in one.links:
            if key != new.key and key in world.keys:
                found.setdefault(key, set()).add(one.culture)
    mine = {one.culture for one in new.individuals}
    for key, cultures in found.items():
        theirs = (
            {one.culture for one in world.topics[key].individuals}
            if (key in world.topics)
            else mine
        )
        if cultures < (mine & theirs):
            _tell_partly(new.key, key, key in before, world.notes)
    links = {*found, *(before if world.keep else ())} & world.keys
    order = [world.ids.get(id_, "") for id_ in new.link_order]
    place = {key: (0, index) for index, key in reversed([*enumerate(order)])}
    later = {key: (1, index) for index, key in reversed([*enumerate((*before, *found))])}
    return tuple(sorted(links, key=lambda key: place.get(key, later[key])))


def _tell_partly(key: str, target: str, known: bool, notes: Notes) -> None:
    if known:
        notes.note(
            key,
            f"Its link to {target} is gone in some cultures only, so it stays: links are the same"
            " for all cultures.",
            "Remove it from all individuals.",
        )
    else:
        notes.note(
            key, f"Its link to {target} stands in some cultures only; it is taken for all of them."
        )


def ids_of(topics: Mapping[str, OwlTopic], known: Known[Topic]) -> dict[str, str]:
    """Return the key of each topic by the ids that linkOrder may name it by."""
    found = {f"t{topic.number}": key for key, topic in known.old.items()}
    found |= {topic.id: key for key, topic in topics.items() if topic.id}
    for key, number in known.numbers.items():
        found.setdefault(f"t{number}", key)
    return found
