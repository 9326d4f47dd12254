"""All lints of content in one go."""

from collections.abc import Collection, Iterable, Iterator

from dialogue.engine.content import Content
from dialogue.engine.findings import Finding
from dialogue.engine.lints.accepted import ACCEPTED, Accepted, without_accepted
from dialogue.engine.lints.classes import lint_classes, lint_leaves
from dialogue.engine.lints.corpus import Corpus, corpus_of, filled_pools, filled_sentences
from dialogue.engine.lints.filled import lint_average, lint_filled
from dialogue.engine.lints.found import lint_names
from dialogue.engine.lints.keywords import lint_keywords
from dialogue.engine.lints.remarks import Remark
from dialogue.engine.lints.repeats import lint_repeats
from dialogue.engine.lints.shape import lint_cultures, lint_shape
from languages.known import LANGUAGES


def lint(corpus: Corpus) -> Iterator[Remark]:
    """Yield what falls short of the bars, but for K2; the knowledge base has no errors.

    Some 50 microseconds a sentence: 4 seconds for 80,000.
    """
    yield from lint_classes(corpus)
    yield from lint_shape(corpus)
    yield from lint_cultures(corpus)
    for language in LANGUAGES:
        yield from lint_keywords(corpus, language)
        filled = filled_sentences(corpus, language)
        yield from lint_leaves(corpus, language, filled)
        yield from lint_average(language, filled)
        yield from lint_repeats(corpus, language, filled)
        yield from lint_filled(corpus, language, (*filled, *filled_pools(corpus, language)))


def lint_content(content: Content, accepted: Collection[Accepted] = ACCEPTED) -> list[Remark]:
    """Return all remarks nobody accepted, K2 with them, by code."""
    corpus = corpus_of(content.knowledge, content.tree)
    remarks = [*lint(corpus), *lint_names(content)]
    return sorted(without_accepted(remarks, accepted), key=lambda remark: remark.code)


def findings_of(remarks: Iterable[Remark]) -> list[Finding]:
    """Return remarks as warnings."""
    return [remark.finding() for remark in remarks]
