"""The Italian of the admin: every string is translated, with the same placeholders."""

import ast
import gettext
import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest
from django.utils import translation
from django.utils.translation.template import templatize

from authoring import engine_words
from authoring.model_words import FIELDS, ROWS
from authoring.topic_page.words import KINDS
from dialogue.engine.pools import POOLS
from dialogue.engine.sentence_types import SENTENCE_TYPES
from dialogue.models import Topic
from plans.engine.actions import ACTIONS
from plans.engine.kb_actions import KB_ACTIONS

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "locale" / "it" / "LC_MESSAGES"
MARKS = ("gettext", "gettext_lazy", "gettext_noop", "ngettext", "pgettext_lazy")
QUOTED = r"""('(?:[^'\\]|\\.)*'|"(?:[^"\\]|\\.)*")"""
IN_TEMPLATE = re.compile(rf"\b(?:gettext|ngettext|pgettext)\(\s*u?{QUOTED}")
PLACEHOLDER = re.compile(r"%%|%\(\w+\)[sd]|%[sd]|\{\w*\}|</?\w+[^>]*>")
LINE = re.compile(r'(?:(msgctxt|msgid_plural|msgid|msgstr(?:\[\d\])?) )?"(.*)"$')
#: Strings may begin or end with these; a translation then does too.
EDGES = " :…"


class Entry(NamedTuple):
    """One string of the catalogue: its English forms, its Italian forms, whether it is fuzzy."""

    context: str
    english: tuple[str, ...]
    italian: tuple[str, ...]
    fuzzy: bool

    @property
    def key(self) -> str:
        """Return by what gettext finds it."""
        return f"{self.context}\x04{self.english[0]}" if self.context else self.english[0]


def read(text: str) -> Iterator[Entry]:
    """Yield the entries of a .po file."""
    for block in text.split("\n\n"):
        parts: dict[str, str] = {}
        name = ""
        for line in block.splitlines():
            found = LINE.match(line)
            if found and not line.startswith("#"):
                name = found[1] or name
                parts[name] = parts.get(name, "") + unescaped(found[2])
        if parts.get("msgid"):
            english = (
                parts["msgid"],
                *([parts["msgid_plural"]] if "msgid_plural" in parts else []),
            )
            italian = tuple(parts[one] for one in parts if one.startswith("msgstr"))
            fuzzy = any(line.startswith("#,") and "fuzzy" in line for line in block.splitlines())
            yield Entry(parts.get("msgctxt", ""), english, italian, fuzzy)


def unescaped(text: str) -> str:
    """Return a quoted text of a .po file as it is meant."""
    return re.sub(r"\\(.)", lambda found: {"n": "\n", "t": "\t"}.get(found[1], found[1]), text)


@pytest.fixture(scope="module")
def entries() -> list[Entry]:
    """Return the catalogue."""
    return list(read((FOLDER / "django.po").read_text(encoding="utf-8")))


def test_the_reader_understands_contexts_plurals_and_doubtful_entries() -> None:
    lines = ["#, fuzzy", 'msgctxt "row"', r'msgid "a \"b\""', 'msgid_plural "c"']
    text = "\n".join([*lines, 'msgstr[0] "d"', 'msgstr[1] ""'])
    assert list(read(text)) == [Entry("row", ('a "b"', "c"), ("d", ""), True)]


def test_every_string_is_translated_and_none_is_in_doubt(entries: list[Entry]) -> None:
    assert len(entries) > 1000
    assert [one.key for one in entries if one.fuzzy or not all(one.italian)] == []
    assert [one.key for one in entries if len(one.italian) != len(one.english)] == []


def marked() -> Iterator[str]:
    """Yield every string that modules and templates mark for translation, once a use."""
    for app in ("authoring", "dialogue", "plans"):
        for path in sorted((ROOT / app).rglob("*.py")):
            yield from _in_module(ast.parse(path.read_text(encoding="utf-8")))
    for path in sorted((ROOT / "templates").rglob("*.html")):
        code = templatize(path.read_text(encoding="utf-8"), origin=str(path))
        yield from (str(ast.literal_eval(found[1])) for found in IN_TEMPLATE.finditer(code))


def _in_module(tree: ast.Module) -> Iterator[str]:
    names = {
        name.asname or name.name: name.name
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom) and node.module == "django.utils.translation"
        for name in node.names
        if name.name in MARKS
    }
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            mark = names.get(node.func.id)
            if mark is None:
                continue
            text = node.args[1 if mark.startswith("pgettext") else 0]
            if isinstance(text, ast.Constant):
                yield str(text.value)


def test_every_string_that_is_marked_stands_in_the_catalogue(entries: list[Entry]) -> None:
    found = set(marked())
    assert {"Try a sentence", "%(own)s sentence", "first", "Model name"} <= found
    assert sorted(found - {one.english[0] for one in entries}) == []


def test_the_same_placeholders_and_tags_stand_in_both_languages(entries: list[Entry]) -> None:
    def held(text: str) -> list[str]:
        return sorted(PLACEHOLDER.findall(text))

    pairs = [pair for one in entries for pair in zip(one.english, one.italian, strict=True)]
    assert [english for english, italian in pairs if held(english) != held(italian)] == []


def test_a_string_that_is_joined_to_others_keeps_its_edges(entries: list[Entry]) -> None:
    def edges(text: str) -> tuple[str, str]:
        return (text[0] if text[0] in EDGES else "", text[-1] if text[-1] in EDGES else "")

    one_form = [one for one in entries if len(one.english) == 1]
    found = [one.key for one in one_form if edges(one.english[0]) != edges(one.italian[0])]
    assert found == []


def test_the_compiled_catalogue_says_what_the_source_says(entries: list[Entry]) -> None:
    with (FOLDER / "django.mo").open("rb") as file:
        compiled = gettext.GNUTranslations(file)
    stale = [one.key for one in entries if tuple(_compiled_forms(compiled, one)) != one.italian]
    assert stale == []


def _compiled_forms(compiled: gettext.GNUTranslations, entry: Entry) -> Iterator[str]:
    if len(entry.english) == 2:
        one, many = entry.english
        yield from (compiled.ngettext(one, many, number) for number in (1, 2))
    elif entry.context:
        yield compiled.pgettext(entry.context, entry.english[0])
    else:
        yield compiled.gettext(entry.english[0])


def test_the_words_of_the_engines_are_all_in_the_catalogue() -> None:
    assert {pool.used_when for pool in POOLS.values()} == {*engine_words.POOLS}
    assert {row.name for row in SENTENCE_TYPES.values()} == {*engine_words.TYPES}
    assert {one.meaning for one in ACTIONS} == {*engine_words.ACTIONS}
    assert {one.meaning for one in KB_ACTIONS} == {*engine_words.KB_ACTIONS}


def test_rows_fields_kinds_and_help_are_told_in_the_language_of_the_page() -> None:
    gentle = Topic._meta.get_field("gentle")
    with translation.override("it"):
        assert str(Topic._meta.verbose_name_plural) == "argomenti"
        assert str(gentle.verbose_name) == "argomento delicato"
        assert str(gentle.help_text).startswith("Un argomento difficile")
        assert str(KINDS["q"].name) == "domanda sì/no"
    with translation.override("en"):
        assert str(Topic._meta.verbose_name_plural) == "topics"
        assert str(gentle.verbose_name) == "gentle"


def test_every_name_of_a_row_or_field_differs_from_the_english_one_or_is_known_to_be_the_same() -> (
    None
):
    names = [*FIELDS.values(), *(name for pair in ROWS.values() for name in pair)]
    with translation.override("en"):
        english = [str(name) for name in names]
    with translation.override("it"):
        italian = [str(name) for name in names]
    assert [one for one, other in zip(english, italian, strict=True) if one == other] == []
