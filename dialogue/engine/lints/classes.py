"""C2 and C3: every class says enough of every kind, and so does every leaf."""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping

from dialogue.engine.lints.corpus import Corpus, Filled
from dialogue.engine.lints.remarks import Remark
from dialogue.engine.saying import NEVER_WHEN_GENTLE
from dialogue.engine.sentence_types import REACTION
from dialogue.engine.tree import Node
from languages.known import LANGUAGES

#: How many sentences of each type a class, a gentle class and a branch need.
CLASS_NEEDS: Mapping[str, int] = {"q": 3, "p": 2, "n": 2, "w": 3, "c": 2, "g": 2, "t": 1}
GENTLE_NEEDS: Mapping[str, int] = {"c": 4, "w": 3}
BRANCH_NEEDS: Mapping[str, int] = dict.fromkeys("qpnwc", 2)
LEAST_DISTINCT, LEAST_GENTLE = 12, 7


def lint_classes(corpus: Corpus) -> Iterator[Remark]:
    """Yield C3 for each class and branch that lacks sentences of a type in a language."""
    for node in corpus.classes:
        yield from _lacking(corpus, node, GENTLE_NEEDS if node.gentle else CLASS_NEEDS)
    for number in corpus.tree.branches:
        yield from _lacking(corpus, corpus.tree.nodes[number], BRANCH_NEEDS)


def lacks(corpus: Corpus, node: Node, language: str, needs: Mapping[str, int]) -> dict[str, int]:
    """Return how many sentences of each type are missing: {"g": 1}; {} where all are there."""
    said = Counter(
        frame.type for frame in corpus.everyones(node) if frame.texts.get(language, "").strip()
    )
    return {letter: need - said[letter] for letter, need in needs.items() if said[letter] < need}


def _lacking(corpus: Corpus, node: Node, needs: Mapping[str, int]) -> Iterator[Remark]:
    by_lack: dict[str, list[str]] = {}
    for language in LANGUAGES:
        missing = lacks(corpus, node, language, needs)
        if missing:
            text = " ".join(f"{count}{letter}" for letter, count in missing.items())
            by_lack.setdefault(text, []).append(language)
    wanted = " ".join(f"{count}{letter}" for letter, count in needs.items())
    for text, languages in by_lack.items():
        for language in languages if len(languages) < len(LANGUAGES) else ("",):
            yield Remark(
                "C3", node.key, f"It lacks {text}.", f"Write {wanted} for everybody.", language
            )


def lint_leaves(corpus: Corpus, language: str, filled: Iterable[Filled]) -> Iterator[Remark]:
    """Yield C2 for each leaf with too few different sentences, or without a type it needs."""
    distinct = distinct_of_leaves(corpus, filled)
    for leaf in corpus.leaves:
        least = LEAST_GENTLE if leaf.gentle else LEAST_DISTINCT
        count = len(distinct.get(leaf.key, ()))
        if count < least:
            hint = f"Its class or itself should give it {least}."
            yield Remark("C2", leaf.key, f"It has {count} different sentences.", hint, language)
        silent = sorted(_needed(leaf) - _sayable(leaf, language))
        if silent:
            message = f"Its pattern asks for {' '.join(silent)}, but it has no such sentence."
            yield Remark("C2", leaf.key, message, "Write one, or change the pattern.", language)


def distinct_of_leaves(corpus: Corpus, filled: Iterable[Filled]) -> dict[str, set[str]]:
    """Return the different sentences that everybody can hear about each leaf, by key."""
    leaves = {leaf.key for leaf in corpus.leaves}
    found: dict[str, set[str]] = {}
    for node, line, text in filled:
        if node.key in leaves and not line.only and _is_said(node, line.type):
            found.setdefault(node.key, set()).add(text)
    return found


def _is_said(node: Node, letter: str) -> bool:
    return not (node.gentle and letter in NEVER_WHEN_GENTLE)


def _needed(leaf: Node) -> set[str]:
    """Return the types that a pattern of the leaf names and does not allow to be left out."""
    steps = {letter for pattern in leaf.patterns for letter, optional in pattern if not optional}
    return (steps - {REACTION}) | ({"p", "n"} if REACTION in steps else set())


def _sayable(leaf: Node, language: str) -> set[str]:
    return {
        letter
        for letter, lines in leaf.lines.items()
        if _is_said(leaf, letter)
        and any(language in line.templates and not line.only for line in lines)
    }
