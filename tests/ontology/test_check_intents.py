"""check_intents and plan_guide, as they are typed; and docs/plans.md says what the content says."""

import re
from io import StringIO
from pathlib import Path

import pytest
from django.core.management import CommandError, call_command

from dialogue.publishing import publish
from ontology_io.files.folder import Folder, read_folder
from ontology_io.intent_report import Places
from plans.engine.plans_page import plans_page
from tests.ontology.small_content import INTENTS, write_files

SOUND = INTENTS.replace("Let us listen to {title}.", "Let us listen.").replace(" {title}.", ".")
ROOT = Path(__file__).resolve().parents[2]


def run(command: str, *arguments: object) -> str:
    output = StringIO()
    call_command(command, *map(str, arguments), stdout=output)
    return output.getvalue()


@pytest.fixture
def sound_folder(small_folder: Path) -> Path:
    """Return the small content with a plan sentence that can always be said."""
    return write_files(small_folder, intents=SOUND)


def refused(*arguments: object) -> tuple[str, str]:
    """Return what is printed before the command gives up, and why it does."""
    output = StringIO()
    with pytest.raises(CommandError) as caught:
        call_command("check_intents", *map(str, arguments), stdout=output)
    return output.getvalue(), str(caught.value)


def test_the_table_counts_what_is_written_and_what_passed(sound_folder: Path) -> None:
    printed, _ = refused("--path", sound_folder)
    assert re.search(r"^ +playsong +50 +1/2/2 +1/1/0 +1/1/0 +2 +0$", printed, re.MULTILINE)


def test_a_language_without_tests_ends_the_command_with_an_error(sound_folder: Path) -> None:
    printed, message = refused("--path", sound_folder)
    assert re.search(r"content/intents.yaml:\d+: C011 playsong \(it\): There are no tests", printed)
    assert message == "0 tests failed, 2 errors."


def test_without_faults_the_command_ends_well(sound_folder: Path) -> None:
    printed = run("check_intents", "--path", sound_folder, "--language", "en")
    totals = "1 of 1 intents, 1 triggers: 2 tests passed, 0 failed, 0 errors, "
    assert printed.splitlines()[-1].startswith(totals)
    assert "C012" not in printed


def test_warnings_are_shown_when_wanted(sound_folder: Path) -> None:
    printed = run("check_intents", "--path", sound_folder, "--language", "en", "--warnings")
    assert "C012 playsong (en): warning: 1 triggers; there should be 8 to 15." in printed


def test_a_failing_test_is_told_with_its_line(sound_folder: Path) -> None:
    wrong = SOUND.replace("- I like tea -> no", "- Play tea -> no")
    write_files(sound_folder, intents=wrong)
    printed, message = refused("--path", sound_folder, "--language", "en")
    line = next(n for n, text in enumerate(wrong.splitlines(), 1) if "Play tea" in text)
    expected = f"content/intents.yaml:{line}: playsong (en): 'Play tea' matched by "
    assert expected in printed
    assert message == "1 tests failed, 0 errors."


def test_an_unknown_intent_and_a_wrong_trigger_are_refused(sound_folder: Path) -> None:
    assert refused("--path", sound_folder, "--intent", "fly")[1] == "There is no intent fly."
    write_files(sound_folder, intents=SOUND.replace("{title}\n    says", "{title\n    says"))
    assert "Open '{' without '}'" in refused("--path", sound_folder)[1]


def test_a_folder_that_cannot_be_read_is_told(tmp_path: Path) -> None:
    assert "This file is missing." in refused("--path", tmp_path)[1]


def test_intents_of_families_have_places_too(small_folder: Path) -> None:
    text = "intents:\n- id: hug\n  en:\n    triggers:\n    - hug me\n"
    (small_folder / "intents_company.yaml").write_text(text)
    places = Places(small_folder)
    assert places.of("hug") == "content/intents_company.yaml:2: "
    assert places.of("hug", "hug me") == "content/intents_company.yaml:5: "
    assert places.of("<really>") == "content/intents.yaml:2: "
    assert places.of("nothing") == ""


def test_the_page_is_written_from_what_is_published(small_draft: Folder, tmp_path: Path) -> None:
    publish()
    page = tmp_path / "plans.md"
    assert run("plan_guide", "--output", page) == f"{page}: 1 intents.\n"
    assert page.read_text("utf-8") == plans_page(small_draft.base.library)


def test_the_page_is_written_from_a_folder(small_folder: Path, tmp_path: Path) -> None:
    page = tmp_path / "plans.md"
    run("plan_guide", "--output", page, "--path", small_folder)
    assert page.read_text("utf-8") == plans_page(read_folder(small_folder).base.library)


def test_nothing_published_is_told(empty_draft: None, tmp_path: Path) -> None:
    with pytest.raises(CommandError, match="Nothing is published yet"):
        run("plan_guide", "--output", tmp_path / "plans.md")


def test_the_page_on_plans_says_what_the_content_says() -> None:
    written = (ROOT / "docs" / "plans.md").read_text("utf-8")
    library = read_folder(ROOT / "content").base.library
    # One line only: the page is long, and `make plans` mends it.
    assert (written == plans_page(library)) is True, "docs/plans.md is old: run `make plans`"
