"""From the facts to what the file says."""

import msgspec

from ontology_io.owl.facts import Facts, local_name
from ontology_io.owl.file_records import OwlFile
from ontology_io.owl.limits import Limits, refusal
from ontology_io.owl.read_declared import forget_vocabulary, read_head
from ontology_io.owl.read_intents import name_intents, read_intents
from ontology_io.owl.read_lists import read_cultures, read_phrases, read_pools, read_values
from ontology_io.owl.read_persons import drop_persons
from ontology_io.owl.read_structure import Structure
from ontology_io.owl.read_topics import read_topics
from ontology_io.owl.read_values import Reader
from ontology_io.owl.remainder_lines import Remainder


def read_file(facts: Facts, limits: Limits, content: str) -> OwlFile:
    """Return what the file says; OwlError where it is another ontology altogether."""
    persons = drop_persons(facts)
    reader = Reader(facts, limits)
    structure = Structure(reader)
    name_intents(reader)
    if not structure.keys and not reader.intents:
        raise refusal(
            "This is another ontology: it has no class below Topic and no intent.",
            "Begin with an export of this server.",
        )
    structure.check()
    iri, highest = read_head(reader)
    has_pools = bool(facts.typed("Pool"))
    if persons and not (highest or has_pools or reader.intents):
        raise refusal(
            "This file holds the likings of a person, not a knowledge base.",
            "Import an export of this server; what a person likes stays with the person.",
        )
    has_lists = bool(facts.typed("Phrase") or facts.typed("ValueList"))
    file = OwlFile(
        iri=iri,
        cultures=read_cultures(reader),
        topics=read_topics(reader, structure),
        pools=read_pools(reader),
        intents=read_intents(reader),
        phrases=read_phrases(reader),
        values=read_values(reader),
        highest=highest,
        has_pools=has_pools,
        has_lists=has_lists,
        persons=persons,
    )
    return _closed(reader, file, content)


def _closed(reader: Reader, file: OwlFile, content: str) -> OwlFile:
    """Add what is left over, and the problems: errors first, each once."""
    facts = reader.facts
    for node in reader.axioms.without_triple():
        text = "An annotation speaks of a sentence that the file does not have: it is left out."
        facts.warn(node, text)
    forget_vocabulary(facts)
    remainder = Remainder(facts, file.iri, content)
    for key in remainder.unwritable():
        text = "This property cannot be kept: its name does not end in plain letters."
        facts.wrong(local_name(key) or key, text, "Rename it, or remove what it says.")
    problems = dict.fromkeys(sorted(facts.problems, key=lambda one: (not one.error, one.where)))
    return msgspec.structs.replace(
        file,
        remainder=remainder.text(),
        unknown=remainder.counted(),
        problems=tuple(problems),
    )
