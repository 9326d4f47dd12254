"""What differs between two texts, word by word (in Japanese letter by letter)."""

import re
from dataclasses import dataclass
from difflib import SequenceMatcher

SAME, GONE, COME = "same", "gone", "come"
#: Words with the blanks after them; letters of languages written without blanks one by one.
_UNITS = re.compile(r"[぀-ヿ㐀-鿿豈-﫿ー々]|\$[\w.]+|\w+|\s+|[^\w\s]")
#: Longer texts are shown whole, old and new.
LONGEST = 2000


@dataclass(frozen=True, slots=True)
class Piece:
    """A piece of text and what became of it: SAME, GONE or COME."""

    kind: str
    text: str


def word_marks(old: str, new: str) -> list[Piece]:
    """Return the pieces of both texts in reading order: what goes before what comes in its place.

    Texts that share less than a third are given whole: marks in every other word help nobody.
    """
    before, after = _UNITS.findall(old), _UNITS.findall(new)
    if max(len(old), len(new)) > LONGEST:
        return _whole(old, new)
    matcher = SequenceMatcher(None, before, after, autojunk=False)
    if matcher.ratio() < 1 / 3:
        return _whole(old, new)
    pieces: list[Piece] = []
    for tag, i, j, k, m in matcher.get_opcodes():
        if tag == "equal":
            pieces.append(Piece(SAME, "".join(before[i:j])))
        else:
            pieces += _whole("".join(before[i:j]), "".join(after[k:m]))
    return pieces


def _whole(old: str, new: str) -> list[Piece]:
    return [Piece(kind, text) for kind, text in ((GONE, old), (COME, new)) if text]
