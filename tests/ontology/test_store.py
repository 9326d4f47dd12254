"""The draft says what was loaded; only what differs is written, all of it or nothing."""

from pathlib import Path

import msgspec
import pytest
from django.db import IntegrityError, connection
from django.test.utils import CaptureQueriesContext
from pytest_django import DjangoAssertNumQueries

from dialogue import models
from dialogue.content import read_knowledge
from dialogue.engine.concepts import Topic
from ontology_io import store
from ontology_io.files.folder import Folder, folder_texts, read_folder, write_folder
from ontology_io.numbering import last_numbers
from ontology_io.records import KnowledgeBase
from ontology_io.store import read_base, write_base
from plans.models import Intent
from tests.ontology.small_content import CULTURES, DRINK, FLOWER, INTENTS, write_files


def load(folder: Path, **files: str) -> list[str]:
    """Load the small content with some files changed; return the statements that write."""
    read = read_folder(write_files(folder, **files))
    with CaptureQueriesContext(
        connection,
    ) as queries:
        write_base(read.base, read.last)
    words = ("INSERT", "UPDATE", "DELETE")
    return [query["sql"] for query in queries if query["sql"].startswith(words)]


def topics() -> dict[str, Topic]:
    return {topic.key: topic for topic in read_knowledge().topics}


def without_numbers(base: KnowledgeBase) -> dict[str, str]:
    return {
        name: text for name, text in folder_texts(base, last_numbers()).items() if "tsv" not in name
    }


def test_the_draft_says_what_was_loaded(small_draft: Folder) -> None:
    assert without_numbers(read_base()) == without_numbers(small_draft.base)


def test_loading_again_writes_nothing(small_draft: Folder, small_folder: Path) -> None:
    assert load(small_folder) == []


def test_what_was_dumped_loads_without_a_write(small_draft: Folder, tmp_path: Path) -> None:
    write_folder(tmp_path, read_base(), last_numbers())
    dumped = read_folder(tmp_path)
    assert dumped.base == read_base()
    assert not write_base(dumped.base, dumped.last)


def test_a_changed_topic_writes_only_itself(small_draft: Folder, small_folder: Path) -> None:
    number = models.Topic.objects.get(key="Milk").pk
    written = load(small_folder, drink=DRINK.replace("milk", "warm milk"))
    assert topics()["Milk"].names["en"]["name"] == "warm milk"
    assert 0 < len(written) < 30
    others = set(models.Topic.objects.exclude(pk=number).values_list("key", flat=True))
    assert not [sql for sql in written for key in others if f"'{key}'" in sql]


def test_a_topic_put_first_moves_the_others_without_writing_them(
    small_draft: Folder, small_folder: Path
) -> None:
    before = models.TopicName.objects.get(topic__key="Milk", language="en").pk
    first = DRINK.replace("- {id: Milk", "- {id: Cocoa, is_a: Drink}\n- {id: Milk")
    load(small_folder, drink=first)
    assert list(topics()) == ["Drink", "Tea", "Cocoa", "Milk", "GreenTea", "Flower"]
    assert models.TopicName.objects.get(topic__key="Milk", language="en").pk == before


def test_a_renamed_topic_keeps_its_number_and_its_sentences(
    small_draft: Folder, tmp_path: Path
) -> None:
    write_folder(tmp_path, read_base(), last_numbers())
    before = topics()["GreenTea"]
    for file in (tmp_path / "drink.yaml", tmp_path / "numbers.tsv"):
        file.write_text(file.read_text().replace("GreenTea", "Sencha"))
    renamed = read_folder(tmp_path)
    write_base(renamed.base, renamed.last)
    after = topics()["Sencha"]
    assert (after.number, after.frames[0].number) == (before.number, before.frames[0].number)
    assert after.frames[0].key == "Sencha.c1"
    assert "GreenTea" not in topics()


def test_a_class_goes_with_what_is_below_it(small_draft: Folder, small_folder: Path) -> None:
    (small_folder / "drink.yaml").unlink()
    load(small_folder, drink="", flower=FLOWER.replace(", see: [Drink]", ""))
    assert list(topics()) == ["Flower"]
    assert not models.Frame.objects.exclude(topic=None).exists()


def test_a_class_goes_and_its_children_move_up(small_draft: Folder, small_folder: Path) -> None:
    number = topics()["GreenTea"].number
    head, tail = DRINK.split("- id: Tea\n")
    leaves = tail.partition("leaves:")[2].replace("is_a: Tea", "is_a: Drink")
    load(small_folder, drink=f"{head}leaves:{leaves}".replace(", see: [Tea]", ""))
    assert "Tea" not in topics()
    assert (topics()["GreenTea"].is_a, topics()["GreenTea"].number) == ("Drink", number)


def test_hundreds_of_topics_go_with_their_class(
    small_draft: Folder, small_folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(store, "BATCH", 2)
    rows = "".join(f"- {{id: Rose{place}, is_a: Flower}}\n" for place in range(9))
    load(small_folder, flower=FLOWER + rows)
    load(small_folder, flower="leaves:\n- {id: Elm, is_a: Topic}\n")
    assert list(topics())[-1] == "Elm"
    assert not models.Topic.objects.filter(key__startswith="Rose").exists()


def test_a_culture_that_is_gone_goes(small_draft: Folder, small_folder: Path) -> None:
    only_english = CULTURES.partition("- {code: JP")[0]
    drink = DRINK.replace(", of: JP", "").replace(", only: [JP]", "")
    files = {"cultures": only_english, "drink": drink.replace("like: EN .4, ", "")}
    load(small_folder, **files)
    assert [culture.code for culture in read_knowledge().cultures] == ["EN"]
    assert topics()["Milk"].likeliness == {"EN": 0.5}
    assert load(small_folder, **files) == []


def test_intents_and_pools_follow_the_files(small_draft: Folder, small_folder: Path) -> None:
    number = Intent.objects.get(key="playsong").pk
    pools = (small_folder / "pools.yaml").read_text()
    more = pools.replace(
        "  s:\n", "  s:\n    2:\n      en: Hi.\n      it: Ciao.\n      ja: どうも。\n", 1
    )
    stop = INTENTS + INTENTS.partition("intents:\n")[2].replace("playsong", "stopsong")
    load(small_folder, pools=more, intents=stop.replace("Let us listen", "We listen"))
    assert [frame.key for frame in read_knowledge().pools["start"]] == ["start.2", "start.1"]
    assert Intent.objects.get(key="playsong").pk == number
    load(small_folder, pools=pools, intents=INTENTS)
    assert without_numbers(read_base()) == without_numbers(small_draft.base)
    assert Intent.objects.count() == 1


def test_an_error_in_the_middle_leaves_the_draft_as_it_was(
    small_draft: Folder, small_folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    before, last = read_base(), last_numbers()

    def fail(*arguments: object) -> None:
        raise IntegrityError("The disk is full.")

    monkeypatch.setattr(store, "write_library", fail)
    with pytest.raises(IntegrityError):
        load(
            small_folder,
            drink=DRINK.replace("milk", "warm milk"),
            flower=FLOWER + "- {id: Elm, is_a: Topic}\n",
        )
    assert read_base() == before
    assert last_numbers() == last


def test_reading_the_draft_takes_the_same_queries_whatever_its_size(
    small_draft: Folder, small_folder: Path, django_assert_num_queries: DjangoAssertNumQueries
) -> None:
    with CaptureQueriesContext(connection) as few:
        read_base()
    rows = "".join(f"- {{id: Rose{place}, is_a: Flower}}\n" for place in range(60))
    load(small_folder, flower=FLOWER + rows)
    with django_assert_num_queries(len(few)):
        assert len(read_base().knowledge.topics) == 65


def test_a_topic_without_individuals_has_the_usual_likeliness(small_draft: Folder) -> None:
    models.TopicInstance.objects.all().delete()
    assert topics()["Milk"].likeliness == {"EN": 0.5, "JP": 0.5}
    assert topics()["GreenTea"].likeliness == {"EN": 0.3, "JP": 0.7}


def test_blanks_around_keywords_do_not_count(small_draft: Folder) -> None:
    models.KeywordSet.objects.filter(topic__key="Tea", language="en").update(first="tea | cuppa|")
    assert topics()["Tea"].keywords["en"] == (("tea", "cuppa"), ("*",))


def test_records_survive_the_database_whole(small_draft: Folder) -> None:
    base = read_base()
    copy = msgspec.msgpack.decode(msgspec.msgpack.encode(base), type=KnowledgeBase)
    write_base(copy)
    assert read_base() == base == copy


def test_lent_sentences_are_kept_in_order(small_draft: Folder, small_folder: Path) -> None:
    load(small_folder, flower=FLOWER.replace("gentle: yes", "also: [Tea, Drink], gentle: yes"))
    assert topics()["Flower"].also == ("Tea", "Drink")
    assert "also: [Tea, Drink]" in without_numbers(read_base())["flower.yaml"]
    load(small_folder, flower=FLOWER)
    assert topics()["Flower"].also == ()


def test_an_individual_may_have_a_name_of_its_own(small_draft: Folder, small_folder: Path) -> None:
    assert topics()["Milk"].individuals == {}
    named = DRINK.replace("- {id: Milk, ", "- {id: Milk, individuals: {JP: JP_MORNINGMILK}, ", 1)
    assert named != DRINK
    load(small_folder, drink=named)
    assert topics()["Milk"].individuals == {"JP": "JP_MORNINGMILK"}
    assert "individuals: {JP: JP_MORNINGMILK}" in without_numbers(read_base())["drink.yaml"]
