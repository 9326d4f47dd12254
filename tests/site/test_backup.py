"""A backup is brought back whole, by number and letter, or not at all."""

import gzip
import hashlib
import io
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from django.contrib.auth import get_user_model
from django.contrib.auth.models import User
from django.core.management import CommandError, call_command
from django.db.models import ForeignKey

from authoring.models import ApiKey, CheckRun, Conversation, PublishRun
from cair_site.backup import file as backup_file
from cair_site.backup.file import BackupError, Reader
from cair_site.backup.tables import fields, tables
from dialogue import models
from dialogue.publishing import load, publish
from ontology_io.files.folder import Folder
from ontology_io.numbering import last_numbers
from ontology_io.store import read_base
from plans.models import Intent
from tests.ontology.emptying import empty_apps

Lines = list[Any]


@pytest.fixture
def backup(small_draft: Folder, tmp_path: Path) -> Path:
    """Return a backup of a draft that is published once."""
    publish(note="The first drinks")
    return backed_up(tmp_path / "cair.backup.gz")


def backed_up(path: Path) -> Path:
    call_command("backup_content", str(path), stdout=io.StringIO())
    return path


def restored(path: Path, *options: str) -> str:
    said = io.StringIO()
    call_command("restore_content", str(path), *options, stdout=said)
    return said.getvalue()


def lines_of(path: Path) -> Lines:
    return [json.loads(line) for line in gzip.decompress(path.read_bytes()).splitlines()]


def written(path: Path, lines: Lines) -> Path:
    """Write lines with the checksum that they should have."""
    text = b"".join(json.dumps(line).encode() + b"\n" for line in lines[:-1])
    end = {"rows": len(lines) - 2, "sha256": hashlib.sha256(text).hexdigest()}
    path.write_bytes(gzip.compress(text + json.dumps(end).encode() + b"\n"))
    return path


def change_milk(name: str) -> None:
    models.TopicName.objects.filter(topic__key="Milk", language="en").update(name=name)


def releases() -> list[tuple[object, ...]]:
    rows = models.Publication.objects.values_list("pk", "created", "note", "checksum", "data")
    return [(*row[:-1], bytes(row[-1])) for row in rows]


def test_an_empty_database_gets_the_same_draft_releases_and_numbers(backup: Path) -> None:
    before = read_base(), releases(), last_numbers(), models.DraftVersion.objects.values().get()
    empty_apps("dialogue", "plans")
    restored(backup)
    after = read_base(), releases(), last_numbers(), models.DraftVersion.objects.values().get()
    assert after == before
    assert load().tree.by_key["Milk"].names["en"].forms[""] == "milk"


def test_numbers_of_deleted_rows_are_not_given_again(backup: Path, tmp_path: Path) -> None:
    gone = Intent.objects.create(key="gone")
    Intent.objects.filter(pk=gone.pk).delete()
    again = backed_up(tmp_path / "again.gz")
    empty_apps("dialogue", "plans")
    restored(again)
    assert Intent.objects.create(key="new").pk > gone.pk


def test_the_same_content_gives_the_same_bytes(backup: Path, tmp_path: Path) -> None:
    assert backed_up(tmp_path / "again.gz").read_bytes() == backup.read_bytes()


def test_only_its_owner_may_read_it(backup: Path) -> None:
    assert backup.stat().st_mode & 0o077 == 0


def test_conversations_and_the_history_are_in_it(backup: Path, tmp_path: Path) -> None:
    Conversation.objects.create(title="Tea", language="en", culture="EN", seed=2**32 - 1)
    history = list(models.DraftVersion.history.values())
    assert history
    again = backed_up(tmp_path / "again.gz")
    empty_apps("dialogue", "plans", "authoring")
    restored(again)
    assert Conversation.objects.values_list("title", "seed").get() == ("Tea", 2**32 - 1)
    assert list(models.DraftVersion.history.values()) == history


def test_content_is_not_written_over_without_a_word(backup: Path) -> None:
    change_milk("warm milk")
    before = read_base()
    with pytest.raises(CommandError, match=r"There is content already, e\.g\. .*--replace"):
        restored(backup)
    assert read_base() == before


def test_replacing_brings_the_content_back(backup: Path) -> None:
    before, first = read_base(), releases()
    change_milk("warm milk")
    restored(backup, "--replace")
    assert (read_base(), releases()) == (before, first)


def test_after_replacing_nodes_see_another_release_and_pages_another_draft(backup: Path) -> None:
    change_milk("warm milk")
    second = publish()
    models.DraftVersion.objects.update(number=900)
    CheckRun.objects.create(draft=901)
    PublishRun.objects.create(draft=901, step="reading", running=True, publication=second)
    restored(backup, "--replace")
    newest = models.Publication.objects.all()[0]
    assert (newest.pk, newest.note) == (second.pk + 1, f"Back to {second.pk - 1}")
    assert load().tree.by_key["Milk"].names["en"].forms[""] == "milk"
    assert models.DraftVersion.objects.get().number == 901
    assert not CheckRun.objects.exists()
    assert not PublishRun.objects.exists()
    assert models.DraftVersion.history.first().history_change_reason == (
        "content restored from a backup"
    )


def test_a_release_of_the_same_number_that_says_something_else_is_seen(backup: Path) -> None:
    number = models.Publication.objects.get().pk
    models.Publication.objects.update(checksum="0" * 64)
    restored(backup, "--replace")
    assert models.Publication.objects.all()[0].pk > number


def test_accounts_sessions_and_keys_are_not_in_it(backup: Path, tmp_path: Path) -> None:
    person = User.objects.create_user(
        "anna", "anna@example.org", "correct horse", last_name="Rossi"
    )
    User.objects.create_user("bystander", None, "battery staple")
    ApiKey.objects.create(label="day room", prefix="cair_abcd", digest="d" * 64)
    models.Publication.objects.update(author=person)
    text = gzip.decompress(backed_up(tmp_path / "again.gz").read_bytes()).decode()
    assert "anna" in text
    secret = ("example.org", "Rossi", "pbkdf2", person.password, "bystander", "cair_abcd", "dddddd")
    assert [word for word in secret if word in text] == []


def test_who_wrote_what_is_linked_again_by_name(backup: Path, tmp_path: Path) -> None:
    people = get_user_model()._default_manager
    models.Publication.objects.update(author=people.create_user("anna"))
    again = backed_up(tmp_path / "again.gz")
    people.all().delete()
    other, anna = people.create_user("berta"), people.create_user("anna")
    restored(again, "--replace")
    assert models.Publication.objects.get().author == anna
    people.filter(username="anna").delete()
    restored(again, "--replace")
    assert models.Publication.objects.get().author is None
    assert other.pk


def change(place: int) -> Callable[[bytes], bytes]:
    return lambda data: data[:place] + bytes((data[place] ^ 1,)) + data[place + 1 :]


@pytest.mark.parametrize(
    ("damage", "told"),
    [
        (lambda data: b"", "not complete"),
        (lambda data: b"garbage", "damaged or no backup"),
        (lambda data: gzip.compress(b"garbage"), "no backup|not complete"),
        (lambda data: gzip.compress(b"{}\n{}\n"), "no backup|not complete"),
        (lambda data: data[: len(data) // 2], "damaged or no backup"),
        (lambda data: data[:-9], "damaged or no backup"),
        (change(1000), "damaged|no backup"),
        (lambda data: data + gzip.compress(b"[]\n"), "not complete"),
        (lambda data: gzip.compress(gzip.decompress(data).replace(b"milk", b"silk")), "checksum"),
        (lambda data: gzip.compress(gzip.decompress(data).rpartition(b"\n{")[0]), "not complete"),
    ],
)
def test_a_damaged_file_changes_nothing(
    backup: Path, damage: Callable[[bytes], bytes], told: str
) -> None:
    before = read_base(), releases()
    backup.write_bytes(damage(backup.read_bytes()))
    with pytest.raises(CommandError, match=f"Nothing was restored: .*({told})"):
        restored(backup, "--replace")
    assert (read_base(), releases()) == before


def edited(path: Path, edit: Callable[[Lines], object]) -> Path:
    lines = lines_of(path)
    edit(lines)
    return written(path, lines)


def first_row(lines: Lines, label: str) -> Lines:
    row = next(line for line in lines if isinstance(line, list) and line[0] == label)
    assert isinstance(row, list)
    return row


@pytest.mark.parametrize(
    ("edit", "told"),
    [
        (lambda lines: lines[0].update(version=2), "has format 2"),
        (lambda lines: lines[0].update(format="zip"), "no backup"),
        (lambda lines: lines[0].update(more=1), "first line of the backup is damaged"),
        (lambda lines: lines[0]["migrations"]["dialogue"].pop(), "tables of dialogue were others"),
        (lambda lines: lines[0]["migrations"].pop("plans"), "tables of plans were others"),
        (lambda lines: lines[0]["tables"].pop("dialogue.topic"), "tables of the backup are others"),
        (lambda lines: lines.insert(1, ["auth.user", 1]), "no table 'auth.user'"),
        (lambda lines: lines.insert(1, []), "A row of the backup is damaged"),
        (lambda lines: lines.insert(1, {"a": 1}), "A row of the backup is damaged"),
        (lambda lines: first_row(lines, "dialogue.topic").pop(), "row of dialogue.topic has"),
        (
            lambda lines: first_row(lines, "dialogue.topic").__setitem__(1, "x"),
            "value of dialogue.topic.id cannot be read",
        ),
        (
            lambda lines: lines.append(lines[-1]) or lines.insert(1, lines[1]),
            "the database refused it",
        ),
        (
            lambda lines: first_row(lines, "dialogue.topicname").__setitem__(2, 999_999),
            "the database refused it|cannot be read",
        ),
    ],
)
def test_what_does_not_fit_changes_nothing(
    backup: Path, edit: Callable[[Lines], object], told: str
) -> None:
    before = read_base(), releases()
    with pytest.raises(CommandError, match=told):
        restored(edited(backup, edit), "--replace")
    assert (read_base(), releases()) == before


def test_a_link_to_nothing_changes_nothing(backup: Path) -> None:
    place = 1 + [field.attname for field in fields(models.TopicName)].index("topic_id")
    before = read_base()
    edited(backup, lambda lines: first_row(lines, "dialogue.topicname").__setitem__(place, 99_999))
    with pytest.raises(CommandError, match="the database refused it"):
        restored(backup, "--replace")
    assert read_base() == before


def test_a_file_that_inflates_without_end_is_refused_early(tmp_path: Path, db: None) -> None:
    bomb = tmp_path / "bomb.gz"
    bomb.write_bytes(gzip.compress(b" " * 3 * 2**20))
    with pytest.raises(CommandError, match="holds more than 1 MiB; see --largest"):
        restored(bomb, "--largest", "1")


def test_a_line_without_end_is_refused(backup: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(backup_file, "LONGEST_LINE", 100)
    with backup.open("rb") as opened, pytest.raises(BackupError, match="longer than 100 bytes"):
        Reader(opened).header()


def test_a_backup_that_cannot_be_written_leaves_the_old_one(
    backup: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = backup.read_bytes()
    monkeypatch.setattr(backup_file, "LONGEST_LINE", 100)
    with pytest.raises(CommandError, match="longer than 100 bytes"):
        backed_up(backup)
    assert backup.read_bytes() == before
    assert [path.name for path in backup.parent.glob("*.gz*")] == [backup.name]


def test_a_folder_that_is_not_there_is_told(db: None, tmp_path: Path) -> None:
    with pytest.raises(CommandError, match="cannot be written: No such file"):
        backed_up(tmp_path / "nowhere" / "cair.gz")
    with pytest.raises(CommandError, match="cannot be read: No such file"):
        restored(tmp_path / "nowhere.gz")


def test_content_points_to_content_or_to_people_alone() -> None:
    known = {*tables().values(), get_user_model()}
    outside = [
        str(field)
        for model in tables().values()
        for field in fields(model)
        if isinstance(field, ForeignKey) and field.related_model not in known
    ]
    assert outside == []
