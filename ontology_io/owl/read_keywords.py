"""Keywords: two sets a language, written with bars."""

from ontology_io.owl.facts import Node
from ontology_io.owl.read_values import Reader, words


def keywords(
    reader: Reader, node: Node, keys: tuple[str, str]
) -> dict[str, tuple[tuple[str, ...], tuple[str, ...]]]:
    """Take both sets of keywords, by language."""
    found: dict[str, list[tuple[str, ...]]] = {}
    for place, key in enumerate(keys):
        for language, text, _ in reader.texts(node, key):
            sets = found.setdefault(language, [(), ()])
            sets[place] = (*sets[place], *words(text))
    return {language: (sets[0], sets[1]) for language, sets in found.items()}
