"""Everything a worker needs to talk: one immutable value for each publication."""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from dialogue.engine.build import build_tree
from dialogue.engine.concepts import Knowledge, Topic
from dialogue.engine.keywords import KeywordIndex, KeywordRow, build_index
from dialogue.engine.names import name_index
from dialogue.engine.tree import Tree
from languages.known import LANGUAGES
from plans.engine.catalogue import Catalogue, compile_catalogue
from plans.engine.intents import Library

SAME_AS_PARENT = "^"


@dataclass(frozen=True, slots=True)
class Content:
    """What was published: the tree, the intents, the keywords of each language."""

    number: int
    knowledge: Knowledge
    library: Library
    tree: Tree
    catalogue: Catalogue
    keywords: Mapping[str, KeywordIndex]
    names: Mapping[str, Mapping[str, tuple[int, ...]]]

    @property
    def cultures(self) -> tuple[str, ...]:
        """Return the codes of the cultures."""
        return tuple(culture.code for culture in self.knowledge.cultures)


def build_content(knowledge: Knowledge, library: Library, number: int = 0) -> Content:
    """Return the content of a checked knowledge base and library."""
    tree = build_tree(knowledge)
    return Content(
        number=number,
        knowledge=knowledge,
        library=library,
        tree=tree,
        catalogue=compile_catalogue(library),
        keywords=MappingProxyType(
            {
                code: build_index(language, keyword_rows(knowledge, code))
                for code, language in LANGUAGES.items()
            }
        ),
        names=MappingProxyType(
            {code: name_index(tree, language) for code, language in LANGUAGES.items()}
        ),
    )


def keyword_rows(knowledge: Knowledge, language: str) -> list[KeywordRow]:
    """Return the keyword sets of all topics in one language, `^` replaced by the parent's words."""
    topics = {topic.key: topic for topic in knowledge.topics}
    return [
        KeywordRow(
            topic.number,
            _with_parents(topic.keywords[language][0], topic, topics, language),
            _with_parents(topic.keywords[language][1], topic, topics, language),
        )
        for topic in knowledge.topics
        if language in topic.keywords
    ]


def _with_parents(
    words: tuple[str, ...], topic: Topic, topics: Mapping[str, Topic], language: str
) -> tuple[str, ...]:
    if SAME_AS_PARENT not in words:
        return words
    parent = topics.get(topic.is_a)
    above = parent.keywords.get(language, ((), ()))[0] if parent else ()
    return tuple(word for word in (*words, *above) if word != SAME_AS_PARENT)
