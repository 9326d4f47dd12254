"""Check the intents, and that every proposal offers one of them."""

from collections.abc import Iterator, Mapping

import msgspec

from dialogue.engine.concepts import Frame, Knowledge
from dialogue.engine.findings import Finding
from dialogue.engine.lines import parse_proposal
from dialogue.engine.tree import Proposal
from plans.engine.catalogue import LibraryError, compile_catalogue
from plans.engine.intents import Intent, Library


def check_library(knowledge: Knowledge, library: Library) -> list[Finding]:
    """Return all findings; those with `error` stop loading and publishing."""
    try:
        compile_catalogue(_with_numbers(library))
    except LibraryError as error:
        return [
            Finding("P001", problem.where, str(problem), "Correct it at that place.")
            for problem in error.problems
        ]
    return list(_check_proposals(knowledge, library))


def _with_numbers(library: Library) -> Library:
    """Return the library with passing numbers for what gets its real one when it is written."""
    replace = msgspec.structs.replace
    intents = tuple(
        intent if intent.number else replace(intent, number=-place)
        for place, intent in enumerate(library.intents, 1)
    )
    return replace(library, intents=intents)


def _check_proposals(knowledge: Knowledge, library: Library) -> Iterator[Finding]:
    intents = {intent.key: intent for intent in library.intents}
    for topic in knowledge.topics:
        for frame in topic.frames:
            proposal = _proposal(frame)
            if proposal:
                yield from _check_offer(frame.key, proposal, intents)


def _proposal(frame: Frame) -> Proposal | None:
    try:
        return parse_proposal(frame.do) if frame.do else None
    except ValueError:  # D018 says so.
        return None


def _check_offer(key: str, proposal: Proposal, intents: Mapping[str, Intent]) -> Iterator[Finding]:
    intent = intents.get(proposal.intent)
    if intent is None:
        yield Finding(
            "D025",
            key,
            f"It offers {proposal.intent!r}, but there is no such intent.",
            f"Use one of {', '.join(sorted(intents))}.",
        )
        return
    names = {slot.name for slot in intent.slots}
    for name, _ in proposal.parameters:
        if name not in names:
            yield Finding(
                "D026",
                key,
                f"The intent {proposal.intent} has no {name!r}.",
                f"It knows {', '.join(sorted(names)) or 'no parameters'}.",
            )
