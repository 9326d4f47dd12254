"""The content as the lints read it: topics, leaves, classes, and every sentence filled."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

from dialogue.engine.build import build_tree
from dialogue.engine.concepts import Frame, Knowledge, Topic
from dialogue.engine.tree import ON_YOUR_MIND, Line, Node, Tree
from languages.templates import TemplateError


class Filled(NamedTuple):
    """A sentence as it is said of a topic in one language."""

    node: Node
    line: Line
    text: str


@dataclass(frozen=True)
class Corpus:
    """A checked knowledge base with its tree."""

    knowledge: Knowledge
    tree: Tree

    @cached_property
    def topics(self) -> dict[str, Topic]:
        """Return the topics by key."""
        return {topic.key: topic for topic in self.knowledge.topics}

    @cached_property
    def leaves(self) -> tuple[Node, ...]:
        """Return the topics with nothing below them, in tree order.

        The topic for listening is none: it stands for whatever the person has on their mind.
        """
        nodes = self.tree.nodes.values()
        return tuple(node for node in nodes if node.is_leaf and node.key != ON_YOUR_MIND)

    @cached_property
    def classes(self) -> tuple[Node, ...]:
        """Return the topics that hand sentences down to leaves.

        A branch is none, nor a group that only orders classes, nor a subgroup inside a class.
        """
        return tuple(node for node in self.tree.nodes.values() if self._is_class(node))

    @cached_property
    def class_of(self) -> dict[str, Node]:
        """Return the class of each leaf, by key; leaves outside of all classes are left out."""
        numbers = {node.number: node for node in self.classes}
        found = {}
        for leaf in self.leaves:
            above = [numbers[number] for number in leaf.ancestors if number in numbers]
            if above:
                found[leaf.key] = above[0]
        return found

    def leaves_of(self, node: Node) -> list[Node]:
        """Return the leaves of a class."""
        return [leaf for leaf in self.leaves if self.class_of.get(leaf.key) is node]

    def branch_of(self, node: Node) -> str:
        """Return the key of the branch a topic lies in."""
        return self.tree.nodes[node.branch].key

    def everyones(self, node: Node) -> list[Frame]:
        """Return a topic's own frames that people of all cultures hear."""
        return [frame for frame in self.topics[node.key].frames if not frame.only]

    def _is_class(self, node: Node) -> bool:
        if node.is_leaf or not node.ancestors:
            return False
        if self._has_asking(node):
            return True
        has_leaves = any(self.tree.nodes[number].is_leaf for number in node.children)
        groups_above = (self.tree.nodes[number] for number in node.ancestors[:-1])
        return has_leaves and not any(self._has_asking(above) for above in groups_above)

    def _has_asking(self, node: Node) -> bool:
        return any(frame.type in ("q", "w") for frame in self.everyones(node))


def corpus_of(knowledge: Knowledge, tree: Tree | None = None) -> Corpus:
    """Return the corpus of a knowledge base without errors; ValueError where one is left."""
    return Corpus(knowledge, tree or build_tree(knowledge))


def filled_sentences(corpus: Corpus, language: str) -> tuple[Filled, ...]:
    """Return every sentence of every topic in a language, some 25 for each topic."""
    nodes = corpus.tree.nodes
    return tuple(
        filled
        for node in nodes.values()
        for filled in _filled_of(node, nodes[node.branch], language)
    )


def _filled_of(node: Node, following: Node, language: str) -> Iterator[Filled]:
    if language not in node.names or language not in following.names:
        return
    names = {"hasName": node.names[language], "toName": following.names[language]}
    variables = node.variables.get(language, {})
    for lines in node.lines.values():
        for line in lines:
            template = line.templates.get(language)
            if template is None:
                continue
            try:
                yield Filled(node, line, template.fill(names, variables))
            except TemplateError:  # D022 says so.
                continue


def filled_pools(corpus: Corpus, language: str) -> tuple[Filled, ...]:
    """Return every pool sentence, said of the topic whose name is longest and of its branch."""
    named = [node for node in corpus.leaves if language in node.names]
    if not named:
        return ()
    node = max(named, key=lambda one: len(one.names[language].forms[""]))
    following = corpus.tree.nodes[node.branch]
    names = {name: one.names[language] for name, one in (("hasName", node), ("toName", following))}
    filled = []
    for lines in corpus.tree.pools.values():
        for line in lines:
            template = line.templates.get(language)
            if template is not None:
                words = dict.fromkeys(template.variables, names["hasName"].forms["bare"])
                filled.append(Filled(node, line, template.fill(names, words)))
    return tuple(filled)
