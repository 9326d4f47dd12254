"""G1-G5, S1, P1: every sentence as it is said, each template reported once."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from statistics import fmean

from dialogue.engine.concepts import ROOT
from dialogue.engine.lints.corpus import Corpus, Filled
from dialogue.engine.lints.grammar_en import lint_english_articles, lint_english_names
from dialogue.engine.lints.grammar_it import lint_italian_articles, lint_italian_names
from dialogue.engine.lints.particles import lint_particles
from dialogue.engine.lints.remarks import Remark, some
from languages.language import NameForms
from languages.lints import Finding, lint_gentle_sentence, lint_health_sentence, lint_sentence

HEALTH = "Health"
MOST_ON_AVERAGE = {"en": 11, "it": 11, "ja": 30}
#: Pools whose texts are told whole: they are tales and verses, not sentences of a talk.
RECITED = frozenset(
    ("joke", "riddle", "proverb", "curiosity", "story", "poem", "prayer", "breathing")
)
UNITS = {"en": "words", "it": "words", "ja": "characters"}


@dataclass(slots=True)
class _Flaw:
    """One flaw of one template: the sentence that shows it best, and the topics that have it."""

    message: str
    text: str
    topics: list[str] = field(default_factory=list)


def lint_filled(corpus: Corpus, language: str, filled: Iterable[Filled]) -> Iterator[Remark]:
    """Yield what is wrong with the sentences: each template and flaw once, with its topics."""
    flaws: dict[tuple[str, str, str], _Flaw] = {}
    for one in filled:
        for found in _found(corpus, language, one):
            flaw = flaws.setdefault(
                (one.line.key, found.code, found.hint), _Flaw(found.message, one.text)
            )
            if one.line.owner:
                flaw.topics.append(one.node.key)
            if found.code == "S1" and len(one.text) > len(flaw.text):
                flaw.message, flaw.text = found.message, one.text
    for (where, code, hint), flaw in flaws.items():
        about = f" Said of {some(flaw.topics)}." if flaw.topics else ""
        yield Remark(code, where, f"‘{flaw.text}’: {flaw.message}{about}", hint, language)


def _found(corpus: Corpus, language: str, one: Filled) -> Iterator[Finding]:
    name = one.node.names[language]
    for found in lint_sentence(one.text, one.line.type, language):
        if one.line.owner or _counts_in_pools(found, one.line.type):
            yield found
    yield from _grammar(one.text, one.line.templates[language].text, name, language)
    if one.line.owner:
        if one.node.gentle:
            yield from lint_gentle_sentence(one.text, language)
        if corpus.branch_of(one.node) == HEALTH:
            yield from lint_health_sentence(one.text, language)


def _counts_in_pools(found: Finding, pool: str) -> bool:
    """Say whether it is a flaw in a pool: greetings need no です, a tale may be long and ask."""
    if found.code == "G4" and not found.error:
        return False
    return pool not in RECITED or found.code not in ("S1", "G5")


def _grammar(text: str, template: str, name: NameForms, language: str) -> Iterator[Finding]:
    if language == "en":
        yield from lint_english_names(template, name)
        yield from lint_english_articles(text)
    elif language == "it":
        yield from lint_italian_names(template, name)
        yield from lint_italian_articles(text)
    else:
        yield from lint_particles(template)


def lint_average(language: str, filled: Iterable[Filled]) -> Iterator[Remark]:
    """Yield S1 where sentences are too long on average."""
    mean, most = average_length(language, filled), MOST_ON_AVERAGE[language]
    if mean > most:
        message = f"The sentences have {mean:.1f} {UNITS[language]} on average."
        yield Remark("S1", ROOT, message, f"At most {most}: shorten the longest.", language)


def average_length(language: str, filled: Iterable[Filled]) -> float:
    """Return how long sentences are: in words, in Japanese in characters; 0 without any."""
    texts = {one.text for one in filled}
    lengths = [len(text) if language == "ja" else len(text.split()) for text in texts]
    return fmean(lengths) if lengths else 0.0
