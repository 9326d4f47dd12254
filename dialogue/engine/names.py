"""Topics by name: "the sea", "sea" and 「海」 said alone mean one topic, whatever its keywords."""

from collections.abc import Mapping
from types import MappingProxyType

from dialogue.engine.tree import Tree
from languages.language import Language

#: Forms by which people name a topic; the others carry a preposition.
NAMING_FORMS = ("", "bare", "one", "sg", "un", "kana")


def name_index(tree: Tree, language: Language) -> Mapping[str, tuple[int, ...]]:
    """Return the numbers of the topics that a name stands for; the more special ones first."""
    index: dict[str, list[int]] = {}
    for node in sorted(tree.nodes.values(), key=lambda node: -len(node.ancestors)):
        forms = node.names[language.code].forms if language.code in node.names else {}
        for key in {spelled(forms[form], language) for form in NAMING_FORMS if form in forms}:
            if key:
                index.setdefault(key, []).append(node.number)
    return MappingProxyType({key: tuple(numbers) for key, numbers in index.items()})


def spelled(words: str, language: Language) -> str:
    """Return the words as the index knows them: case, width and punctuation do not count."""
    return " ".join(token.text for token in language.tokens(words))
