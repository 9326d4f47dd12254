"""Intents, phrases and value lists of the file → the library, with numbers of the draft."""

import re
from collections.abc import Iterable, Mapping
from typing import TypeVar

import msgspec

from ontology_io.owl.file_records import OwlFile, OwlIntent
from ontology_io.owl.resolve_identity import Known
from ontology_io.owl.resolve_notes import Notes, same_set
from ontology_io.owl.resolve_order import Place, in_order, places
from plans.engine.intents import Intent, Library, Phrase, PlanSentence, Slot, ValueList

T = TypeVar("T")
ListT = TypeVar("ListT", Phrase, ValueList)
_NAME = re.compile(r"\{([a-z][a-z0-9_]*)\}")


def library_of(
    file: OwlFile, draft: Library, known: Known[Intent], notes: Notes, *, keep: bool
) -> Library:
    """Return the library as the file has it; with `keep`, with all the draft has too."""
    intents = _intents(file.intents, draft, known, notes, keep=keep)
    if not file.has_lists and (draft.phrases or draft.values):
        notes.note("Phrases", "The file has no phrases and value lists; those of the draft stay.")
        return Library(intents=intents, values=draft.values, phrases=draft.phrases)
    return Library(
        intents=intents,
        values=_with_kept(file.values, draft.values if keep else ()),
        phrases=_with_kept(file.phrases, draft.phrases if keep else ()),
    )


def _intents(
    new: Iterable[OwlIntent], draft: Library, known: Known[Intent], notes: Notes, *, keep: bool
) -> tuple[Intent, ...]:
    before = places(intent.key for intent in draft.intents)
    rows: dict[str, tuple[Intent, Place]] = {}
    for one in sorted(new, key=lambda one: one.intent.key):
        old = known.old.get(one.intent.key)
        intent = _with_slots(one.intent, old, notes)
        if old:
            intent = _like_the_draft(intent, old, keep=keep)
        number = old.number if old else known.numbers.get(intent.key, 0)
        place = Place(one.order, before[old.key] if old else 0)
        rows[intent.key] = msgspec.structs.replace(intent, number=number), place
    if keep:
        had = {old.key for old in known.old.values()}
        for intent in draft.intents:
            if intent.key not in had:
                rows[intent.key] = intent, Place(before[intent.key], before[intent.key])
    return tuple(rows[key][0] for key in in_order((key, row[1]) for key, row in rows.items()))


def _with_slots(new: Intent, old: Intent | None, notes: Notes) -> Intent:
    """Declare the `{names}` of triggers where a file knows no slots at all."""
    if new.slots or (old and not old.slots and old.triggers == new.triggers):
        return new
    texts = [text for rows in new.triggers.values() for text in rows]
    names = dict.fromkeys(name for text in texts for name in _NAME.findall(text))
    if not names:
        return new
    notes.note(
        new.key,
        f"It declares no slots, so {', '.join(f'{{{name}}}' for name in names)} of its triggers"
        " become slots for a topic or for any words.",
        "Correct hasSlotKind if it is wrong.",
    )
    slots = tuple(Slot(name=name, kind=name if name == "topic" else "text") for name in names)
    return msgspec.structs.replace(new, slots=slots)


def _like_the_draft(new: Intent, old: Intent, *, keep: bool) -> Intent:
    """Return the intent with what is equal but for its order as the draft has it."""
    said = {
        code: _ordered_only(rows, old.plan_sentences.get(code, ()))
        for code, rows in new.plan_sentences.items()
    }
    new = msgspec.structs.replace(new, plan_sentences=said)
    if not keep:
        return new
    return msgspec.structs.replace(
        new,
        abilities=_both(old.abilities, new.abilities),
        triggers=_both(old.triggers, new.triggers),
        plan_sentences=_both(old.plan_sentences, new.plan_sentences),
        tests=_both(old.tests, new.tests),
    )


def _ordered_only(
    new: tuple[PlanSentence, ...], old: tuple[PlanSentence, ...]
) -> tuple[PlanSentence, ...]:
    before = {(one.text, frozenset(one.only)): one.only for one in old}
    return tuple(
        msgspec.structs.replace(
            one, only=same_set(one.only, before.get((one.text, frozenset(one.only)), one.only))
        )
        for one in new
    )


def _both(old: Mapping[str, T], new: Mapping[str, T]) -> dict[str, T]:
    """Return what the file says, and what only the draft has: languages."""
    return {**old, **new}


def _with_kept(new: tuple[ListT, ...], old: tuple[ListT, ...]) -> tuple[ListT, ...]:
    mine = {one.key for one in new}
    return new + tuple(one for one in old if one.key not in mine)
