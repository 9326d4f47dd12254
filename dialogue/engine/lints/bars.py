"""The table of the quality bars: what is aimed at, what the content reaches."""

from collections import Counter
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from dialogue.engine.content import Content
from dialogue.engine.lints.accepted import without_accepted
from dialogue.engine.lints.classes import (
    BRANCH_NEEDS,
    CLASS_NEEDS,
    GENTLE_NEEDS,
    LEAST_DISTINCT,
    LEAST_GENTLE,
    distinct_of_leaves,
    lacks,
)
from dialogue.engine.lints.corpus import Corpus, corpus_of, filled_sentences
from dialogue.engine.lints.filled import MOST_ON_AVERAGE, UNITS, average_length
from dialogue.engine.lints.found import LEAST_FOUND, lost_topics
from dialogue.engine.lints.keywords import MOST_WILDCARDS, shared_pairs, wildcard_share
from dialogue.engine.lints.lint import lint
from dialogue.engine.lints.remarks import percent
from dialogue.engine.lints.repeats import (
    MOST_REPEATED,
    MOST_WITHOUT_GAP,
    repeated_share,
    too_bare,
)
from dialogue.engine.lints.shape import (
    DEEPEST,
    LARGEST_CLASS,
    LEAST_AT_HOME,
    LEAST_OWN_LINES,
    LEAST_TOGETHER,
    MOST_ALIKE,
    SHALLOWEST,
    at_home,
    complete_leaves,
    depth,
    leaves_apart,
    likeness,
    own_lines,
)
from languages.known import LANGUAGES

LEAST_LEAVES, LEAST_SENTENCES = 3000, 20000


class Bar(NamedTuple):
    """One row: the bar's id, what it measures, its target, the figure, whether it is met.

    `met` is None for what is only counted.
    """

    id: str
    what: str
    target: str
    figure: str
    met: bool | None = None


def bars(content: Content) -> list[Bar]:
    """Return the rows of all bars, the counts first; takes as long as all lints together."""
    corpus = corpus_of(content.knowledge, content.tree)
    rows = [*_counts(corpus), *_of_classes(corpus), *_of_keywords(corpus, content)]
    for language in LANGUAGES:
        rows += _of_sentences(corpus, language)
    rows += [*_of_remarks(corpus), *_of_shape(corpus), *_of_cultures(corpus)]
    first = [row for row in rows if row.met is None]
    return first + sorted([row for row in rows if row.met is not None], key=lambda row: row.id)


def markdown(rows: Iterable[Bar]) -> str:
    """Return the rows as a table."""
    met = {True: "yes", False: "**no**", None: ""}
    lines = ["| Bar | What | Target | Figure | Met |", "|---|---|---|---|---|"]
    lines += [f"| {' | '.join((*row[:4], met[row.met]))} |" for row in rows]
    return "\n".join(lines) + "\n"


def _counts(corpus: Corpus) -> Iterator[Bar]:
    topics, leaves, classes = corpus.knowledge.topics, corpus.leaves, corpus.classes
    branches = corpus.tree.branches
    inner = sum(not node.is_leaf for node in corpus.tree.nodes.values())
    yield Bar("", "topics", "", str(len(topics)))
    yield Bar("", "branches", "", str(len(branches)))
    yield Bar("", "groups", "", str(inner - len(branches) - len(classes)))
    yield Bar("", "classes", "", str(len(classes)))
    yield Bar("", "leaves", "", str(len(leaves)))
    done = complete_leaves(corpus)
    what = "leaves with names, keywords, likeliness and 2 links"
    yield Bar("C1", what, f">= {LEAST_LEAVES}", str(done), done >= LEAST_LEAVES)


def _of_classes(corpus: Corpus) -> Iterator[Bar]:
    wanted = [(node, GENTLE_NEEDS if node.gentle else CLASS_NEEDS) for node in corpus.classes]
    wanted += [(corpus.tree.nodes[number], BRANCH_NEEDS) for number in corpus.tree.branches]
    full = sum(
        not any(lacks(corpus, node, language, needs) for language in LANGUAGES)
        for node, needs in wanted
    )
    what = "classes and branches with every type of sentence"
    yield Bar("C3", what, "all", f"{full} of {len(wanted)}", full == len(wanted))


def _of_sentences(corpus: Corpus, language: str) -> Iterator[Bar]:
    filled = filled_sentences(corpus, language)
    different = len({one.text for one in filled})
    yield _least("C2", f"different sentences ({language})", different, LEAST_SENTENCES)
    said = distinct_of_leaves(corpus, filled)
    rich = sum(
        len(said.get(leaf.key, ())) >= (LEAST_GENTLE if leaf.gentle else LEAST_DISTINCT)
        for leaf in corpus.leaves
    )
    what = f"leaves with {LEAST_DISTINCT} sentences, gentle ones {LEAST_GENTLE} ({language})"
    yield Bar("C2", what, "all", f"{rich} of {len(corpus.leaves)}", rich == len(corpus.leaves))
    yield _most(
        "U1", f"said of another topic too ({language})", repeated_share(filled), MOST_REPEATED
    )
    bare = len(too_bare(corpus, language))
    what = f"classes with more than {MOST_WITHOUT_GAP:.0f} % without a gap ({language})"
    yield Bar("U1", what, "0", str(bare), bare == 0)
    mean, most = average_length(language, filled), MOST_ON_AVERAGE[language]
    what = f"average length in {UNITS[language]} ({language})"
    yield Bar("S1", what, f"<= {most}", f"{mean:.1f}", mean <= most)


def _of_remarks(corpus: Corpus) -> Iterator[Bar]:
    """Yield how many remarks the lints of words have that nobody accepted."""
    counted = Counter((one.code, one.language) for one in without_accepted(lint(corpus)))
    for code, what in (
        ("G2", "Italian articles and agreement"),
        ("G3", "English articles and agreement"),
        ("G4", "Japanese particles and manners"),
        ("G5", "endings and single questions"),
        ("S1", "lengths, signs and readability"),
        ("P1", "words a robot avoids"),
    ):
        for language in LANGUAGES:
            count = counted[code, language]
            if count or code in ("G5", "S1", "P1"):
                yield Bar(code, f"remarks: {what} ({language})", "0", str(count), count == 0)


def _of_keywords(corpus: Corpus, content: Content) -> Iterator[Bar]:
    lost = Counter(one.language for one in lost_topics(content))
    for language in LANGUAGES:
        shared = len(shared_pairs(corpus, language))
        yield Bar("K1", f"keywords of two topics ({language})", "0", str(shared), shared == 0)
        share = wildcard_share(corpus, language)
        yield _most("K1", f"topics found by one word ({language})", share, MOST_WILDCARDS)
        topics = len(corpus.knowledge.topics)
        found = percent(topics - lost[language], topics)
        what = f"topics found by their own names ({language})"
        yield Bar("K2", what, f">= {LEAST_FOUND:.0f} %", f"{found:.1f} %", found >= LEAST_FOUND)


def _of_shape(corpus: Corpus) -> Iterator[Bar]:
    depths = [depth(leaf) for leaf in corpus.leaves] or [0]
    least, most = min(depths), max(depths)
    met = least >= SHALLOWEST and most <= DEEPEST
    yield Bar("T1", "how deep leaves lie", f"{SHALLOWEST} to {DEEPEST}", f"{least} to {most}", met)
    sizes = [len(corpus.leaves_of(node)) for node in corpus.classes] or [0]
    figure, met = f"{min(sizes)} to {max(sizes)}", min(sizes) > 1 and max(sizes) <= LARGEST_CLASS
    yield Bar("T1", "leaves of a class", f"2 to {LARGEST_CLASS}", figure, met)
    ends = sum(not corpus.tree.siblings(leaf) and not leaf.links for leaf in corpus.leaves)
    yield Bar("T1", "dead ends", "0", str(ends), ends == 0)
    leaves = len(corpus.leaves)
    together = percent(leaves - len(leaves_apart(corpus)), leaves)
    target = f">= {LEAST_TOGETHER:.0f} %"
    met = together >= LEAST_TOGETHER
    yield Bar("T1", "leaves that lead to one another", target, f"{together:.1f} %", met)


def _of_cultures(corpus: Corpus) -> Iterator[Bar]:
    codes = [culture.code for culture in corpus.knowledge.cultures]
    nodes = corpus.tree.nodes
    shares = [
        share
        for number in corpus.tree.branches
        for share in at_home(corpus, nodes[number], codes).values()
    ]
    least = min(shares, default=0.0)
    what = "leaves most at home in a culture, in its poorest branch"
    target, met = f">= {LEAST_AT_HOME:.0f} %", least >= LEAST_AT_HOME
    yield Bar("L1", what, target, f"{least:.1f} %", met)
    for one, other, value in likeness(corpus):
        met = 0 < value < MOST_ALIKE
        what = f"rank correlation of {one} and {other}"
        yield Bar("L1", what, f"0 to {MOST_ALIKE}", f"{value:.2f}", met)
    for code, count in own_lines(corpus).items():
        yield _least("L1", f"sentences for {code} alone", count, LEAST_OWN_LINES)


def _least(code: str, what: str, figure: int, least: int) -> Bar:
    return Bar(code, what, f">= {least}", str(figure), figure >= least)


def _most(code: str, what: str, figure: float, most: float) -> Bar:
    return Bar(code, what, f"<= {most:.0f} %", f"{figure:.1f} %", figure <= most)
