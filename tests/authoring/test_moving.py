"""Moving a topic: what it gains and loses beforehand, and what is refused."""

import pytest
from django.test import Client
from django.urls import reverse
from pytest_django import DjangoAssertNumQueries

from authoring.by_draft import forget_all
from authoring.history.history import Wanted, changes
from authoring.roles import ADMINISTRATOR, AUTHOR, PUBLISHER, RESEARCHER
from authoring.topic_page.shape import read_shape
from authoring.tree import move_preview
from authoring.tree.moving import CannotMoveError, Preview, move, preview
from dialogue.content import read_knowledge
from dialogue.draft import draft_version
from dialogue.engine.build import build_tree
from dialogue.models import Frame, Sentence, Topic
from tests.authoring.people import logged_in
from tests.authoring.tree_tests_help import number

pytestmark = pytest.mark.usefixtures("small_draft")


def seen(key: str, target: str) -> Preview:
    return preview(read_shape(), number(key), number(target) if target else None)


def keys(found: object) -> set[str]:
    return {one.key for one in found}  # type: ignore[attr-defined]


def said_by(key: str) -> set[str]:
    node = build_tree(read_knowledge()).by_key[key]
    return {line.key for lines in node.lines.values() for line in lines}


def address(key: str, **asked: str) -> str:
    return reverse("admin:tree_move", args=(key,), query=asked or None)


def looked_at(key: str, target: str) -> dict[str, str]:
    """Return what the page sends that shows the preview of a move away from Drink."""
    return {"to": target or "-", "seen": "Drink", "told": seen(key, target).fingerprint}


def test_a_topic_moved_to_the_root_loses_what_it_inherited() -> None:
    found = seen("Tea", "")
    assert keys(found.lost) == {"Drink.q1", "Drink.p1", "Drink.g1"}
    assert not found.gained
    assert found.moved == 2


def test_lost_sentences_are_shown_as_the_robot_says_them() -> None:
    texts = {one.key: one.text for one in seen("Milk", "Flower").lost}
    assert texts["Drink.q1"] == "Do you like milk?"
    assert "a cup of milk" in texts["Drink.p1"]


def test_what_the_preview_tells_comes_true() -> None:
    Sentence.objects.create(
        frame=Frame.objects.create(key="Flower.c1", topic_id=number("Flower"), type="c"),
        language="en",
        text="I like $hasName.",
    )
    before, found = said_by("GreenTea"), seen("GreenTea", "Flower")
    move(number("GreenTea"), number("Flower"), number("Tea"))
    after = said_by("GreenTea")
    assert keys(found.gained) == after - before == {"Flower.c1"}
    assert keys(found.lost) == before - after
    assert found.lost


def test_those_below_are_counted_too() -> None:
    (one,) = [one for one in seen("Tea", "").lost if one.key == "Drink.q1"]
    assert (one.topics, one.itself) == (2, True)


def test_a_sentence_that_only_those_below_lose_is_told_apart() -> None:
    Topic.objects.get(key="Tea").also.add(number("Drink"))
    (one,) = [one for one in seen("Tea", "").lost if one.key == "Drink.q1"]
    assert (one.topics, one.itself) == (1, False)
    assert one.text == "Do you like green tea?"


def test_what_is_lent_is_not_lost() -> None:
    Topic.objects.get(key="Milk").also.add(number("Drink"))
    assert "Drink.p1" not in keys(seen("Milk", "").lost)


def test_words_order_and_gentleness_that_change_are_told() -> None:
    found = seen("Milk", "Flower")
    assert {(one.name, one.old, one.new) for one in found.variables} >= {("unit", "a cup of", "")}
    assert found.old_pattern != found.new_pattern
    assert found.becomes_gentle


def test_a_sentence_that_can_no_longer_be_said_is_named() -> None:
    frame = Frame.objects.create(key="Milk.c1", topic_id=number("Milk"), type="c")
    Sentence.objects.create(frame=frame, language="en", text="Have $unit $hasName.bare.")
    (one,) = seen("Milk", "Flower").broken
    assert (one.key, one.topic) == ("Milk.c1", "Milk")
    assert "unit" in one.reason


def test_nothing_changes_between_places_that_say_the_same() -> None:
    assert seen("GreenTea", "Drink").changes_nothing


@pytest.mark.parametrize(("key", "target"), [("Drink", "GreenTea"), ("Drink", "Tea")])
def test_a_topic_cannot_go_below_itself(key: str, target: str) -> None:
    with pytest.raises(CannotMoveError, match=f"{key} cannot go below {target}"):
        move(number(key), number(target), None)
    assert Topic.objects.get(key=key).parent is None


def test_a_topic_cannot_be_its_own_parent_or_stay_where_it_is() -> None:
    with pytest.raises(CannotMoveError, match="itself"):
        seen("Drink", "Drink")
    with pytest.raises(CannotMoveError, match="already"):
        seen("Milk", "Drink")
    with pytest.raises(CannotMoveError, match="already"):
        seen("Drink", "")


def test_a_moved_topic_stands_after_its_new_neighbours() -> None:
    Topic.objects.filter(key="Flower").update(position=1)
    Topic.objects.filter(key="Milk").update(position=40)
    moved = move(number("Flower"), number("Drink"), None)
    assert moved.position == 41
    order = Topic.objects.filter(parent__key="Drink").values_list("key", flat=True)
    assert list(order)[-1] == "Flower"


def test_a_move_that_somebody_else_made_first_is_not_undone_silently() -> None:
    move(number("Milk"), number("Flower"), number("Drink"))
    with pytest.raises(CannotMoveError, match="in the meantime"):
        move(number("Milk"), None, number("Drink"))
    assert Topic.objects.get(key="Milk").parent_id == number("Flower")


def test_an_author_sees_the_preview_then_moves() -> None:
    client, version = logged_in(AUTHOR), draft_version()
    page = client.get(address("Milk", to="Flower")).content.decode()
    assert "Do you like milk?" in page
    assert draft_version() == version
    answer = client.post(address("Milk"), looked_at("Milk", "Flower"))
    assert (answer.status_code, answer["Location"]) == (302, "/admin/tree/?open=Milk")
    assert Topic.objects.get(key="Milk").parent_id == number("Flower")
    assert draft_version() > version
    (one,) = [one for one in changes(Wanted()) if one.fields]
    assert ("Drink", "Flower") in [(field.old, field.new) for field in one.fields]


def test_the_page_carries_what_its_preview_told() -> None:
    page = logged_in(AUTHOR).get(address("Milk", to="Flower")).content.decode()
    assert f'name="told" value="{looked_at("Milk", "Flower")["told"]}"' in page


def test_a_move_that_changes_something_else_by_now_is_shown_again() -> None:
    client, sent = logged_in(AUTHOR), looked_at("Milk", "Flower")
    Sentence.objects.filter(frame__key="Drink.q1", language="en").update(text="Is $hasName good?")
    answer = client.post(address("Milk"), sent)
    page = answer.content.decode()
    assert answer.status_code == 409
    assert "changes something else by now" in page
    assert "Is milk good?" in page
    assert Topic.objects.get(key="Milk").parent_id == number("Drink")
    assert client.post(address("Milk"), looked_at("Milk", "Flower")).status_code == 302


def test_a_move_whose_preview_nobody_saw_is_shown_first() -> None:
    answer = logged_in(AUTHOR).post(address("Milk"), {"to": "Flower", "seen": "Drink"})
    assert (answer.status_code, "What would change" in answer.content.decode()) == (409, True)
    assert Topic.objects.get(key="Milk").parent_id == number("Drink")


def test_another_topic_that_was_changed_meanwhile_does_not_hinder_a_move() -> None:
    sent = looked_at("Milk", "Flower")
    Topic.objects.filter(key="GreenTea").update(note="by the nurses")
    assert logged_in(AUTHOR).post(address("Milk"), sent).status_code == 302


def test_a_topic_becomes_a_branch() -> None:
    assert logged_in(PUBLISHER).post(address("Tea"), looked_at("Tea", "")).status_code == 302
    assert Topic.objects.get(key="Tea").parent is None


@pytest.mark.parametrize("to", ["", "Nowhere", "Té\0a", "x" * 5000, "<script>"])
def test_a_place_that_is_none_is_refused_in_a_sentence(to: str) -> None:
    answer = logged_in(AUTHOR).post(address("Milk"), {"to": to, "seen": "Drink"})
    assert answer.status_code == 409
    assert "There is no topic" in answer.content.decode()
    assert (
        "<script>" not in answer.content.decode().split("<main", 1)[-1].split("There is")[-1][:60]
    )
    assert Topic.objects.get(key="Milk").parent_id == number("Drink")


def test_a_circle_is_refused_on_the_page() -> None:
    answer = logged_in(AUTHOR).post(address("Drink"), {"to": "GreenTea", "seen": "-"})
    assert answer.status_code == 409
    assert "is itself below Drink" in answer.content.decode()


@pytest.mark.parametrize(
    ("role", "status"), [(AUTHOR, 200), (PUBLISHER, 200), (ADMINISTRATOR, 200), (RESEARCHER, 403)]
)
def test_only_who_may_change_topics_may_move_them(role: str, status: int) -> None:
    client = logged_in(role)
    assert client.get(address("Milk", to="Flower")).status_code == status
    if status == 403:
        assert client.post(address("Milk"), {"to": "-", "seen": "Drink"}).status_code == 403


def test_nobody_moves_anything() -> None:
    assert Client().post(address("Milk"), {"to": "-"}).status_code == 302
    assert logged_in("").post(address("Milk"), {"to": "-"}).status_code == 403
    assert Topic.objects.get(key="Milk").parent_id == number("Drink")


def test_a_topic_that_is_not_there_is_not_found() -> None:
    assert logged_in(AUTHOR).get(address("Nothing")).status_code == 404


def test_the_preview_takes_few_queries(
    django_assert_max_num_queries: DjangoAssertNumQueries,
) -> None:
    client = logged_in(AUTHOR)
    forget_all()
    with django_assert_max_num_queries(25):
        assert client.get(address("Tea", to="Flower", q="milk")).status_code == 200


def test_a_large_branch_is_told_like_a_small_one(
    monkeypatch: pytest.MonkeyPatch, django_assert_max_num_queries: DjangoAssertNumQueries
) -> None:
    client, small = logged_in(AUTHOR), seen("Drink", "Flower")
    monkeypatch.setattr(move_preview, "FEW", 0)
    assert seen("Drink", "Flower") == small
    with django_assert_max_num_queries(25):
        assert client.get(address("Tea", to="Flower")).status_code == 200
