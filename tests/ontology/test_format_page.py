"""The page docs/content-format.md shows what really loads, and names every key there is."""

import re
from pathlib import Path

import pytest

from dialogue.engine.sentence_types import SENTENCE_TYPES
from languages.known import LANGUAGES
from ontology_io.check import check_base
from ontology_io.files.folder import LARGEST_FILE, folder_texts, read_folder
from ontology_io.files.intents_files import INTENT_KEYS, SAID_KEYS, SPEECH_KEYS
from ontology_io.files.topics_reader import FRAME_KEYS, LONGEST_SENTENCE, TOPIC_KEYS
from ontology_io.store import read_base, write_base
from tests.ontology.small_content import write_files

PAGE = (Path(__file__).resolve().parents[2] / "docs/content-format.md").read_text(encoding="utf-8")
EXAMPLES = dict(re.findall(r"```yaml (\S+)\.yaml\n(.*?)```", PAGE, re.DOTALL))


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return the page's files, with the pools of the small content."""
    return write_files(tmp_path, drink="", flower="", **EXAMPLES)


def test_the_page_shows_a_branch_cultures_and_intents() -> None:
    assert set(EXAMPLES) == {"garden", "cultures", "intents"}


def test_the_examples_have_no_errors_and_are_canonical(folder: Path) -> None:
    read = read_folder(folder)
    assert check_base(read.base) == []
    texts = folder_texts(read.base, read.last)
    assert {name: texts[f"{name}.yaml"] for name in EXAMPLES} == EXAMPLES


def test_the_examples_load(empty_draft: None, folder: Path) -> None:
    read = read_folder(folder)
    write_base(read.base, read.last)
    topics = {topic.key: topic for topic in read_base().knowledge.topics}
    assert list(topics) == ["Garden", "GardenFlower", "Rose", "CherryBlossom"]
    assert topics["CherryBlossom"].likeliness == {"EN": 0.5, "JP": 0.7}


@pytest.mark.parametrize(
    "key",
    sorted(
        {*TOPIC_KEYS, *FRAME_KEYS, *INTENT_KEYS, *SPEECH_KEYS, *SAID_KEYS}
        | {field for language in LANGUAGES.values() for field in language.name_fields}
    ),
)
def test_the_page_names_every_key(key: str) -> None:
    assert re.search(rf"\b{key}\b", PAGE)


def test_the_page_names_every_form_type_and_limit() -> None:
    forms = {form for language in LANGUAGES.values() for form in language.form_names}
    assert [form for form in forms if f".{form}" not in PAGE] == []
    sentences = PAGE.partition("## A sentence")[2]
    assert [kind for kind in SENTENCE_TYPES if not re.search(rf"\b{kind} \w", sentences)] == []
    assert f"{LONGEST_SENTENCE} characters at most" in PAGE
    assert f"{LARGEST_FILE // 1_000_000} MB at most" in PAGE
