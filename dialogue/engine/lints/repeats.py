"""U1: what is said about one topic is not word for word what is said about another."""

from collections.abc import Iterable, Iterator

from dialogue.engine.concepts import Frame
from dialogue.engine.lints.corpus import Corpus, Filled
from dialogue.engine.lints.remarks import Remark, first_of, percent, some
from dialogue.engine.tree import Node

MOST_REPEATED, MOST_WITHOUT_GAP = 2.0, 10.0  # percent
_WORST = 5
_TELLING = 90.0  # percent of different values


def lint_repeats(corpus: Corpus, language: str, filled: tuple[Filled, ...]) -> Iterator[Remark]:
    """Yield the worst repeated texts, the same text written twice, and classes without gaps."""
    yield from _written_twice(corpus, language)
    yield from _without_gap(corpus, language)
    share = repeated_share(filled)
    if share > MOST_REPEATED:
        for text, keys, where in _worst(filled):
            message = f"‘{text}’ is said of {len(keys)} topics: {some(keys)}."
            hint = f"{share:.1f} % of what is said is repeated; at most {MOST_REPEATED:.0f} %."
            yield Remark("U1", where, message, hint, language)


def repeated_share(filled: Iterable[Filled]) -> float:
    """Return how much of what is said, in percent, was said of another topic word for word.

    Hard subjects do not count: what comforts in one grief may comfort in another.
    """
    said = {(one.node.key, one.text) for one in filled if not one.node.gentle}
    return percent(len(said) - len({text for _, text in said}), len(said))


def _worst(filled: Iterable[Filled]) -> list[tuple[str, list[str], str]]:
    topics: dict[str, list[str]] = {}
    lines: dict[str, str] = {}
    for node, line, text in filled:
        if not node.gentle:
            topics.setdefault(text, []).append(node.key)
            lines.setdefault(text, line.key)
    worst = sorted(topics, key=lambda text: -len(topics[text]))[:_WORST]
    return [(text, first_of(topics[text]), lines[text]) for text in worst]


def _written_twice(corpus: Corpus, language: str) -> Iterator[Remark]:
    """Yield each sentence that an earlier topic has word for word, gaps and all."""
    owners: dict[str, Frame] = {}
    for topic in corpus.knowledge.topics:
        for frame in topic.frames:
            text = frame.texts.get(language, "").strip()
            first = owners.setdefault(text, frame) if text else frame
            if first is not frame:
                message = f"‘{text}’ is also {first.key}."
                hint = "Find the words that fit this topic only."
                yield Remark("U1", frame.key, message, hint, language)


def without_gap(corpus: Corpus, node: Node, language: str) -> tuple[int, int]:
    """Return how many of a class's sentences name nothing, and how many it has.

    A variable names a topic where nearly every leaf has a value of its own: "in a bookshop".
    """
    frames = corpus.everyones(node)
    texts = [text for frame in frames if (text := frame.texts.get(language, "").strip())]
    naming = ("$hasName", "$toName", *_telling(corpus, node, language))
    return sum(not any(name in text for name in naming) for text in texts), len(texts)


def _telling(corpus: Corpus, node: Node, language: str) -> list[str]:
    """Return the variables that tell the leaves of a class apart."""
    leaves = [leaf.variables.get(language, {}) for leaf in corpus.leaves_of(node)]
    names = {name for variables in leaves for name in variables}
    return [
        f"${name}"
        for name in sorted(names)
        if percent(len({one.get(name, "") for one in leaves}), len(leaves)) >= _TELLING
    ]


def too_bare(corpus: Corpus, language: str) -> list[tuple[Node, int, int]]:
    """Return the classes too many of whose sentences name nothing, with both counts."""
    found = [(node, *without_gap(corpus, node, language)) for node in corpus.classes]
    return [
        (node, bare, count)
        for node, bare, count in found
        if not node.gentle and percent(bare, count) > MOST_WITHOUT_GAP
    ]


def _without_gap(corpus: Corpus, language: str) -> Iterator[Remark]:
    for node, bare, count in too_bare(corpus, language):
        message = f"{bare} of its {count} sentences do not name the topic."
        hint = f"At most {MOST_WITHOUT_GAP:.0f} % may: they are the same for every topic below it."
        yield Remark("U1", node.key, message, hint, language)
