"""Imports one at a time: who, how far, and nothing written unless all of it is."""

import os
import sqlite3
import subprocess
import sys
from datetime import timedelta
from io import StringIO
from pathlib import Path

import pytest
from django.contrib.auth.models import User
from django.core.management import CommandError, call_command
from django.utils import timezone
from rdflib import Literal

from dialogue.models import DraftVersion, Topic
from ontology_io import import_runs, importing
from ontology_io.import_runs import BusyError, NotReadyError, begin, carry_out, discard, resume
from ontology_io.models import ImportRun
from ontology_io.remainder import remainder_text
from ontology_io.store import read_base
from tests.ontology.owl_edits import CAIR, KB, XSD_DECIMAL, Edited, exported

ROOT = Path(__file__).resolve().parents[2]
pytestmark = pytest.mark.usefixtures("small_draft")


def warmer() -> bytes:
    """Return an export in which English people like milk more."""
    edit = Edited()
    edit.set(KB.EN_MILK, CAIR.hasLikeliness, Literal("0.9", datatype=XSD_DECIMAL))
    return edit.data()


def milk() -> float:
    topics = read_base().knowledge.topics
    return next(topic.likeliness["EN"] for topic in topics if topic.key == "Milk")


def test_a_run_is_looked_at_then_written() -> None:
    maria = User.objects.create_user("maria")
    run = carry_out(begin(maria.pk, "tea.owl", warmer()))
    assert (run.step, run.running, run.applied) == ("ready", None, False)
    assert run.result["counts"] == {"topics": {"changed": 1}}
    assert run.result["changes"][0]["details"] == ["likeliness EN: 0.5 → 0.9"]
    assert milk() == 0.5
    run = carry_out(resume(run.pk), apply=True)
    run.refresh_from_db()
    assert (run.step, run.applied, bytes(run.data)) == ("done", True, b"")
    assert milk() == 0.9
    line = DraftVersion.history.first()
    assert line.history_change_reason == "ontology imported from tea.owl"
    assert line.history_user == maria


def test_a_program_may_have_it_written_at_once() -> None:
    assert carry_out(begin(None, "", warmer()), apply=True).step == "done"
    assert milk() == 0.9


def test_the_second_is_told_who_is_importing() -> None:
    maria = User.objects.create_user("maria")
    begin(maria.pk, "tea.owl", b"")
    with pytest.raises(BusyError, match="maria is importing an ontology since") as caught:
        begin(None, "", b"")
    assert caught.value.run is not None
    assert caught.value.run.file_name == "tea.owl"


def test_nobody_begins_to_write_while_another_import_goes_on() -> None:
    ready = carry_out(begin(None, "", warmer()))
    begin(None, "", b"")
    with pytest.raises(BusyError):
        resume(ready.pk)


def test_a_run_whose_process_is_gone_does_not_block_for_ever() -> None:
    lost = begin(None, "", warmer())
    ImportRun.objects.update(beat=timezone.now() - timedelta(minutes=10))
    other = begin(None, "", warmer())
    carry_out(lost, apply=True)
    assert (lost.step, lost.running, bytes(lost.data)) == ("lost", None, b"")
    assert milk() == 0.5
    other.refresh_from_db()
    assert other.running is True


def test_a_run_is_discarded() -> None:
    ready = carry_out(begin(None, "", warmer()))
    assert discard(ready.pk)
    assert not discard(ready.pk)
    with pytest.raises(NotReadyError):
        resume(ready.pk)


def test_a_draft_that_has_changed_since_is_not_written_over() -> None:
    ready = carry_out(begin(None, "", warmer()))
    Topic.objects.get(key="Flower").save()
    run = carry_out(resume(ready.pk), apply=True)
    assert (run.step, run.applied) == ("changed", False)
    assert milk() == 0.5


def test_a_file_with_errors_is_refused_with_all_of_them() -> None:
    edit = Edited()
    edit.set(KB.EN_MILK, CAIR.hasLikeliness, Literal("1.7", datatype=XSD_DECIMAL))
    edit.rename("Flower", "Flower_Pot")
    run = carry_out(begin(None, "", edit.data()), apply=True)
    assert (run.step, run.applied) == ("refused", False)
    assert {one["where"] for one in run.result["problems"] if one["error"]} >= {"EN_MILK"}
    assert milk() == 0.5


def test_what_is_no_ontology_is_refused_with_a_sentence() -> None:
    run = carry_out(begin(None, "", b"<html></html>"), apply=True)
    assert run.step == "refused"
    assert len(run.result["problems"]) == 1


def test_a_failure_while_writing_changes_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    before = read_base()
    edit = Edited(warmer())
    edit.add(KB.Milk, CAIR.unheard, Literal("of"))

    def fail(_text: str) -> None:
        raise OSError("disk full")

    monkeypatch.setattr(importing, "keep_remainder", fail)
    run = carry_out(begin(None, "", edit.data()), apply=True)
    run.refresh_from_db()
    assert (run.step, run.running, run.applied) == ("failed", None, False)
    assert read_base() == before
    assert remainder_text() == ""


def test_old_runs_are_forgotten_and_undecided_ones_emptied() -> None:
    ready = carry_out(begin(None, "", warmer()))
    ImportRun.objects.update(started=timezone.now() - timedelta(days=30))
    for _ in range(3):
        carry_out(begin(None, "", b""))
    ready.refresh_from_db()
    assert (ready.step, bytes(ready.data)) == (import_runs.CANCELLED, b"")


def imported(*arguments: object) -> str:
    output = StringIO()
    call_command("import_owl", *map(str, arguments), stdout=output)
    return output.getvalue()


def test_the_command_shows_first_and_writes_with_apply(tmp_path: Path) -> None:
    file = tmp_path / "tea.owl"
    file.write_bytes(warmer())
    output = imported(file)
    assert "topics: 1 changed" in output
    assert "    likeliness EN: 0.5 → 0.9" in output
    assert output.endswith("Nothing was written (dry run); add --apply.\n")
    assert milk() == 0.5
    User.objects.create_user("maria")
    assert imported(file, "--apply", "--author", "maria").endswith("Imported into the draft.\n")
    assert milk() == 0.9
    assert imported(file).startswith("0 changes.")


def test_the_command_refuses_with_what_to_do(tmp_path: Path) -> None:
    file = tmp_path / "tea.owl"
    file.write_bytes(b"Prefix: : <urn:x>")
    with pytest.raises(CommandError, match=r"Nothing was written\."):
        imported(file)
    with pytest.raises(CommandError, match="cannot be read"):
        imported(tmp_path / "none.owl")
    with pytest.raises(CommandError, match="no user 'ghost'"):
        imported(file, "--author", "ghost")


def test_the_command_reads_gzip_but_no_bomb(tmp_path: Path) -> None:
    import gzip

    file = tmp_path / "tea.owl.gz"
    file.write_bytes(gzip.compress(exported()))
    assert imported(file).startswith("0 changes.")
    file.write_bytes(gzip.compress(bytes(100_000_000), 9))
    with pytest.raises(CommandError, match="larger than"):
        imported(file)
    file.write_bytes(gzip.compress(exported())[:-100])
    with pytest.raises(CommandError, match="ends too early"):
        imported(file)


KILLED = """
import os, signal, sys
import django
django.setup()
from ontology_io import importing, store
step = sys.argv[2]
def kill(*_args, **_more):
    os.kill(os.getpid(), signal.SIGKILL)
if step == "comparing":
    importing.compared = kill
elif step == "writing":
    store.write_library = kill
elif step == "written":
    importing.keep_remainder = kill
from django.core.management import call_command
call_command("run_import", sys.argv[1], "--apply")
"""


@pytest.mark.parametrize("step", ["comparing", "writing", "written"])
def test_an_import_that_is_killed_leaves_the_draft_as_it_was(step: str, tmp_path: Path) -> None:
    database = tmp_path / "kill.sqlite3"
    environment = os.environ | {
        "DATABASE_URL": f"sqlite://{database}",
        "DJANGO_SETTINGS_MODULE": "cair_site.settings",
        "CAIR_VAR": str(tmp_path),
    }

    def python(*arguments: str) -> "subprocess.CompletedProcess[str]":
        return subprocess.run(
            [sys.executable, *arguments],
            cwd=ROOT,
            env=environment,
            capture_output=True,
            text=True,
            timeout=120,
            check=False,
        )

    made = python("manage.py", "migrate", "--verbosity=0", "--skip-checks")
    assert made.returncode == 0, made.stderr
    data = warmer()
    begun = python(
        "-c",
        "import django, sys; django.setup(); from ontology_io.import_runs import begin;"
        "print(begin(None, 'tea.owl', open(sys.argv[1], 'rb').read()).pk)",
        str(_file(tmp_path, data)),
    )
    number = begun.stdout.strip()
    killed = python("-c", KILLED, number, step)
    assert killed.returncode == -9, killed.stderr
    with sqlite3.connect(database) as connection:
        assert connection.execute("SELECT count(*) FROM dialogue_topic").fetchone() == (0,)
        assert connection.execute("SELECT count(*) FROM plans_intent").fetchone() == (0,)
        connection.execute("UPDATE ontology_io_importrun SET beat = '2020-01-01 00:00:00'")
    connection.close()
    again = python("manage.py", "import_owl", str(tmp_path / "tea.owl"), "--apply", "--skip-checks")
    assert again.stdout.endswith("Imported into the draft.\n"), again.stderr
    with sqlite3.connect(database) as connection:
        steps = connection.execute("SELECT step FROM ontology_io_importrun ORDER BY id")
        assert steps.fetchall() == [("lost",), ("done",)]
    connection.close()


def _file(folder: Path, data: bytes) -> Path:
    path = folder / "tea.owl"
    path.write_bytes(data)
    return path
