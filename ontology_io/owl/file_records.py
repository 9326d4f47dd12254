"""What an OWL file says, as plain values: what the reader hands to the one who compares.

Topics are named by the local name of their class, cultures by their code. Nothing here has been
compared with the draft yet: `id` is what the file says ("" for what is new).
"""

import msgspec

from plans.engine.intents import Intent, Phrase, ValueList


class Problem(msgspec.Struct, frozen=True, kw_only=True):
    """Something wrong with a file: where (a local name), what, and what to do."""

    where: str
    text: str
    hint: str = ""
    error: bool = True

    def __str__(self) -> str:
        return " ".join(part for part in (f"{self.where}:", self.text, self.hint) if part)


class Said(msgspec.Struct, frozen=True, kw_only=True, omit_defaults=True):
    """One sentence in one language; `order` 0 and `slot` -1 mean that the file says nothing.

    `type` is a letter, or a pool's code. `only` are codes of cultures from onlyCulture. `culture`
    is set where the sentence is asserted on the individual of a culture. `goal` is the key of the
    intent that goalIntent names.
    """

    type: str
    language: str
    text: str
    id: str = ""
    frame: str = ""
    order: int = 0
    slot: int = -1
    scope: str = ""
    activity: str = ""
    goal: str = ""
    only: tuple[str, ...] = ()
    culture: str = ""


class Individual(msgspec.Struct, frozen=True, kw_only=True, omit_defaults=True):
    """The individual of a topic in one culture; `likeliness` -1 where the file gives none.

    `links` are topics. `names` are hasName and hasNameWithArticle: property → language → text.
    """

    name: str
    culture: str
    id: str = ""
    likeliness: float = -1.0
    links: tuple[str, ...] = ()
    names: dict[str, dict[str, str]] = {}
    keywords: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {}


class OwlTopic(msgspec.Struct, frozen=True, kw_only=True, omit_defaults=True):
    """A class below Topic with its individuals; `parents` are all named superclasses.

    `parents` holds "Topic" for a branch. `names` by language as in dialogue.engine.concepts;
    `variables` by language, in order. `link_order` are ids of topics.
    """

    key: str
    parents: tuple[str, ...]
    id: str = ""
    tree_parent: str = ""
    order: int = 0
    names: dict[str, dict[str, str]] = {}
    keywords: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {}
    variables: dict[str, dict[str, str]] = {}
    gentle: bool = False
    stop: str = ""
    home: str = ""
    pattern: str = ""
    note: str = ""
    link_order: tuple[str, ...] = ()
    said: tuple[Said, ...] = ()
    individuals: tuple[Individual, ...] = ()


class OwlCulture(msgspec.Struct, frozen=True, kw_only=True):
    """A culture; `names` by language, `language` its default language's code."""

    code: str
    names: dict[str, str] = {}
    language: str = ""
    order: int = 0


class OwlIntent(msgspec.Struct, frozen=True, kw_only=True):
    """An intent as the file has it; its number is 0 and its id stands beside it."""

    intent: Intent
    id: str = ""
    order: int = 0


class OwlFile(msgspec.Struct, frozen=True, kw_only=True):
    """All that one file says.

    `lists` and `pools` tell whether the file speaks of value lists and phrases, of pools at all.
    `remainder` is what the vocabulary does not know, as sorted N-Triples with canonical blank
    nodes; `unknown` counts it by property or kind. `persons` counts the person-specific
    individuals that were left out.
    """

    iri: str
    topics: tuple[OwlTopic, ...] = ()
    cultures: tuple[OwlCulture, ...] = ()
    pools: dict[str, tuple[Said, ...]] = {}
    intents: tuple[OwlIntent, ...] = ()
    phrases: tuple[Phrase, ...] = ()
    values: tuple[ValueList, ...] = ()
    highest: dict[str, int] = {}
    has_pools: bool = False
    has_lists: bool = False
    persons: int = 0
    remainder: str = ""
    unknown: dict[str, int] = {}
    problems: tuple[Problem, ...] = ()
