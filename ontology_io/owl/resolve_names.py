"""Names and keywords of a class, with what its individuals say, and Italian articles and genders.

In other ontologies `$hasName` in Italian has no article and `$hasNameWithArticle` has it; here
`$hasName` has it and `$hasName.bare` has not.
"""

import re
from collections.abc import Iterator, Mapping

import msgspec

from dialogue.engine.concepts import Topic
from languages.italian import ITALIAN
from languages.language import FormError
from ontology_io.owl.file_records import OwlFile, OwlTopic, Said
from ontology_io.owl.resolve_notes import Notes

WITH_ARTICLE = "hasNameWithArticle"
Keywords = dict[str, tuple[tuple[str, ...], tuple[str, ...]]]

_VARIABLE = re.compile(rf"\$({WITH_ARTICLE}|hasName)(?![A-Za-z]|\.[a-z])")
_ARTICLE = re.compile(r"(?:(il|lo|la|i|gli|le) |(l['’]))", re.IGNORECASE)
_ANYTHING = ("*",)


def in_our_words(file: OwlFile, notes: Notes) -> OwlFile:
    """Return the file with `$hasNameWithArticle` written as our sentences write it."""
    bare = not file.highest and any(
        WITH_ARTICLE in one.names for topic in file.topics for one in topic.individuals
    )
    counted = 0

    def told(said: Said) -> Said:
        nonlocal counted
        text = _in_our_words(said, bare=bare)
        counted += text != said.text
        return said if text == said.text else msgspec.structs.replace(said, text=text)

    topics = tuple(
        msgspec.structs.replace(topic, said=tuple(map(told, topic.said))) for topic in file.topics
    )
    if not counted:
        return file
    notes.note(
        "Topic",
        f"{counted} sentences with ${WITH_ARTICLE} or a $hasName without article are written"
        " as $hasName and $hasName.bare.",
    )
    return msgspec.structs.replace(file, topics=topics)


def _in_our_words(said: Said, *, bare: bool) -> str:
    if "$" not in said.text:
        return said.text
    without = "$hasName.bare" if bare and said.language == "it" else "$hasName"
    return _VARIABLE.sub(
        lambda found: "$hasName" if found.group(1) == WITH_ARTICLE else without, said.text
    )


def names(new: OwlTopic, old: Topic | None, notes: Notes) -> dict[str, dict[str, str]]:
    """Return the names by language: labels, else what the individuals are called."""
    before = old.names if old else {}
    found = {code: dict(fields) for code, fields in new.names.items()}
    for name, code, text in _own(new, "hasName"):
        fields = found.setdefault(code, {})
        if fields.setdefault("name", text) != text:
            notes.note(
                name,
                f"Its own name {text!r} is not taken: a name is the same in all cultures.",
                f"Change the label of {new.key} instead.",
            )
    if "it" in found and found["it"].get("name") and found["it"] != before.get("it"):
        _complete(new, found["it"], notes)
    return found


def _own(topic: OwlTopic, field: str) -> Iterator[tuple[str, str, str]]:
    """Yield individual, language and text of what is said at each individual."""
    for one in topic.individuals:
        for code, text in one.names.get(field, {}).items():
            yield one.name, code, text


def _complete(topic: OwlTopic, fields: dict[str, str], notes: Notes) -> None:
    """Add gender, number and article to an Italian name, as far as they are told."""
    given = ""
    for name, code, text in _own(topic, WITH_ARTICLE):
        if code != "it" or (given and text != given):
            notes.note(name, f"{text!r}@{code} is not taken as a name with article.")
        else:
            given = text
    article = _article(given)
    if "g" not in fields:
        fields["g"] = _gender(article, fields["name"])
        told = f"the article of {given!r}" if article not in ("", "l'") else "its ending"
        notes.note(
            topic.key,
            f"The Italian name {fields['name']!r} has no gender; {fields['g']!r} is taken from"
            f" {told}.",
            "Correct nameGender if it is wrong.",
        )
        if article in ("i", "gli", "le"):
            fields.setdefault("n", "p")
    if given and "il" not in fields and _with_article(fields) != given:
        fields["il"] = given


def _article(text: str) -> str:
    found = _ARTICLE.match(text)
    return ((found.group(1) or "l'") if found else "").casefold()


def _gender(article: str, name: str) -> str:
    if article in ("la", "le"):
        return "f"
    if article in ("il", "lo", "i", "gli"):
        return "m"
    return "f" if name.split()[0].casefold().endswith("a") else "m"


def _with_article(fields: Mapping[str, str]) -> str:
    try:
        return ITALIAN.name_forms(fields).forms[""]
    except FormError:
        return ""


def keywords(new: OwlTopic, old: Topic | None, notes: Notes) -> Keywords:
    """Return the keywords by language: those of the class, else those of its individuals."""
    found = dict(new.keywords)
    own: dict[str, tuple[dict[str, None], dict[str, None]]] = {}
    for one in new.individuals:
        for code, (first, second) in one.keywords.items():
            if code in new.keywords:
                notes.note(
                    one.name,
                    f"Its own keywords in {code} are not taken: {new.key} has keywords for all"
                    " cultures.",
                    f"Add them to defaultKeyword1 of {new.key}.",
                )
                continue
            mine = own.setdefault(code, ({}, {}))
            mine[0].update(dict.fromkeys(first))
            mine[1].update(dict.fromkeys(second))
    for code, (firsts, seconds) in own.items():
        found[code] = (tuple(firsts), tuple(seconds))
        notes.note(new.key, f"Its keywords in {code} come from its individuals.")
    before = old.keywords if old else {}
    return {code: _whole(words, before.get(code)) for code, words in found.items()}


def _whole(
    words: tuple[tuple[str, ...], tuple[str, ...]],
    before: tuple[tuple[str, ...], tuple[str, ...]] | None,
) -> tuple[tuple[str, ...], tuple[str, ...]]:
    first, second = words
    return words if second or words == before else (first, _ANYTHING)
