"""check_content: the lints beside the errors, on a small folder and on what is shipped."""

import re
from io import StringIO
from pathlib import Path
from shutil import copytree

import pytest
from django.core.management import CommandError, call_command

from dialogue.engine.lints.corpus import corpus_of
from dialogue.engine.lints.lint import lint, lint_content
from ontology_io.check import build_base
from ontology_io.files.folder import Folder, read_folder

SHIPPED = Path(__file__).parents[2] / "content"
pytestmark = pytest.mark.django_db


def told(folder: Path, *options: str) -> str:
    output = StringIO()
    call_command("check_content", str(folder), *options, stdout=output)
    return output.getvalue()


@pytest.fixture
def dumped(small_draft: Folder, small_folder: Path) -> Path:
    call_command("dump_content", str(small_folder), stdout=StringIO())
    return small_folder


def test_warnings_stand_apart_with_their_places_and_are_counted(dumped: Path) -> None:
    lines = told(dumped).splitlines()
    assert lines[0] == "Warnings:"
    assert any(line.startswith("content/drink.yaml:") and " C3 Drink: " in line for line in lines)
    assert "C3 " in lines[-2]
    assert lines[-1].startswith("5 topics, 0 errors, ")


def test_warnings_can_be_left_out(dumped: Path) -> None:
    assert told(dumped, "--errors-only") == "5 topics, 0 errors, 0 findings.\n"


def test_warnings_fail_where_one_is_strict(dumped: Path) -> None:
    with pytest.raises(CommandError, match=r"^\d+ warnings\.$"):
        told(dumped, "--strict")


def test_the_bars_are_printed_as_a_table(dumped: Path) -> None:
    lines = told(dumped, "--bars").splitlines()
    assert lines[0] == "| Bar | What | Target | Figure | Met |"
    assert "|  | topics |  | 5 |  |" in lines


def test_an_error_seeded_into_the_shipped_content_is_caught(tmp_path: Path) -> None:
    folder = tmp_path / "content"
    copytree(SHIPPED, folder)
    file = folder / "animal.yaml"
    bad = "When I was a child, did you enjoy the a company of $hasName?"
    question = re.compile(r"(- id: PetAnimal\n.*?    q2:\n      en: )[^\n]*", re.DOTALL)
    text, count = question.subn(lambda found: found[1] + bad, file.read_text(encoding="utf-8"))
    assert count == 1
    file.write_text(text, encoding="utf-8")
    seeded, shipped = (
        {(one.code, one.where) for one in lint(corpus_of(base.knowledge, base.tree))}
        for base in (build_base(read_folder(path).base) for path in (folder, SHIPPED))
    )
    assert {("P1", "PetAnimal.q2"), ("G3", "PetAnimal.q2")} <= seeded - shipped


def test_topics_that_have_no_number_yet_are_linted_too(small_folder: Path) -> None:
    content = build_base(read_folder(small_folder).base)
    assert all(number > 0 for number in content.tree.nodes)
    assert {one.where for one in lint_content(content)} >= {"Drink", "Tea"}
