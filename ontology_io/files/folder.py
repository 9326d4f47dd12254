"""The folder content/: read whole into a knowledge base, written whole from one."""

import re
from collections.abc import Mapping
from pathlib import Path

import msgspec

from dialogue.engine.concepts import Frame, Knowledge, Topic
from dialogue.engine.tree_order import branches, in_tree_order
from ontology_io.files.intents_files import read_library, write_library
from ontology_io.files.nodes import ContentError, Problems, parse
from ontology_io.files.numbers import Ledger, read_ledger, write_ledger
from ontology_io.files.pools_files import read_cultures, read_pools, write_cultures, write_pools
from ontology_io.files.topics_reader import SECTIONS, Place, read_topics
from ontology_io.files.topics_writer import write_topics
from ontology_io.records import KnowledgeBase
from plans.engine.intents import Intent, Library

CULTURES, POOLS, INTENTS, NUMBERS = "cultures.yaml", "pools.yaml", "intents.yaml", "numbers.tsv"
NOT_BRANCHES = frozenset((CULTURES, POOLS, INTENTS))
#: The intents of the family media stand in intents_media.yaml; phrases and values in intents.yaml.
FAMILY = re.compile(r"intents_([a-z][a-z0-9_]*)\.yaml")
LARGEST_FILE = 2_000_000


class Folder(msgspec.Struct, frozen=True, kw_only=True):
    """What a folder holds: the knowledge base, the last numbers given, and where things stand."""

    base: KnowledgeBase
    last: dict[str, int]
    places: dict[str, tuple[str, int]]


def read_folder(path: Path) -> Folder:
    """Return all that the files say. Raises ContentError with every problem found."""
    reader = _Reader(path)
    folder = reader.read()
    if reader.problems:
        raise ContentError([problem for each in reader.problems for problem in each.found])
    return folder


class _Reader:
    """Reads one folder, collecting problems a file."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.all_problems: list[Problems] = []

    @property
    def problems(self) -> list[Problems]:
        return [problems for problems in self.all_problems if problems.found]

    def read(self) -> Folder:
        cultures = read_cultures(*self._file(CULTURES))
        codes = tuple(culture.code for culture in cultures)
        pools = read_pools(*self._file(POOLS))
        library = self._library()
        ledger = read_ledger(*self._file(NUMBERS))
        topics: list[Topic] = []
        places: dict[str, tuple[str, int]] = {}
        for file in sorted(self.path.glob("*.yaml")):
            if file.name not in NOT_BRANCHES and not FAMILY.fullmatch(file.name):
                text, problems = self._file(file.name)
                found, where = read_topics(text, problems, codes)
                self._twice(where, places, problems)
                topics.extend(found)
                places |= {key: (place.file, place.line) for key, place in where.items()}
        knowledge = Knowledge(
            cultures=cultures,
            topics=in_tree_order(_numbered_topic(topic, ledger) for topic in topics),
            pools={
                name: tuple(_numbered_frame(frame, ledger) for frame in frames)
                for name, frames in pools.items()
            },
        )
        base = KnowledgeBase(knowledge=knowledge, library=_numbered_library(library, ledger))
        return Folder(base=base, last=ledger.last, places=places)

    def _library(self) -> Library:
        """Return the intents of all families, in the order of their files' names."""
        library = read_library(*self._file(INTENTS))
        intents = list(library.intents)
        for file in sorted(self.path.glob("intents_*.yaml")):
            family = FAMILY.fullmatch(file.name)
            if family:
                text, problems = self._file(file.name)
                found = read_library(text, problems, family[1])
                if found.phrases or found.values:
                    problems.add(1, f"Phrases and values stand in {INTENTS}.")
                intents += found.intents
        return msgspec.structs.replace(library, intents=tuple(intents))

    def _file(self, name: str) -> tuple[str, Problems]:
        problems = Problems(f"{self.path.name}/{name}")
        self.all_problems.append(problems)
        try:
            return _text_of(self.path / name), problems
        except FileNotFoundError:
            if name != NUMBERS:
                problems.add(1, "This file is missing.")
        except (OSError, ValueError) as error:
            problems.add(1, f"This file cannot be read: {error}.")
        return "", problems

    def _twice(
        self, where: Mapping[str, Place], places: Mapping[str, tuple[str, int]], problems: Problems
    ) -> None:
        for key, place in where.items():
            if key in places:
                file, line = places[key]
                problems.add(place.line, f"{key} stands in {file}:{line} too.")


def _text_of(path: Path) -> str:
    """Return a file's text, all line ends alike; ValueError where it is too large or no text."""
    with path.open("rb") as file:
        data = file.read(LARGEST_FILE + 1)
    if len(data) > LARGEST_FILE:
        raise ValueError(f"it is larger than {LARGEST_FILE} bytes")
    return data.decode("utf-8-sig").replace("\r\n", "\n").replace("\r", "\n")


def _numbered_topic(topic: Topic, ledger: Ledger) -> Topic:
    return msgspec.structs.replace(
        topic,
        number=ledger.numbers["topic"].get(topic.key, 0),
        frames=tuple(_numbered_frame(frame, ledger) for frame in topic.frames),
    )


def _numbered_frame(frame: Frame, ledger: Ledger) -> Frame:
    number = ledger.numbers["frame"].get(frame.key, 0)
    return msgspec.structs.replace(frame, number=number, slot=ledger.slots.get(frame.key, -1))


def _numbered_library(library: Library, ledger: Ledger) -> Library:
    intents = tuple(
        msgspec.structs.replace(intent, number=ledger.numbers["intent"].get(intent.key, 0))
        for intent in library.intents
    )
    return msgspec.structs.replace(library, intents=intents)


def write_folder(path: Path, base: KnowledgeBase, last: Mapping[str, int]) -> tuple[str, ...]:
    """Write every file; return the names of those whose bytes changed.

    Files of branches and families that are no more go; other YAML files are left alone.
    """
    texts = folder_texts(base, last)
    path.mkdir(parents=True, exist_ok=True)
    changed = []
    for name, text in texts.items():
        file = path / name
        if not file.exists() or file.read_bytes() != text.encode():
            file.write_bytes(text.encode())
            changed.append(name)
    for file in path.glob("*.yaml"):
        if file.name not in texts and (FAMILY.fullmatch(file.name) or _holds_topics(file)):
            file.unlink()
            changed.append(file.name)
    return tuple(changed)


def _holds_topics(file: Path) -> bool:
    problems = Problems(file.name)
    try:
        entries = parse(_text_of(file), problems, SECTIONS)
    except (OSError, ValueError):
        return False
    return bool(entries) and not problems.found


def folder_texts(base: KnowledgeBase, last: Mapping[str, int]) -> dict[str, str]:
    """Return the text of each file by name."""
    knowledge = base.knowledge
    codes = tuple(culture.code for culture in knowledge.cultures)
    classes = frozenset(topic.is_a for topic in knowledge.topics)
    texts = {
        CULTURES: write_cultures(knowledge.cultures),
        POOLS: write_pools(knowledge.pools),
        NUMBERS: write_ledger(_numbers(base), last),
    }
    texts |= _library_texts(base.library)
    for name, topics in _by_file(knowledge).items():
        texts[name] = write_topics(topics, classes, codes)
    return texts


def _library_texts(library: Library) -> dict[str, str]:
    """Return the files of intents: one for each family, one for what all of them use."""
    families: dict[str, list[Intent]] = {"": []}
    for intent in library.intents:
        families.setdefault(intent.family, []).append(intent)
    common = msgspec.structs.replace(library, intents=tuple(families.pop("")))
    return {INTENTS: write_library(common)} | {
        f"intents_{family}.yaml": write_library(Library(intents=tuple(intents)))
        for family, intents in families.items()
    }


def file_name(branch: str) -> str:
    """Return the file of a branch: FoodAndDrink stands in food_and_drink.yaml."""
    stem = re.sub(r"(?<!^)(?=[A-Z])", "_", branch).lower()
    taken = f"{stem}.yaml" in NOT_BRANCHES or FAMILY.fullmatch(f"{stem}.yaml")
    return f"{stem}_topics.yaml" if taken else f"{stem}.yaml"


def _by_file(knowledge: Knowledge) -> dict[str, list[Topic]]:
    """Return the topics of each file; branches such as Tea and tea share one."""
    files: dict[str, list[Topic]] = {}
    branch_of = branches(knowledge.topics)
    for topic in knowledge.topics:
        files.setdefault(file_name(branch_of[topic.key]), []).append(topic)
    return files


def without_number(base: KnowledgeBase) -> list[str]:
    """Return the keys of all that has no number yet."""
    return [key for rows in _numbers(base).values() for key, number, _ in rows if not number]


def _numbers(base: KnowledgeBase) -> dict[str, list[tuple[str, int, int]]]:
    topics = base.knowledge.topics
    frames = [frame for topic in topics for frame in topic.frames]
    frames += [frame for pool in base.knowledge.pools.values() for frame in pool]
    return {
        "topic": [(topic.key, topic.number, -1) for topic in topics],
        "frame": [(frame.key, frame.number, frame.slot) for frame in frames],
        "intent": [(intent.key, intent.number, -1) for intent in base.library.intents],
    }
