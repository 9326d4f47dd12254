"""The Japanese catalogue: complete, with every placeholder, and compiled as it is written."""

import ast
import gettext
import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

import pytest
from django.urls import reverse
from django.utils.translation import gettext as translated
from django.utils.translation import override
from django.utils.translation.template import templatize

from authoring.pages.table import PAGES
from authoring.roles import ADMINISTRATOR
from dialogue.engine.sentence_types import SENTENCE_TYPES
from plans.engine.actions import ACTIONS
from tests.authoring.people import logged_in

ROOT = Path(__file__).resolve().parents[2]
MESSAGES = ROOT / "locale" / "ja" / "LC_MESSAGES"
PLACEHOLDER = re.compile(r"%%|%\(\w+\)[sd]|%[sd]|</?[a-z]+>|\{\w+\}|\$[A-Za-z]+(?:\.[a-z]+)?")
LINE = re.compile(r'(msgctxt|msgid_plural|msgid|msgstr)(?:\[\d\])? (".*")')
MARKED = re.compile(r"""\bn?p?gettext\((u?(?:'(?:[^'\\]|\\.)*'|"(?:[^"\\]|\\.)*"))""")
MARKERS = ("gettext", "gettext_lazy", "ngettext", "ngettext_lazy")


@dataclass
class Entry:
    """One text of the catalogue: its parts by their word in the file, and its flags."""

    parts: dict[str, str] = field(default_factory=dict)
    flags: str = ""

    @property
    def english(self) -> str:
        return self.parts["msgid"]

    @property
    def longest(self) -> str:
        """Return the English with all the placeholders: the plural where there is one."""
        return self.parts.get("msgid_plural", self.english)

    @property
    def japanese(self) -> str:
        return self.parts["msgstr"]


def read_entry(block: str) -> Entry:
    entry, last = Entry(), ""
    for line in block.splitlines():
        begun = LINE.fullmatch(line)
        if begun:
            last = begun[1]
            entry.parts[last] = ast.literal_eval(begun[2])
        elif line.startswith('"'):
            entry.parts[last] += ast.literal_eval(line)
        elif line.startswith("#,"):
            entry.flags += line[2:]
    return entry


@cache
def entries() -> tuple[Entry, ...]:
    """Return every text of the catalogue; its header is left out."""
    blocks = (MESSAGES / "django.po").read_text("utf-8").split("\n\n")
    return tuple(entry for block in blocks if (entry := read_entry(block)).parts.get("msgid"))


@cache
def compiled() -> gettext.GNUTranslations:
    with (MESSAGES / "django.mo").open("rb") as file:
        return gettext.GNUTranslations(file)


def as_compiled(entry: Entry) -> str:
    context, plural = entry.parts.get("msgctxt"), entry.parts.get("msgid_plural")
    if context is not None:
        return compiled().pgettext(context, entry.english)
    if plural is not None:
        return compiled().ngettext(entry.english, plural, 2)
    return compiled().gettext(entry.english)


def in_python(path: Path) -> Iterator[str]:
    """Yield the texts that a module marks for translation, whatever it calls the function."""
    tree = ast.parse(path.read_text("utf-8"))
    called = {
        name.asname or name.name
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom) and node.module == "django.utils.translation"
        for name in node.names
        if name.name in MARKERS
    }
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            first = node.args[0] if node.args else None
            if node.func.id in called and isinstance(first, ast.Constant):
                yield str(first.value)


def in_template(path: Path) -> Iterator[str]:
    """Yield the texts that a template marks for translation."""
    for found in MARKED.finditer(templatize(path.read_text("utf-8"), origin=str(path))):
        yield ast.literal_eval(found[1])


def marked() -> Iterator[str]:
    for path in sorted((ROOT / "authoring").rglob("*.py")):
        yield from in_python(path)
    for folder in ("admin", "authoring"):
        for path in sorted((ROOT / "templates" / folder).rglob("*.html")):
            yield from in_template(path)


def test_every_text_of_the_catalogue_is_written_in_japanese() -> None:
    assert len(entries()) > 1000
    assert [entry.english for entry in entries() if not entry.japanese.strip()] == []


def test_no_text_of_the_catalogue_waits_for_a_second_look() -> None:
    assert [entry.english for entry in entries() if "fuzzy" in entry.flags] == []


def test_every_text_that_the_pages_mark_is_in_our_catalogue_or_that_of_django() -> None:
    unknown = set(marked()) - {entry.english for entry in entries()}
    with override("ja"):
        assert sorted(text for text in unknown if translated(text) == text) == []


def test_the_marks_of_modules_and_templates_are_found() -> None:
    assert {"Try a sentence", "There is no topic %(unknown)s.", "%(own)s sentence"} <= set(marked())


def test_what_the_chat_translates_from_tables_of_the_engines_is_in_the_catalogue() -> None:
    known = {entry.english for entry in entries()}
    tables = [one.name for one in SENTENCE_TYPES.values()] + [one.meaning for one in ACTIONS]
    assert [text for text in tables if text not in known] == []


def test_every_placeholder_and_tag_is_kept() -> None:
    lost = [
        entry.english
        for entry in entries()
        if Counter(PLACEHOLDER.findall(entry.longest))
        != Counter(PLACEHOLDER.findall(entry.japanese))
    ]
    assert lost == []


def test_texts_that_are_cut_at_commas_keep_their_parts() -> None:
    texts = {entry.english: entry.japanese for entry in entries()}
    assert texts["correct,look"].count(",") == 1


def test_the_compiled_catalogue_says_what_the_written_one_says() -> None:
    assert [one.english for one in entries() if as_compiled(one) != one.japanese] == []


def test_every_page_of_the_menu_has_a_japanese_title() -> None:
    with override("ja"):
        titles = [str(page.title) for page in PAGES if page.title]
    assert [title for title in titles if title.isascii()] == []


@pytest.mark.usefixtures("small_draft")
def test_a_browser_that_asks_for_japanese_gets_the_start_page_in_japanese() -> None:
    client = logged_in(ADMINISTRATOR)
    page = client.get(reverse("admin:index"), headers={"accept-language": "ja"})
    assert "ロボットが話す内容" in page.content.decode()
