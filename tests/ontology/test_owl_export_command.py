"""export_owl, what it reads from the draft and from a release, and the setting of its IRI."""

import gzip
import os
import stat
from pathlib import Path

import pytest
from django.core.exceptions import ImproperlyConfigured
from django.core.management import CommandError, call_command
from pytest_django.fixtures import Settings as SettingsWrapper

from cair_site import environment
from dialogue.models import Publication, Sentence, Topic
from dialogue.snapshot import Snapshot, SnapshotError, checksum, pack
from ontology_io import exporting
from ontology_io.files.folder import Folder
from ontology_io.numbering import raise_last_numbers
from ontology_io.store import read_base
from tests.ontology.owl_readers import about, read_graph


def publish() -> Publication:
    base = read_base()
    data = pack(Snapshot(knowledge=base.knowledge, library=base.library))
    return Publication.objects.create(checksum=checksum(data), data=data)


def draft_bytes() -> bytes:
    return b"".join(exporting.export_draft())


def test_the_file_holds_the_draft(small_draft: Folder, tmp_path: Path) -> None:
    file = tmp_path / "cair.owl"
    call_command("export_owl", "--output", str(file))
    assert file.read_bytes() == draft_bytes()


def test_it_tells_what_it_wrote(
    small_draft: Folder, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "cair.owl"
    call_command("export_owl", "--output", str(file))
    said = capsys.readouterr()
    assert said.out == ""
    counts = exporting.draft().counts()
    assert counts["topics"] == 5
    assert counts["individuals"] == 10
    assert f"draft to {file}: 5 topics, 10 individuals, {counts['sentences']} sent" in said.err
    assert f"{file.stat().st_size} bytes" in said.err


def test_without_a_file_it_writes_to_standard_output(
    small_draft: Folder, capfdbinary: pytest.CaptureFixture[bytes]
) -> None:
    call_command("export_owl")
    assert capfdbinary.readouterr().out == draft_bytes()


def test_compressed_files_of_the_same_draft_are_the_same(
    small_draft: Folder, tmp_path: Path
) -> None:
    first, second = tmp_path / "first.owl.gz", tmp_path / "second.owl.gz"
    for file in (first, second):
        call_command("export_owl", "--gzip", "--output", str(file))
    assert first.read_bytes() == second.read_bytes()
    assert gzip.decompress(first.read_bytes()) == draft_bytes()


def test_a_release_says_what_it_said_when_it_was_published(
    small_draft: Folder, tmp_path: Path
) -> None:
    release = publish()
    before = b"".join(exporting.export_release(release.pk))
    Sentence.objects.filter(text="Do you like $hasName?").update(text="Changed since?")
    raise_last_numbers({"topic": 500})
    file = tmp_path / "release.owl"
    call_command("export_owl", "--release", str(release.pk), "--output", str(file))
    assert file.read_bytes() == before
    assert b"Changed since?" not in before
    assert b"Changed since?" in draft_bytes()


def test_draft_and_release_differ_in_the_header_only(small_draft: Folder) -> None:
    release = b"".join(exporting.export_release(publish().pk)).splitlines()
    draft = draft_bytes().splitlines()
    lines = {one for pair in zip(draft, release, strict=True) for one in pair if pair[0] != pair[1]}
    assert all(b"versionInfo" in line for line in lines)
    assert len(lines) == 2


def test_the_highest_numbers_ever_given_go_out(small_draft: Folder) -> None:
    raise_last_numbers({"topic": 500})
    said = about(read_graph(draft_bytes()), "", "urn:cair:kb")
    (numbers,) = (value for name, value in said if name == "highestNumbers")
    assert "topic=500 " in numbers


def test_the_iri_is_a_setting(small_draft: Folder, settings: SettingsWrapper) -> None:
    settings.CAIR_ONTOLOGY_IRI = "https://cair.example/kb?a&b"
    graph = read_graph(draft_bytes())
    assert ("id", "t2") in about(graph, "Tea", "https://cair.example/kb?a&b#")


def test_an_unknown_release_is_told_at_once(small_draft: Folder) -> None:
    with pytest.raises(Publication.DoesNotExist):
        exporting.export_release(7)
    with pytest.raises(CommandError, match="no release 7: nothing was published yet"):
        call_command("export_owl", "--release", "7")
    release = publish()
    with pytest.raises(CommandError, match=f"the last one is {release.pk}"):
        call_command("export_owl", "--release", str(release.pk + 1))


def test_a_damaged_release_is_told_at_once(small_draft: Folder) -> None:
    release = publish()
    Publication.objects.update(checksum="0" * 64)
    with pytest.raises(SnapshotError):
        exporting.export_release(release.pk)
    with pytest.raises(CommandError, match="damaged"):
        call_command("export_owl", "--release", str(release.pk))


def test_an_empty_draft_writes_nothing(empty_draft: None, tmp_path: Path) -> None:
    file = tmp_path / "cair.owl"
    with pytest.raises(CommandError, match="draft is empty"):
        call_command("export_owl", "--output", str(file))
    assert not file.exists()


def test_a_folder_that_is_missing_or_in_place_of_the_file_is_told(
    small_draft: Folder, tmp_path: Path
) -> None:
    with pytest.raises(CommandError, match="no folder"):
        call_command("export_owl", "--output", str(tmp_path / "no" / "cair.owl"))
    with pytest.raises(CommandError, match="is a folder"):
        call_command("export_owl", "--output", str(tmp_path))


def test_a_failed_export_leaves_the_old_file(small_draft: Folder, tmp_path: Path) -> None:
    Topic.objects.filter(key="Tea").update(note="broken \x01 note")
    file = tmp_path / "cair.owl"
    file.write_bytes(b"old")
    with pytest.raises(CommandError, match="XML cannot hold"):
        call_command("export_owl", "--output", str(file))
    assert file.read_bytes() == b"old"
    assert set(os.listdir(tmp_path)) == {file.name, "content"}


def test_the_file_keeps_its_permissions(small_draft: Folder, tmp_path: Path) -> None:
    file = tmp_path / "cair.owl"
    file.write_bytes(b"old")
    file.chmod(0o640)
    call_command("export_owl", "--output", str(file))
    assert stat.S_IMODE(file.stat().st_mode) == 0o640


@pytest.mark.parametrize(
    "value", ["urn:cair:kb", "https://cair.example/kb", "urn:uuid:0-1", "http://a.b/c?d=%20"]
)
def test_an_absolute_iri_names_the_ontology(value: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CAIR_ONTOLOGY_IRI", value)
    assert environment.ontology_iri("CAIR_ONTOLOGY_IRI", "urn:cair:kb") == value


@pytest.mark.parametrize(
    "value",
    [
        "kb",
        "/kb",
        "urn:",
        "https://",
        "https:///kb",
        "https://cair.example/kb#",
        "https://cair.example/kb#Tea",
        "https://cair.example/",
        "https://cair.example/a b",
        'https://cair.example/"',
        "https://cair.example/100%",
        "urn:cair:vocab",
        "http://www.w3.org/2002/07/owl",
        "http://caressesrobot.org/ontology",
    ],
)
def test_nonsense_stops_the_start_and_says_the_name(
    value: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CAIR_ONTOLOGY_IRI", value)
    with pytest.raises(ImproperlyConfigured, match="CAIR_ONTOLOGY_IRI is"):
        environment.ontology_iri("CAIR_ONTOLOGY_IRI", "urn:cair:kb")
