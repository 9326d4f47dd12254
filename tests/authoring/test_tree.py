"""The tree browser: levels as they are opened, search, panel, with and without a script."""

import pytest
from django.test import Client
from django.urls import reverse
from pytest_django import DjangoAssertNumQueries

from authoring.by_draft import forget_all
from authoring.checks.findings import check_now
from authoring.roles import ADMINISTRATOR, AUTHOR, PUBLISHER, RESEARCHER
from authoring.topic_page.shape import read_shape
from authoring.tree.topic_search import MOST_HITS, fold, search
from authoring.tree.tree_browser import TreeNode, children_of, summary
from dialogue.models import Sentence, Topic, TopicName
from tests.authoring.people import logged_in
from tests.authoring.tree_tests_help import number

pytestmark = pytest.mark.usefixtures("small_draft")


@pytest.fixture(autouse=True)
def _new_draft() -> None:
    forget_all()


@pytest.fixture
def author() -> Client:
    return logged_in(AUTHOR)


def nodes(key: str = "", *open_: str) -> dict[str, TreeNode]:
    found = children_of(read_shape(), number(key) if key else None, [number(one) for one in open_])
    return {node.key: node for node in found}


def get(client: Client, name: str, *args: str, **asked: str) -> str:
    answer = client.get(reverse(f"admin:{name}", args=args), asked)
    assert answer.status_code == 200
    return answer.content.decode()


def found_keys(text: str) -> list[str]:
    shape = read_shape()
    return [shape.keys[hit.number] for hit in search(text)[0]]


def test_branches_come_first_and_nothing_below_them() -> None:
    found = nodes()
    assert list(found) == ["Drink", "Flower"]
    assert found["Drink"].opened is None
    assert (found["Drink"].own, found["Drink"].below, found["Drink"].children) == (3, 3, 2)


def test_a_node_tells_its_place_for_a_screen_reader() -> None:
    tea = nodes("Drink")["Tea"]
    assert (tea.level, tea.size) == (2, 2)
    assert {node.place for node in nodes("Drink").values()} == {1, 2}


def test_the_path_to_a_topic_is_opened() -> None:
    drink = nodes("", "Tea", "Drink")["Drink"]
    tea = {node.key: node for node in drink.opened or ()}["Tea"]
    assert [node.key for node in tea.opened or ()] == ["GreenTea"]


def test_a_missing_name_and_a_missing_translation_are_badges() -> None:
    TopicName.objects.get(topic__key="Drink", language="it").delete()
    Sentence.objects.get(frame__key="Drink.q1", language="ja").delete()
    words = [badge.words for badge in nodes()["Drink"].badges]
    assert words == ["no name in Italian", "translations missing: 1"]


def test_gentle_topics_and_topics_of_a_culture_are_marked() -> None:
    assert [badge.words for badge in nodes()["Flower"].badges] == ["gentle"]
    assert [badge.words for badge in nodes("Tea")["GreenTea"].badges] == ["Japanese"]


def test_what_the_last_check_found_is_a_badge() -> None:
    Sentence.objects.filter(frame__key="Drink.q1", language="en").update(text="Do $nothing?")
    check_now()
    assert any(badge.kind == "bad" for badge in nodes()["Drink"].badges)


def test_likeliness_is_told_in_each_culture() -> None:
    hints = nodes("Tea")["GreenTea"].likeliness
    assert [(hint.code, hint.value, hint.percent) for hint in hints] == [
        ("EN", 0.4, 40),
        ("JP", 0.7, 70),
    ]


def test_names_are_in_the_language_of_the_admin(author: Client) -> None:
    answer = author.get(reverse("admin:tree"), headers={"accept-language": "it"})
    assert "bevande" in answer.content.decode()


@pytest.mark.parametrize(
    ("text", "first"),
    [
        ("green tea", "GreenTea"),
        ("TE VERDE", "GreenTea"),
        ("緑茶", "GreenTea"),
        ("リョクチャ", "GreenTea"),
        ("greentea", "GreenTea"),
        ("cuppa", "Tea"),
        ("tea", "Tea"),
        ("bevande", "Drink"),
    ],
)
def test_a_topic_is_found_by_name_key_and_keyword(text: str, first: str) -> None:
    assert found_keys(text)[0] == first


def test_nonsense_finds_nothing() -> None:
    for text in ("", "   ", "\0", "zzz", "%", "*", "x" * 100_000):
        assert found_keys(text) == []


def test_a_search_sees_what_was_changed_just_now() -> None:
    assert found_keys("matcha") == []
    name = TopicName.objects.get(topic__key="GreenTea", language="en")
    name.name = "matcha"
    name.save()
    assert found_keys("matcha") == ["GreenTea"]


def test_at_most_fifty_hits_are_shown_and_all_are_counted(author: Client) -> None:
    Topic.objects.bulk_create(Topic(key=f"Many{place}") for place in range(70))
    forget_all()
    hits, total = search("many")
    assert (len(hits), total) == (MOST_HITS, 70)
    assert "70 topics found, the best 50 shown" in get(author, "tree_found", q="many")


def test_folding_keeps_japanese_sounds_apart() -> None:
    assert fold("Tè VERDE") == "te verde"
    assert fold("カ") == fold("か") != fold("が")


def test_hits_come_with_those_above_them(author: Client) -> None:
    page = get(author, "tree_found", q="green")
    assert "drinks › tea › green tea" in " ".join(page.split())
    assert "open=GreenTea" in page


def test_hits_while_moving_lead_to_the_preview(author: Client) -> None:
    assert "/admin/tree/move/Milk/?to=Flower" in get(
        author, "tree_found", q="flower", moving="Milk"
    )


def test_hostile_words_are_told_back_harmlessly(author: Client) -> None:
    page = get(author, "tree", q="<script>alert(1)</script>", open='"><img src=x>')
    assert "<script>alert" not in page
    assert "<img src=x" not in page
    assert "There is no topic" in page


def test_without_a_script_every_node_is_a_link(author: Client) -> None:
    page = get(author, "tree")
    assert 'href="/admin/tree/?open=Drink"' in page
    assert "GreenTea" not in page
    assert "GreenTea" in get(author, "tree", open="Tea")


def test_the_tree_speaks_to_assistive_technology(author: Client) -> None:
    page = get(author, "tree", open="Tea")
    assert page.count('role="tree"') == 1
    assert page.count('role="treeitem"') == 5
    assert page.count('aria-expanded="true"') == 2
    assert page.count('aria-selected="true"') == 1


def test_a_level_comes_as_a_piece(author: Client) -> None:
    piece = get(author, "tree_below", "Drink")
    assert piece.count('role="treeitem"') == 2
    assert "<html" not in piece


def test_the_panel_leads_on(author: Client) -> None:
    piece = get(author, "tree_panel", "GreenTea")
    there = number("GreenTea")
    assert reverse("admin:dialogue_topic_change", args=(there,)) in piece
    assert f"{reverse('admin:dialogue_topic_add')}?parent={there}" in piece
    assert reverse("admin:tree_move", args=("GreenTea",)) in piece
    assert f"{reverse('admin:chat')}?topic=GreenTea" in piece
    assert "In Japan, visitors are often served green tea." in piece


def test_the_summary_counts_kinds_and_links() -> None:
    told = summary(read_shape(), number("Drink"))
    assert dict(told.own_kinds) == {"q": 1, "p": 1, "g": 1}
    assert summary(read_shape(), number("GreenTea")).links == (("Milk", "milk"),)


def test_a_researcher_may_look_but_is_offered_no_change() -> None:
    page = get(logged_in(RESEARCHER), "tree", open="Tea")
    assert "Open the topic" in page
    assert "tree/move/" not in page
    assert "Add a topic below" not in page


@pytest.mark.parametrize("role", [AUTHOR, PUBLISHER, RESEARCHER, ADMINISTRATOR])
def test_every_role_finds_the_tree_in_the_menu(role: str) -> None:
    assert '<a href="/admin/tree/"' in get(logged_in(role), "tree")


def test_nobody_sees_the_tree() -> None:
    pieces = [("tree", ()), ("tree_found", ()), ("tree_below", ("Tea",)), ("tree_panel", ("Tea",))]
    for name, args in pieces:
        address = reverse(f"admin:{name}", args=args)
        assert Client().get(address).status_code == 302
    client = logged_in("")
    assert client.get(reverse("admin:tree")).status_code == 403


def test_unknown_topics_are_not_found(author: Client) -> None:
    for name in ("tree_below", "tree_panel"):
        assert author.get(reverse(f"admin:{name}", args=("Nothing",))).status_code == 404


def test_a_circle_in_the_draft_does_not_hang_the_tree(author: Client) -> None:
    Topic.objects.filter(key="Drink").update(parent=number("GreenTea"))
    assert "Flower" in get(author, "tree")
    assert get(author, "tree", open="Tea")


def test_opening_a_level_takes_ten_queries_at_most(
    author: Client, django_assert_max_num_queries: DjangoAssertNumQueries
) -> None:
    with django_assert_max_num_queries(10):
        get(author, "tree_below", "Drink")


def test_the_whole_page_takes_few_queries(
    author: Client, django_assert_max_num_queries: DjangoAssertNumQueries
) -> None:
    with django_assert_max_num_queries(25):
        get(author, "tree", open="GreenTea", q="tea")
