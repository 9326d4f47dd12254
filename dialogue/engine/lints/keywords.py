"""K1: keywords lead to one topic, and single words only where they are safe."""

import re
from collections.abc import Iterable, Iterator, Mapping
from itertools import product

from dialogue.engine.concepts import ROOT, Topic
from dialogue.engine.content import keyword_rows
from dialogue.engine.keywords import ANYTHING, KeywordRow
from dialogue.engine.lints.corpus import Corpus
from dialogue.engine.lints.remarks import Remark, percent, some
from languages.known import LANGUAGES

MOST_WILDCARDS = 40.0  # percent of the topics
LEAST_LETTERS = 4

#: Words that mean two things: two topics may own them, none of them by the word alone.
HOMOGRAPHS: Mapping[str, frozenset[str]] = {
    "en": frozenset({"date", "orange", "turkey", "china"}),
    "it": frozenset({"calcio", "riso", "tempo", "piano", "pesca"}),
    "ja": frozenset({"くも", "かき", "はし"}),
}
_ONE_KANA = re.compile("[ぁ-ゖァ-ヺー]")

Pair = tuple[str, ...]


def lint_keywords(corpus: Corpus, language: str) -> Iterator[Remark]:
    """Yield shared keywords, homographs and short words that stand alone, too many wildcards."""
    rows = keyword_rows(corpus.knowledge, language)
    yield from _shared(corpus, rows, language)
    for row in rows:
        if _is_wildcard(row):
            yield from _unsafe(corpus, row, language)
    share = wildcard_share(corpus, language)
    if share > MOST_WILDCARDS:
        message = f"{share:.0f} % of the topics are found by one word alone."
        hint = f"At most {MOST_WILDCARDS:.0f} %: give the others a second word."
        yield Remark("K1", ROOT, message, hint, language)


def wildcard_share(corpus: Corpus, language: str) -> float:
    """Return how many topics, in percent, one keyword alone leads to."""
    rows = keyword_rows(corpus.knowledge, language)
    topics = {row.topic for row in rows if _is_wildcard(row)}
    return percent(len(topics), len(corpus.knowledge.topics))


def shared_pairs(corpus: Corpus, language: str) -> dict[Pair, list[str]]:
    """Return the keyword pairs that lead to several topics, with the keys of those."""
    return _owned_twice(corpus, keyword_rows(corpus.knowledge, language), language)


def _owned_twice(
    corpus: Corpus, rows: Iterable[KeywordRow], language: str
) -> dict[Pair, list[str]]:
    owners: dict[Pair, dict[str, None]] = {}
    for row in rows:
        key = corpus.tree.nodes[row.topic].key
        for pair in _pairs(row, language):
            owners.setdefault(pair, {})[key] = None
    declared = HOMOGRAPHS[language]
    return {
        pair: list(keys)
        for pair, keys in owners.items()
        if len(keys) > 1 and not declared.intersection(pair)
    }


def _spelled(word: str, language: str) -> str:
    known = LANGUAGES[language]
    return (" " if known.spaced else "").join(token.text for token in known.tokens(word))


def _pairs(row: KeywordRow, language: str) -> Iterator[Pair]:
    first, second = (
        [_spelled(word, language) for word in words if word != ANYTHING]
        for words in (row.first, row.second)
    )
    if _is_wildcard(row):
        yield from ((word,) for word in (*first, *second))
    else:
        # The order in a sentence does not matter: "tea, green" is "green tea".
        yield from (tuple(sorted(pair)) for pair in product(first, second))


def _is_wildcard(row: KeywordRow) -> bool:
    return ANYTHING in row.first or ANYTHING in row.second


def _shared(corpus: Corpus, rows: list[KeywordRow], language: str) -> Iterator[Remark]:
    pairs_of: dict[tuple[str, ...], list[str]] = {}
    for pair, keys in _owned_twice(corpus, rows, language).items():
        pairs_of.setdefault(tuple(keys), []).append(" + ".join(pair))
    for (first, *others), words in pairs_of.items():
        message = f"‘{some(words)}’ leads to {some([first, *others])}."
        yield Remark("K1", others[0], message, "Let one topic own the words.", language)


def _unsafe(corpus: Corpus, row: KeywordRow, language: str) -> Iterator[Remark]:
    node = corpus.tree.nodes[row.topic]
    names = _own_words(corpus.topics[node.key], language)
    words = [word for word in (*row.first, *row.second) if word != ANYTHING]
    for word in words:
        if _spelled(word, language) in HOMOGRAPHS[language]:
            message = f"‘{word}’ alone means other things too."
            yield Remark("K1", node.key, message, "Ask for a second word with it.", language)
    short = [word for word in words if _is_short(word, language) and word not in names]
    if short:
        message = f"‘{some(short)}’ alone is short."
        yield Remark("K1", node.key, message, "Ask for a second word with it.", language)


def _own_words(topic: Topic, language: str) -> frozenset[str]:
    """Return the forms of a topic's name: it must be found by these, however short."""
    fields = topic.names.get(language, {})
    return frozenset(word.casefold() for word in fields.values())


def _is_short(word: str, language: str) -> bool:
    if LANGUAGES[language].spaced:
        return sum(letter.isalnum() for letter in word) < LEAST_LETTERS
    return bool(_ONE_KANA.fullmatch(word))
