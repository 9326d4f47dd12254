"""What a knowledge base says about topics, as plain values: the one neutral form.

Files, OWL and database rows are all read into these records; a publication stores them, and the
Dialogue Tree is built from them (paper, "Knowledge Representation").
"""

import msgspec

ROOT = "Topic"


class Culture(msgspec.Struct, frozen=True, kw_only=True):
    """A culture with CS-ABox individuals of its own; `names` by language: {"en": "Italian"}."""

    code: str
    names: dict[str, str]
    language: str


class Frame(msgspec.Struct, frozen=True, kw_only=True, omit_defaults=True):
    """One meaning the agent can say, with its sentence in each language.

    `key` is `DishMain.q1` or, in a pool, `acknowledge.12`. `number` is stable and never reused;
    `slot` is its bit in the dialogue state, unique along each path of the tree (-1: none yet).
    """

    key: str
    type: str
    texts: dict[str, str]
    number: int = 0
    slot: int = -1
    only: tuple[str, ...] = ()
    scope: str = ""
    do: str = ""


class Topic(msgspec.Struct, frozen=True, kw_only=True, omit_defaults=True):
    """A concept of the TBox with what its individuals say in each culture.

    `is_a` is the parent's key (`Topic` for a branch); `also` are further classes it takes
    sentences from. `likeliness` has one value (0..1) a culture; `keywords` two sets a language.
    `individuals` names the CS-ABox individual of a culture, where its name is not the usual one.
    """

    key: str
    is_a: str
    number: int = 0
    also: tuple[str, ...] = ()
    of: str = ""
    gentle: bool = False
    stop: str = ""
    pattern: tuple[str, ...] = ()
    variables: dict[str, dict[str, str]] = {}
    names: dict[str, dict[str, str]] = {}
    keywords: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {}
    likeliness: dict[str, float] = {}
    individuals: dict[str, str] = {}
    see: tuple[str, ...] = ()
    note: str = ""
    frames: tuple[Frame, ...] = ()


class Knowledge(msgspec.Struct, frozen=True, kw_only=True):
    """Everything the Dialogue Manager knows: cultures, topics in tree order, pools."""

    cultures: tuple[Culture, ...] = ()
    topics: tuple[Topic, ...] = ()
    pools: dict[str, tuple[Frame, ...]] = {}


HOME, AWAY, SHARED = 0.7, 0.3, 0.5


def usual_likeliness(of: str, cultures: tuple[str, ...]) -> dict[str, float]:
    """Return the likeliness a topic starts with: 0.7 at home, 0.3 elsewhere, 0.5 when shared."""
    if not of:
        return dict.fromkeys(cultures, SHARED)
    return {code: HOME if code == of else AWAY for code in cultures}
