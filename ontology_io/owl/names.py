"""Local names of the content namespace, both ways: what the writer mints, what the reader takes.

A local name is minted once and never parsed for a fact that a property states (hasCulture,
hasCode); only the keys of topics, intents, phrases and value lists are read from their names.
"""

import hashlib
import re
from collections.abc import Iterable, Mapping

from dialogue.engine.concepts import Knowledge, Topic
from ontology_io.records import KnowledgeBase
from plans.engine.intents import Library

LONGEST_NAME = 150
#: What a local name may be, in a file that is read.
LOCAL_NAME = re.compile(rf"[A-Za-z][A-Za-z0-9_.-]{{0,{LONGEST_NAME - 1}}}")
#: What the key of a topic may be: the local name of its class.
TOPIC_NAME = re.compile(r"[A-Za-z][A-Za-z0-9]{0,99}")
#: What the name of a class variable may be: the local name of its property.
VARIABLE_NAME = re.compile(r"[a-z][a-z_]{0,39}")

CULTURE, LANGUAGE, PATTERN, POOL = "CULTURE_", "LANGUAGE_", "PATTERN_", "POOL_"
INTENT, PHRASE, VALUES = "INTENT_", "PHRASE_", "VALUES_"
PREFIXES = (CULTURE, LANGUAGE, PATTERN, POOL, INTENT, PHRASE, VALUES)


def culture_name(code: str) -> str:
    """Return `CULTURE_EN`."""
    return CULTURE + code


def language_name(code: str) -> str:
    """Return `LANGUAGE_EN` of `en`."""
    return LANGUAGE + code.upper()


def pool_name(code: str) -> str:
    """Return `POOL_START` of `start`."""
    return POOL + code.upper()


def pattern_sequence(pattern: Iterable[str]) -> str:
    """Return the alternatives of a pattern as one text: `q r w c [g] | c q r`."""
    return " | ".join(pattern)


def pattern_name(pattern: Iterable[str]) -> str:
    """Return `PATTERN_` and eight letters that stand for the sequence."""
    sequence = pattern_sequence(pattern).encode()
    return PATTERN + hashlib.sha1(sequence, usedforsecurity=False).hexdigest()[:8]


def intent_name(key: str) -> str:
    """Return `INTENT_playsong`."""
    return INTENT + key


def intent_key(name: str) -> str:
    """Return the key of an intent; one all in capitals (`INTENT_MUSIC`) is read as `music`."""
    key = name.removeprefix(INTENT)
    return key.lower() if key.isupper() else key


def slot_name(intent: str, slot: str) -> str:
    """Return `INTENT_playsong_SLOT_title`."""
    return f"{intent_name(intent)}_SLOT_{slot}"


def plan_name(intent: str, *, on_knowledge: bool) -> str:
    """Return `INTENT_playsong_PLAN`, or `..._KBPLAN` of the plan on the knowledge base."""
    return f"{intent_name(intent)}_{'KBPLAN' if on_knowledge else 'PLAN'}"


def phrase_name(key: str) -> str:
    """Return `PHRASE_please`."""
    return PHRASE + key


def phrase_key(name: str) -> str:
    """Return the key of a phrase."""
    return name.removeprefix(PHRASE)


def list_name(key: str) -> str:
    """Return `VALUES_volume_level`."""
    return VALUES + key


def list_key(name: str) -> str:
    """Return the key of a value list."""
    return name.removeprefix(VALUES)


def topic_id(number: int) -> str:
    """Return `t12`."""
    return f"t{number}"


def frame_id(number: int, language: str) -> str:
    """Return `f12.en`: a frame's sentence in one language."""
    return f"f{number}.{language}"


def intent_id(number: int) -> str:
    """Return `i12`."""
    return f"i{number}"


_IDS: Mapping[str, re.Pattern[str]] = {
    "t": re.compile(r"t([1-9][0-9]{0,9})"),
    "f": re.compile(r"f([1-9][0-9]{0,9})\.[a-z]{2,8}"),
    "i": re.compile(r"i([1-9][0-9]{0,9})"),
}


def number_of(kind: str, text: str) -> int:
    """Return the number of an id of this kind ("t", "f", "i"); 0 where it is not one of ours."""
    found = _IDS[kind].fullmatch(text)
    return int(found[1]) if found else 0


def usual_individual(culture: str, key: str) -> str:
    """Return the name a topic's individual has unless another one is stored: `EN_GREENTEA`."""
    return f"{culture}_{key.upper()}"


class Names:
    """The names of individuals and canonical values within one knowledge base, each only once."""

    def __init__(self, base: KnowledgeBase) -> None:
        self._individuals = individual_names(base.knowledge)
        self._values = value_names(base.library)

    def individual(self, topic: str, culture: str) -> str:
        """Return the name of a topic's individual, "" where it has none in this culture."""
        return self._individuals.get((topic, culture), "")

    def value(self, key: str, canonical: str) -> str:
        """Return the name of a canonical value of a list."""
        return self._values[key, canonical]


def individual_names(knowledge: Knowledge) -> dict[tuple[str, str], str]:
    """Return the name of each individual by topic and culture.

    It is the stored one, else the usual one; where that is taken, `_t<number>` is appended. Of
    several topics the one with the lowest number keeps the usual name.
    """
    taken = _names_of_terms(knowledge)
    topics = sorted(knowledge.topics, key=lambda topic: (topic.number, topic.key))
    names = _stored(topics, taken)
    for topic in topics:
        for culture in sorted(topic.likeliness):
            if (topic.key, culture) not in names:
                names[topic.key, culture] = _usual(topic, culture, taken)
    return names


def _stored(topics: Iterable[Topic], taken: set[str]) -> dict[tuple[str, str], str]:
    """Return the stored names that are free, and take them."""
    names: dict[tuple[str, str], str] = {}
    for topic in topics:
        for culture, name in sorted(topic.individuals.items()):
            if culture in topic.likeliness and _free(name, taken):
                taken.add(name)
                names[topic.key, culture] = name
    return names


def _names_of_terms(knowledge: Knowledge) -> set[str]:
    """Return the names that classes and properties have."""
    names = {topic.key for topic in knowledge.topics}
    for topic in knowledge.topics:
        for texts in topic.variables.values():
            names.update(texts)
    return names


def _usual(topic: Topic, culture: str, taken: set[str]) -> str:
    """Return the first name that is free, and take it."""
    name = usual_individual(culture, topic.key)
    while not _free(name, taken):
        name += f"_t{topic.number}"
        if name not in taken:
            break
    taken.add(name)
    return name


def _free(name: str, taken: set[str]) -> bool:
    return name not in taken and not name.startswith(PREFIXES)


def value_names(library: Library) -> dict[tuple[str, str], str]:
    """Return the name of each canonical value by list and value: `VALUES_volume_1`."""
    taken = {list_name(one.key) for one in library.values}
    names: dict[tuple[str, str], str] = {}
    for one in library.values:
        canonical = dict.fromkeys(value for values in one.values.values() for value in values)
        for place, value in enumerate(canonical, start=1):
            name = f"{list_name(one.key)}_{place}"
            while name in taken:
                name += "_v"
            taken.add(name)
            names[one.key, value] = name
    return names
