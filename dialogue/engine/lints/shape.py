"""C1, T1 and L1: the shape of the tree, its links, and how the cultures differ."""

from collections import Counter
from collections.abc import Iterator
from itertools import combinations

from dialogue.engine.concepts import ROOT
from dialogue.engine.lints.corpus import Corpus
from dialogue.engine.lints.graph import reachable_together
from dialogue.engine.lints.ranks import rank_correlation
from dialogue.engine.lints.remarks import Remark, percent, some
from dialogue.engine.tree import Node
from languages.known import LANGUAGES

LEAST_LINKS = 2
SHALLOWEST, DEEPEST = 3, 6
LARGEST_CLASS = 100
LEAST_TOGETHER = 95.0  # percent of the leaves
LEAST_AT_HOME = 10.0  # percent of the leaves of a branch
MOST_ALIKE = 0.9
LEAST_OWN_LINES = 300


def lint_shape(corpus: Corpus) -> Iterator[Remark]:
    """Yield what is wrong with the tree: C1 and T1."""
    yield from _lint_leaves(corpus)
    for node in corpus.classes:
        count = len(corpus.leaves_of(node))
        if count <= 1 or count > LARGEST_CLASS:
            hint = f"A class has 2 to {LARGEST_CLASS} leaves."
            yield Remark("T1", node.key, f"It has {count} leaves.", hint)
    apart = leaves_apart(corpus)
    share = percent(len(corpus.leaves) - len(apart), len(corpus.leaves))
    if corpus.leaves and share < LEAST_TOGETHER:
        message = f"{share:.0f} % of the leaves lead to one another. Not: {some(apart)}."
        yield Remark("T1", ROOT, message, "Link them with other branches, both ways.")


def _lint_leaves(corpus: Corpus) -> Iterator[Remark]:
    for leaf in corpus.leaves:
        missing = _missing(corpus, leaf)
        if missing:
            yield Remark("C1", leaf.key, f"It lacks {', '.join(missing)}.", "Add them.")
        if not SHALLOWEST <= depth(leaf) <= DEEPEST:
            hint = f"Leaves lie {SHALLOWEST} to {DEEPEST} below the root."
            yield Remark("T1", leaf.key, f"It lies {depth(leaf)} below the root.", hint)
        if not corpus.tree.siblings(leaf) and not leaf.links:
            yield Remark("T1", leaf.key, "Nothing leads on from it.", "Link it to another topic.")


def depth(leaf: Node) -> int:
    """Return how far below the root a topic lies; a branch lies 1 below."""
    return len(leaf.ancestors) + 1


def _missing(corpus: Corpus, leaf: Node) -> list[str]:
    """Return what a leaf must have and has not, in words."""
    topic = corpus.topics[leaf.key]
    missing = [
        f"keywords in {language}"
        for language in LANGUAGES
        if not any(topic.keywords.get(language, ()))
    ]
    missing += [
        f"a likeliness in {culture.code}"
        for culture in corpus.knowledge.cultures
        if culture.code not in topic.likeliness
    ]
    if len(leaf.links) < LEAST_LINKS:
        missing.append(f"{LEAST_LINKS - len(leaf.links)} of {LEAST_LINKS} links")
    return missing


def complete_leaves(corpus: Corpus) -> int:
    """Return how many leaves have all that a leaf must have."""
    return sum(not _missing(corpus, leaf) for leaf in corpus.leaves)


def leaves_apart(corpus: Corpus) -> list[str]:
    """Return the leaves outside the largest set in which each leads to each other one.

    A leaf leads to its siblings and links; a class leads to what lies below it.
    """
    nodes = corpus.tree.nodes
    edges = {
        number: (*corpus.tree.siblings(node), *node.links) if node.is_leaf else node.children
        for number, node in nodes.items()
    }
    leaves = [leaf.number for leaf in corpus.leaves]
    together = reachable_together(edges, leaves)
    return [nodes[number].key for number in leaves if number not in together]


def lint_cultures(corpus: Corpus) -> Iterator[Remark]:
    """Yield what is wrong with the balance of the cultures: L1."""
    codes = [culture.code for culture in corpus.knowledge.cultures]
    for number in corpus.tree.branches:
        branch = corpus.tree.nodes[number]
        for code, share in at_home(corpus, branch, codes).items():
            if share < LEAST_AT_HOME:
                message = f"{share:.0f} % of its leaves are most at home in {code}."
                hint = f"Give each culture {LEAST_AT_HOME:.0f} % of a branch."
                yield Remark("L1", branch.key, message, hint)
    for one, other, value in likeness(corpus):
        if not 0 < value < MOST_ALIKE:
            message = f"What {one} and {other} like is ranked alike by {value:.2f}."
            yield Remark("L1", ROOT, message, f"Between 0 and {MOST_ALIKE} is true to life.")
    for code, count in own_lines(corpus).items():
        if count < LEAST_OWN_LINES:
            message = f"{code} has {count} sentences of its own."
            yield Remark("L1", ROOT, message, f"Write {LEAST_OWN_LINES} (only: [{code}]).")


def at_home(corpus: Corpus, branch: Node, codes: list[str]) -> dict[str, float]:
    """Return how many leaves of a branch, in percent, each culture likes best of all."""
    leaves = [leaf for leaf in corpus.leaves if leaf.branch == branch.number]
    best = Counter(_best_culture(leaf) for leaf in leaves)
    return {code: percent(best[code], len(leaves)) for code in codes} if leaves else {}


def _best_culture(leaf: Node) -> str:
    """Return the culture that likes a topic best, "" where several do."""
    most = max(leaf.likeliness.values(), default=0.0)
    best = [code for code, value in leaf.likeliness.items() if value == most]
    return best[0] if len(best) == 1 else ""


def likeness(corpus: Corpus) -> list[tuple[str, str, float]]:
    """Return how alike two cultures rank the leaves: 1 the same, 0 unrelated, -1 opposite."""
    values = {
        culture.code: [leaf.likeliness.get(culture.code, 0.5) for leaf in corpus.leaves]
        for culture in corpus.knowledge.cultures
    }
    return [
        (one, other, rank_correlation(values[one], values[other]))
        for one, other in combinations(values, 2)
    ]


def own_lines(corpus: Corpus) -> dict[str, int]:
    """Return how many sentences of topics each culture has for itself, in all languages."""
    counts = dict.fromkeys([culture.code for culture in corpus.knowledge.cultures], 0)
    for topic in corpus.knowledge.topics:
        for frame in topic.frames:
            if all(frame.texts.get(language, "").strip() for language in LANGUAGES):
                counts |= {code: counts[code] + 1 for code in frame.only if code in counts}
    return counts
