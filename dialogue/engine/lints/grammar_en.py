"""G3: English articles and verbs beside a name."""

import re
from collections.abc import Iterator
from functools import lru_cache

from languages.english_names import sounds_like_a_vowel
from languages.language import NameForms
from languages.lints import Finding

_ARTICLE = re.compile(r"(?<![-\w'’.])([Aa]n?) (?=[\w'’]{2})")
_GAP = r"\$hasName(?:\.bare)?(?!\w|\.\w)"
#: What follows a name that stands alone; another word makes it "a tea lesson".
_ALONE = r"(?=[.,;:?!]|$| (?:in|on|at|with|for|that|is|has|to|of|or|and|from|when|can|will)\b)"
_COUNTED = re.compile(rf"\b(?:a|an|another|each|every) {_GAP}{_ALONE}", re.IGNORECASE)
_SUBJECT = r"(?:^|[.!?:;,] )\$hasName"
_ONE = re.compile(
    rf"{_SUBJECT} (?:is|has|was|does|comes|goes|makes|brings|gives)\b"
    r"|(?:^|[.!?:;,] )(?:Is|Has|Was|Does) \$hasName(?!\w|\.\w)"
    r"|\bthis \$hasName(?!\w|\.\w)",
    re.IGNORECASE,
)
_SEVERAL = re.compile(
    rf"{_SUBJECT} (?:are|have|were|do|come|go|make|bring|give)\b"
    r"|(?:^|[.!?:;,] )(?:Are|Have|Were) \$hasName(?!\w|\.\w)"
    r"|\b(?:these|those|many|few) \$hasName(?!\w|\.\w)",
    re.IGNORECASE,
)


def lint_english_names(template: str, name: NameForms) -> tuple[Finding, ...]:
    """Return what does not agree with a name: "a music", "tomatoes is"."""
    return _agreement(template, "one" in name.forms, name.plural)


@lru_cache(maxsize=16384)
def _agreement(template: str, counted: bool, plural: bool) -> tuple[Finding, ...]:
    found = []
    if not counted and (wrong := _COUNTED.search(template)):
        message = f"‘{wrong.group()}’: this name is not counted."
        found.append(Finding("G3", message, "Use $hasName.one, or no article.", error=False))
    if wrong := (_ONE if plural else _SEVERAL).search(template):
        number = "several" if plural else "one"
        message = f"‘{wrong.group().strip(' ,.;:!?')}’: this name means {number}."
        found.append(Finding("G3", message, "Write both: {is|are}.", error=False))
    return tuple(found)


def lint_english_articles(text: str) -> Iterator[Finding]:
    """Yield "a owl" and "an university"."""
    for found in _ARTICLE.finditer(text):
        wants = sounds_like_a_vowel(text[found.end() :])
        if wants != (found[1][1:] == "n"):
            word = text[found.end() :].split(" ", 1)[0].strip(".,;:?!")
            message = f"‘{found.group()}{word}’."
            yield Finding("G3", message, f"Write {'an' if wants else 'a'} {word}.", error=False)
