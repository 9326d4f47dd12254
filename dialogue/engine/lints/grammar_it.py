"""G2: Italian articles by the sound of the next word, and what agrees with a name."""

import re
from collections.abc import Iterator, Mapping
from functools import lru_cache

from languages.italian_articles import ARTICLES, Onset, articulated, onset_of
from languages.language import NameForms
from languages.lints import Finding

#: Feminine, plural, how the name begins.
_Kind = tuple[bool, bool, Onset]


def _kinds() -> Mapping[str, frozenset[_Kind]]:
    """Return which names a word before them fits: "dello" masculine ones, one, with a hard start.

    In "un tè" both genders' words differ, so "un" and "una" stand here too.
    """
    kinds: dict[str, set[_Kind]] = {}
    for (feminine, plural), by_onset in ARTICLES.items():
        for onset, article in by_onset.items():
            kind = (feminine, plural, onset)
            words = [article] + [articulated(one, article) for one in ("di", "a", "da", "in", "su")]
            words += [_shaped(stem, article) for stem in ("que", "be")]
            for word in words:
                kinds.setdefault(word, set()).add(kind)
    for onset in Onset:
        kinds.setdefault("uno" if onset is Onset.HARD else "un", set()).add((False, False, onset))
        kinds.setdefault("un'" if onset is Onset.VOWEL else "una", set()).add((True, False, onset))
    return {word: frozenset(some) for word, some in kinds.items()}


def _shaped(stem: str, article: str) -> str:
    """Return quel, quello, quell', quella … (or bel …) as the article asks."""
    endings = {"il": "l", "i": "i", "gli": "gli", "l'": "ll'"}
    return stem + endings.get(article, f"l{article}")


_KINDS = _kinds()
_WORDS = "|".join(sorted(map(re.escape, _KINDS), key=len, reverse=True))
_BEFORE_NAME = re.compile(
    rf"(?<![\w'’])({_WORDS})(?: |(?<=')|(?<=’))\$hasName\.(bare|sg)(?!\w|\.\w)", re.IGNORECASE
)
#: Words that are nothing but articles: "lo", "la", "gli", "le", "uno", "dai" may be others.
_SURE = (
    *("il", "i", "un", "una", "quel"),
    *(
        articulated(preposition, article)
        for preposition in ("di", "a", "da", "in", "su")
        for article in ("il", "lo", "la", "i", "gli")
        if (preposition, article) != ("da", "i")
    ),
)
_ARTICLE = re.compile(rf"(?<![\w'’])({'|'.join(_SURE)}) (?=\w\w)", re.IGNORECASE)

_SUBJECT = r"(?:^|[.!?:;,] )\$hasName"
_ONE = re.compile(
    rf"{_SUBJECT} (?:non )?(?:ti |ci |mi |si )?"
    r"(?:è|ha|fa|sa|può|va|dà|era|aveva|sarà|porta|piace|merita|resta|rimane)\b"
    r"|\b(?:piace|piaceva|piacerebbe|manca|mancava|interessa) \$hasName(?!\w|\.\w)",
    re.IGNORECASE,
)
_SEVERAL = re.compile(
    rf"{_SUBJECT} (?:non )?(?:ti |ci |mi |si )?"
    r"(?:sono|hanno|fanno|sanno|possono|vanno|danno|erano|avevano|saranno|portano|piacciono)\b"
    r"|\b(?:piacciono|piacevano|piacerebbero|mancano|interessano) \$hasName(?!\w|\.\w)",
    re.IGNORECASE,
)
_STEMS = (
    "bell|buon|famos|antic|nuov|vecchi|amat|prezios|bellissim|diffus|conosciut|nat|fatt|pien"
    "|perfett|ottim|comod|tranquill"
)
_ADJECTIVE = re.compile(
    rf"{_SUBJECT} (?:è|sono|era|erano) (?:\w+ )?(?:{_STEMS})(?P<end>[oaie])\b", re.IGNORECASE
)
_ENDINGS = {(False, False): "o", (True, False): "a", (False, True): "i", (True, True): "e"}


def lint_italian_names(template: str, name: NameForms) -> Iterator[Finding]:
    """Yield what does not agree with a name: "il $hasName.bare" for an acqua, "piace" for two."""
    for word, form in _before_name(template):
        said = name.forms.get(form, "")
        kind = (name.feminine, name.plural and form == "bare", onset_of(said))
        if kind not in _KINDS[word.casefold().replace("’", "'")]:
            message = f"‘{word}’ does not go with ‘{said}’."
            hint = "Use $hasName, $hasName.un, .di, .a …: they bring their article."
            yield Finding("G2", message, hint, error=False)
    yield from _agreement(template, name.feminine, name.plural)


@lru_cache(maxsize=16384)
def _before_name(template: str) -> tuple[tuple[str, str], ...]:
    return tuple((found[1], found[2]) for found in _BEFORE_NAME.finditer(template))


@lru_cache(maxsize=16384)
def _agreement(template: str, feminine: bool, plural: bool) -> tuple[Finding, ...]:
    found = []
    if wrong := (_ONE if plural else _SEVERAL).search(template):
        number = "several" if plural else "one"
        message = f"‘{wrong.group().strip(' ,.;:!?')}’: this name means {number}."
        found.append(Finding("G2", message, "Write both: {piace|piacciono}.", error=False))
    wrong = _ADJECTIVE.search(template)
    if wrong and wrong["end"] != _ENDINGS[feminine, plural]:
        message = f"‘{wrong.group().strip(' ,.;:!?')}’ does not agree with the name."
        found.append(Finding("G2", message, "Write all four: buon{o|a|i|e}.", error=False))
    return tuple(found)


def lint_italian_articles(text: str) -> Iterator[Finding]:
    """Yield "il zaino", "del acqua", "alla amica"."""
    for found in _ARTICLE.finditer(text):
        onset = onset_of(text[found.end() :])
        if all(onset is not kind[2] for kind in _KINDS[found[1].casefold()]):
            word = text[found.end() :].split(" ", 1)[0].strip(".,;:?!")
            message = f"‘{found.group()}{word}’."
            yield Finding("G2", message, "The article takes another shape here.", error=False)
