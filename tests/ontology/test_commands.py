"""load_content, dump_content and check_content, as they are typed."""

from io import StringIO
from pathlib import Path

import pytest
from django.core.management import CommandError, call_command
from django.db import connection
from django.test.utils import CaptureQueriesContext

from dialogue import models
from ontology_io.files.folder import Folder
from ontology_io.store import read_base
from tests.ontology.small_content import DRINK, FLOWER, INTENTS, write_files


def run(command: str, *arguments: object) -> str:
    output = StringIO()
    call_command(command, *map(str, arguments), stdout=output)
    return output.getvalue()


def refused(command: str, *arguments: object) -> str:
    with pytest.raises(CommandError) as caught:
        run(command, *arguments)
    return str(caught.value)


def test_loading_tells_what_it_changed(empty_draft: None, small_folder: Path) -> None:
    output = run("load_content", small_folder)
    assert "5 topics added: Drink, Tea, Milk, GreenTea, Flower" in output
    assert "1 intents added: playsong" in output
    assert output.endswith("Loaded.\n")
    assert run("load_content", small_folder) == "Nothing to change.\n"


def test_a_dry_run_writes_nothing(small_draft: Folder, small_folder: Path) -> None:
    write_files(small_folder, drink=DRINK.replace("milk", "warm milk"))
    before = read_base()
    with CaptureQueriesContext(connection) as queries:
        output = run("load_content", small_folder, "--dry-run")
    assert "1 topics changed: Milk" in output
    assert "Nothing was written (dry run)." in output
    assert all(query["sql"].startswith("SELECT") for query in queries)
    assert read_base() == before


def test_what_cannot_be_read_is_not_loaded(small_draft: Folder, small_folder: Path) -> None:
    write_files(small_folder, flower="leaves: [", drink=DRINK.replace("like: EN .4", "like: EN 4"))
    before = read_base()
    message = refused("load_content", small_folder)
    assert message.startswith("Nothing was loaded.\ncontent/drink.yaml:33: 'EN 4' must be")
    assert "content/flower.yaml:" in message
    assert read_base() == before


@pytest.mark.parametrize(
    ("files", "expected"),
    [
        ({"flower": FLOWER.replace("[Drink]", "[Cake]")}, "content/flower.yaml:2: D005 Flower: "),
        (
            {"flower": FLOWER.replace("n: p, bare", "n: x, bare")},
            "content/flower.yaml:2: D011 Flower:",
        ),
        ({"drink": DRINK.replace("$unit", "$units", 1)}, "content/drink.yaml:25: D022 Tea: "),
        ({"drink": DRINK.replace("$hasName?", "$hasName.x?", 1)}, "drink.yaml:11: D021 Drink.q1:"),
        ({"drink": DRINK.replace("playsong", "fly")}, "content/drink.yaml:20: D025 Drink.g1: "),
        ({"intents": INTENTS.replace("{title}", "{song}", 1)}, "P001 playsong: playsong"),
        (
            {"drink": DRINK.replace("tea|cuppa", "tea|" + "cuppa " * 334)},
            "content/drink.yaml:25: D028 Tea: A set of keywords in en has 2007 characters; 2000",
        ),
        (
            {"intents": INTENTS.replace("[the song]", "[the song]" * 51)},
            "D028 playsong: A trigger in en has 532 characters; 500 are the most.",
        ),
    ],
)
def test_errors_are_told_with_file_and_line(
    small_draft: Folder, small_folder: Path, files: dict[str, str], expected: str
) -> None:
    before = read_base()
    message = refused("load_content", write_files(small_folder, **files))
    assert message.startswith("Nothing was loaded: ")
    assert expected in message
    assert read_base() == before


def test_a_dump_changes_no_byte_of_what_was_loaded(
    small_draft: Folder, small_folder: Path, tmp_path: Path
) -> None:
    assert run("dump_content", small_folder) == "Changed: numbers.tsv\n"
    assert run("dump_content", small_folder) == "Nothing changed.\n"
    run("dump_content", tmp_path / "copy")
    for file in small_folder.iterdir():
        assert (tmp_path / "copy" / file.name).read_bytes() == file.read_bytes()


def test_what_an_expert_did_in_the_admin_comes_back_from_files(
    small_draft: Folder, small_folder: Path
) -> None:
    milk = models.Topic.objects.get(key="Milk")
    models.Topic.objects.create(key="SoyMilk", parent=milk)
    models.Topic.objects.create(key="Elm")
    run("dump_content", small_folder)
    before = read_base()
    assert "Elm" in (small_folder / "elm.yaml").read_text()
    assert not models.Topic.objects.filter(key="SoyMilk").exclude(parent=milk)
    assert "has no name" in refused("load_content", small_folder)
    assert read_base() == before


def test_the_check_of_files_asks_no_database(small_folder: Path) -> None:
    message = refused("check_content", small_folder)
    assert message.startswith("content/numbers.tsv lacks ")
    assert "numbers, first of Drink: run `make content`" in message


def test_the_check_passes_on_what_was_dumped(small_draft: Folder, small_folder: Path) -> None:
    run("dump_content", small_folder)
    told = run("check_content", small_folder).splitlines()
    assert told[-1].startswith("5 topics, 0 errors, ")


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("drinks.yaml", DRINK),
        ("flower.yaml", FLOWER.replace("\n", "\r\n")),
        ("compose.yaml", "leaves: []\n"),
        ("intents.yaml", f"# a remark\n{INTENTS}"),
    ],
)
def test_the_check_names_a_file_that_is_not_canonical(
    small_draft: Folder, small_folder: Path, name: str, text: str
) -> None:
    run("dump_content", small_folder)
    if name == "drinks.yaml":
        (small_folder / "drink.yaml").unlink()
    (small_folder / name).write_bytes(text.encode())
    message = refused("check_content", small_folder)
    assert message.endswith(
        "is not in the canonical form: run `make content` and commit what it changes."
    )
    assert message.startswith(f"content/{name}".removesuffix("s.yaml"))


def test_the_check_tells_errors_with_their_place(small_draft: Folder, small_folder: Path) -> None:
    run("dump_content", small_folder)
    write_files(small_folder, flower=FLOWER.replace("[Drink]", "[Cake]"))
    output = StringIO()
    with pytest.raises(CommandError, match="1 errors"):
        call_command("check_content", str(small_folder), stdout=output)
    assert output.getvalue().startswith("content/flower.yaml:2: D005 Flower: Its link 'Cake'")


def test_the_check_tells_what_cannot_be_read(small_folder: Path) -> None:
    write_files(small_folder, flower="leaves: [")
    assert refused("check_content", small_folder).startswith("content/flower.yaml:2: This is no Y")
