"""Publishing: only a draft without errors, numbers and slots for ever, and a way back."""

import threading
from collections.abc import Iterator
from io import StringIO
from pathlib import Path

import pytest
from django.core.management import CommandError, call_command
from pytest_django import DjangoAssertNumQueries

from dialogue import models, publishing
from dialogue.content import read_knowledge
from dialogue.publishing import (
    NothingPublishedError,
    NotPublishableError,
    load,
    publish,
    refresh,
    roll_back,
)
from dialogue.snapshot import Snapshot, SnapshotError, checksum, pack, unpack
from ontology_io.files.folder import Folder, read_folder
from ontology_io.store import write_base
from tests.ontology.small_content import DRINK, write_files


@pytest.fixture(autouse=True)
def _nothing_served() -> Iterator[None]:
    """Serve nothing before and after, and never start the thread that looks for more."""
    publishing.serve(None)
    yield
    publishing.serve(None)


def change_milk(name: str) -> None:
    models.TopicName.objects.filter(topic__key="Milk", language="en").update(name=name)


def break_the_draft() -> None:
    models.Topic.objects.create(key="Elm")


def slots() -> dict[str, int]:
    return dict(models.Frame.objects.exclude(topic=None).values_list("key", "slot"))


def test_a_draft_is_published_with_its_counts(small_draft: Folder) -> None:
    row = publish(note="The first drinks")
    assert row.counts == {"topics": 5, "frames": 4, "sentences": 12, "intents": 1}
    assert (row.note, row.author) == ("The first drinks", None)
    assert load().tree.by_key["Milk"].names["en"].forms[""] == "milk"


def test_a_draft_with_errors_is_refused_and_nothing_changes(small_draft: Folder) -> None:
    break_the_draft()
    with pytest.raises(NotPublishableError, match=r"D010 Elm: It has no name in en\.") as caught:
        publish()
    assert {finding.code for finding in caught.value.findings} == {"D010"}
    assert not models.Publication.objects.exists()
    assert set(slots().values()) == {-1}


def test_the_same_draft_gives_the_same_publication(small_draft: Folder) -> None:
    first = publish()
    assert publish(note="again").pk == first.pk
    change_milk("warm milk")
    assert publish().pk != first.pk


def test_the_same_knowledge_gives_the_same_bytes(small_draft: Folder, small_folder: Path) -> None:
    first = publish()
    again = read_folder(small_folder)
    write_base(again.base, again.last)
    assert publish().pk == first.pk


def test_what_is_not_published_is_not_served(small_draft: Folder) -> None:
    publish()
    change_milk("warm milk")
    assert load().tree.by_key["Milk"].names["en"].forms[""] == "milk"
    assert publishing.draft().tree.by_key["Milk"].names["en"].forms[""] == "warm milk"


def test_a_draft_with_errors_cannot_be_tried_out(small_draft: Folder) -> None:
    break_the_draft()
    with pytest.raises(NotPublishableError):
        publishing.draft()


def test_slots_are_given_once_and_never_move(small_draft: Folder, tmp_path: Path) -> None:
    publish()
    before = slots()
    assert set(before.values()) == {0, 1, 2, 3}
    line = '- {at: GreenTea, id: c0, en: "Sip.", it: "Bevi.", ja: "飲みます。"}\n'
    more = DRINK.replace("lines:\n", f"lines:\n{line}")
    write_base(read_folder(write_files(tmp_path, drink=more)).base)
    assert slots() == {**before, "GreenTea.c0": -1}
    publish()
    assert slots() == {**before, "GreenTea.c0": 4}


def test_a_folder_without_slots_does_not_take_them_away(
    small_draft: Folder, tmp_path: Path
) -> None:
    publish()
    before = slots()
    write_base(read_folder(write_files(tmp_path, drink=DRINK.replace("Lovely", "Nice"))).base)
    assert slots() == before
    assert "Nice" in read_knowledge().topics[0].frames[1].texts["en"]


def test_a_removed_slot_may_serve_again_but_a_number_never(small_draft: Folder) -> None:
    publish()
    line = models.Frame.objects.get(key="GreenTea.c1")
    number, tea = line.pk, line.topic
    line.delete()
    new = models.Frame.objects.create(key="GreenTea.c2", topic=tea, type="c")
    assert new.pk > number


def test_nothing_published_is_said_so(empty_draft: None) -> None:
    with pytest.raises(NothingPublishedError, match=r"run manage\.py publish"):
        load()
    with pytest.raises(NothingPublishedError, match="There is no publication 7"):
        roll_back(7)
    assert not refresh()


def test_rolling_back_publishes_the_old_content_again(small_draft: Folder) -> None:
    first = publish()
    change_milk("warm milk")
    second = publish()
    back = roll_back(first.pk)
    assert (back.pk > second.pk, back.checksum, back.note) == (
        True,
        first.checksum,
        f"Back to {first.pk}",
    )
    assert back.counts == first.counts
    assert load().tree.by_key["Milk"].names["en"].forms[""] == "milk"
    assert load(second.pk).tree.by_key["Milk"].names["en"].forms[""] == "warm milk"


def test_a_damaged_publication_is_not_rolled_back_to(small_draft: Folder) -> None:
    first = publish()
    data = bytes(first.data)[:-9] + b"something"
    models.Publication.objects.filter(pk=first.pk).update(data=data)
    with pytest.raises(SnapshotError, match="damaged"):
        roll_back(first.pk)
    assert models.Publication.objects.count() == 1


def test_a_damaged_publication_is_not_served(small_draft: Folder) -> None:
    row = publish()
    models.Publication.objects.filter(pk=row.pk).update(data=bytes(row.data)[:-1] + b"x")
    with pytest.raises(SnapshotError, match="its checksum differs"):
        load()


def test_refresh_swaps_only_where_there_is_something_newer(
    small_draft: Folder, django_assert_num_queries: DjangoAssertNumQueries
) -> None:
    first = publish()
    assert refresh()
    served = publishing._served.content
    assert served is not None
    assert served.number == first.pk
    with django_assert_num_queries(1):
        assert not refresh()
    change_milk("warm milk")
    second = publish()
    assert refresh()
    assert publishing._served.content is not served
    assert publishing._served.content.number == second.pk
    assert served.tree.by_key["Milk"].names["en"].forms[""] == "milk"


def test_a_newer_publication_that_is_damaged_leaves_the_old_one_served(small_draft: Folder) -> None:
    first = publish()
    refresh()
    models.Publication.objects.create(checksum="no", data=b"CAIR")
    with pytest.raises(SnapshotError):
        refresh()
    assert publishing._served.content is not None
    assert publishing._served.content.number == first.pk


def test_serving_asks_the_database_nothing(
    small_draft: Folder,
    django_assert_num_queries: DjangoAssertNumQueries,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(publishing._served, "watcher", threading.current_thread())
    publish()
    refresh()
    with django_assert_num_queries(0):
        assert publishing.current() is publishing._served.content


def run_publish(*arguments: str) -> str:
    output = StringIO()
    call_command("publish", *arguments, stdout=output)
    return output.getvalue()


def test_the_command_publishes_and_rolls_back(small_draft: Folder) -> None:
    first = publish()
    change_milk("warm milk")
    said = run_publish("--note", "Warm")
    assert said.endswith("5 topics, 4 frames, 12 sentences, 1 intents.\n")
    newest = models.Publication.objects.first()
    assert newest is not None
    assert newest.note == "Warm"
    assert run_publish("--roll-back", str(first.pk)).startswith(f"Publication {newest.pk + 1}: ")


def test_the_command_tells_every_error(small_draft: Folder) -> None:
    break_the_draft()
    with pytest.raises(CommandError, match="Nothing was published") as caught:
        run_publish()
    assert str(caught.value).count("D010 Elm: It has no name") == 3
    with pytest.raises(CommandError, match="There is no publication 99"):
        run_publish("--roll-back", "99")


def test_a_snapshot_is_read_as_it_was_packed(small_draft: Folder) -> None:
    snapshot = Snapshot(knowledge=small_draft.base.knowledge, library=small_draft.base.library)
    data = pack(snapshot)
    assert unpack(data, checksum(data)) == snapshot
    assert pack(snapshot) == data


@pytest.mark.parametrize(
    "data", [b"", b"CAIR", b"CAIR\x02", b"CAIR\x01", b"CAIR\x01nozip", b"PK\x03\x04\x01abc"]
)
def test_what_is_no_snapshot_is_refused(data: bytes) -> None:
    with pytest.raises(SnapshotError, match="Publish again"):
        unpack(data, checksum(data))


def test_other_bytes_than_were_stored_are_refused() -> None:
    with pytest.raises(SnapshotError, match="damaged"):
        unpack(b"CAIR", checksum(b"tea"))
