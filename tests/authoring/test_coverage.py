"""The dashboard: honest numbers, each leading to exactly what it counts; the start page."""

import xml.etree.ElementTree as ET
from urllib.parse import parse_qsl, urlsplit

import pytest
from django.contrib import admin
from django.contrib.auth.models import User
from django.test import Client, RequestFactory
from django.urls import reverse
from pytest_django import DjangoAssertNumQueries

from authoring.admin.filters import FRAME_FILTERS, TOPIC_FILTERS
from authoring.by_draft import forget_all
from authoring.coverage import coverage_tables as tables
from authoring.coverage.charts import WIDTH, Series, columns, grouped, stacked
from authoring.coverage.coverage import (
    GAPS,
    KEYWORDS,
    MISSING,
    NAMES,
    SENTENCES,
    coverage,
    read_coverage,
)
from authoring.coverage.coverage_gaps import gaps
from authoring.roles import ADMINISTRATOR, AUTHOR, PUBLISHER, RESEARCHER
from dialogue.content import read_knowledge
from dialogue.engine.build import build_tree
from dialogue.engine.saying import NEVER_WHEN_GENTLE
from dialogue.models import Culture, Frame, KeywordSet, Sentence, Topic, TopicName
from tests.admin.pages import send
from tests.authoring.people import logged_in
from tests.authoring.tree_tests_help import number

pytestmark = pytest.mark.usefixtures("small_draft")


@pytest.fixture(autouse=True)
def _new_draft() -> None:
    forget_all()


def listed(address: str) -> int:
    """Return how many rows the list at an address shows, with our filters among its own."""
    parts = urlsplit(address)
    model = Frame if "/frame/" in parts.path else Topic
    ours = FRAME_FILTERS if model is Frame else TOPIC_FILTERS
    usual = type(admin.site.get_model_admin(model))
    known = [one for one in usual.list_filter if one not in ours]
    page = type("Narrowed", (usual,), {"list_filter": (*known, *ours)})(model, admin.site)
    request = RequestFactory().get(address)
    request.user = User.objects.get_or_create(username="root", is_superuser=True)[0]
    shown = page.get_changelist_instance(request)
    assert dict(parse_qsl(parts.query)).keys() <= {
        *shown.params,
        *(name for spec in shown.filter_specs for name in spec.expected_parameters()),
    }
    return int(shown.result_count)


def spoil() -> None:
    """Make something of everything missing."""
    TopicName.objects.get(topic__key="Milk", language="it").delete()
    Sentence.objects.get(frame__key="GreenTea.c1", language="ja").delete()
    KeywordSet.objects.filter(topic__key="Tea", language="en").delete()
    KeywordSet.objects.filter(topic__key="Flower").delete()
    frame = Frame.objects.get(key="Drink.q1")
    frame.only.add(Culture.objects.get(code="JP"))


def every_table() -> list[tables.Table]:
    found = read_coverage()
    return [
        tables.language_table(found),
        *(tables.kind_table(found, code) for code in ("en", "it", "ja")),
        tables.missing_table(found),
        tables.liking_table(found),
        tables.depth_table(found),
    ]


def test_every_number_leads_to_a_list_of_so_many_rows() -> None:
    spoil()
    checked = 0
    for table in every_table():
        for row in (*table.rows, *([table.total] if table.total else [])):
            for head, cell in zip(table.heads, row.cells, strict=True):
                assert listed(cell.url) == int(cell.text), (table.name, row.name, str(head))
                checked += 1
    assert checked > 100


def test_numbers_of_cultures_lead_to_their_rows_too() -> None:
    spoil()
    table = tables.culture_table(read_coverage())
    assert table.total
    for row in (*table.rows, table.total):
        for place in (0, 1, 3, 4):
            assert listed(row.cells[place].url) == int(row.cells[place].text), (row.name, place)


def test_the_numbers_are_those_of_the_draft() -> None:
    drink, flower = read_coverage().branches
    assert (drink.key, drink.topics, flower.topics) == ("Drink", 4, 1)
    assert drink.sentences("it") == 4
    assert drink.said["en", "q"] == 1
    jp = Culture.objects.get(code="JP").pk
    assert (drink.only[jp], drink.homes[jp]) == (1, 1)
    assert drink.mean_liking(jp) == pytest.approx((0.5 * 3 + 0.7) / 4)


def test_branches_without_anything_stay_visible() -> None:
    Topic.objects.create(key="Empty")
    rows = tables.language_table(read_coverage()).rows
    (empty,) = [row for row in rows if row.name == "Empty"]
    assert [(cell.text, cell.share, cell.tone) for cell in empty.cells[1:3]] == [
        ("0", "0 %", "zero"),
        ("0", "0 %", "zero"),
    ]


def test_what_is_missing_is_counted() -> None:
    before = read_coverage().total
    spoil()
    after = read_coverage().total
    grown = {column: after.missing[column] - before.missing[column] for column in MISSING}
    assert (grown[NAMES], grown[SENTENCES], grown[KEYWORDS]) == (1, 1, 2)


def test_missing_kinds_are_those_that_the_tree_lacks() -> None:
    Topic.objects.filter(key="Tea").update(stop="q")
    Topic.objects.get(key="Flower").also.add(number("GreenTea"))
    found, tree = read_coverage().gaps, build_tree(read_knowledge())
    for node in tree.nodes.values():
        asked = {letter for steps in node.patterns for letter, optional in steps if not optional}
        asked = asked - {"r"} | {"p", "n"} if "r" in asked else asked
        if node.gentle:
            asked -= {*NEVER_WHEN_GENTLE, "p", "n"}
        lacking = {letter for letter in asked if not node.lines.get(letter)}
        assert found.get(node.number, frozenset()) == lacking, node.key
    assert "q" in found[number("GreenTea")]
    assert "c" not in found[number("Flower")]


def test_gaps_of_topics_nobody_knows_are_none() -> None:
    from authoring.topic_page.shape import Shape

    assert gaps(Shape({}, {}, {}), {}) == {}


def test_the_numbers_are_kept_until_the_draft_changes(
    django_assert_max_num_queries: DjangoAssertNumQueries,
) -> None:
    first = coverage()
    with django_assert_max_num_queries(1):
        assert coverage() is first
    TopicName.objects.get(topic__key="Milk", language="it").delete()
    assert coverage().total.missing[NAMES] == first.total.missing[NAMES] + 1


def test_bars_share_one_scale_and_stay_inside_the_picture() -> None:
    rows = [Series("a", (10, 30)), Series("b", (20, 0)), Series("none", (0, 0))]
    chart = stacked("c", ("t", "d"), [("q", "yes/no"), ("w", "open")], rows)
    wide = {piece.told: piece.width for piece in chart.pieces}
    assert wide["a: open 30"] == pytest.approx(3 * wide["a: yes/no 10"], abs=2)
    assert wide["b: yes/no 20"] == pytest.approx(2 * wide["a: yes/no 10"], abs=2)
    assert all(piece.x + piece.width <= WIDTH for piece in chart.pieces)
    assert "none" in {label.text for label in chart.labels}


def test_upright_bars_begin_at_nothing() -> None:
    chart = columns("c", ("t", "d"), [Series("x", (0,)), Series("y", (5,))], most=10)
    low, high = (piece.height for piece in chart.pieces)
    assert (low, high) == (1, 60)


def test_charts_of_nothing_are_drawn() -> None:
    assert stacked("c", ("t", "d"), [], []).pieces == ()
    assert grouped("c", ("t", "d"), [("en", "English")], []).pieces == ()
    assert columns("c", ("t", "d"), [], most=0).pieces == ()


def test_charts_have_a_title_a_description_and_whole_numbers() -> None:
    page = logged_in(AUTHOR).get(reverse("admin:coverage"), headers={"accept-language": "it"})
    html = page.content.decode()
    pictures = html.split('<svg role="img"')[1:]
    assert len(pictures) >= 5
    for picture in pictures:
        svg = ET.fromstring(f"<svg{picture.split('</svg>')[0]}</svg>")  # noqa: S314 - our own
        assert svg.findtext("title")
        assert svg.findtext("desc")
        for bar in svg.iter("rect"):
            assert all(bar.attrib[name].isdecimal() for name in ("x", "y", "width", "height"))


@pytest.mark.parametrize("language", ["en", "it", "ja", "xx", "<b>"])
def test_the_language_of_kinds_is_chosen(language: str) -> None:
    answer = logged_in(AUTHOR).get(reverse("admin:coverage"), {"language": language})
    assert answer.status_code == 200
    assert "<b>" not in answer.content.decode()


@pytest.mark.parametrize("nonsense", ["JP-x", "-3", "JP-12", "9" * 50, "-", "%00"])
def test_nonsense_in_a_filter_narrows_nothing(nonsense: str) -> None:
    everything = Topic.objects.count()
    for name in ("liking", "gap", "named", "links"):
        address = f"{reverse('admin:dialogue_topic_changelist')}?{name}={nonsense}"
        request = RequestFactory().get(address)
        for one in TOPIC_FILTERS:
            if one.parameter_name == name:
                spec = one(request, {name: [nonsense]}, Topic, None)
                assert spec.queryset(request, Topic.objects.all()).count() == everything


def test_the_dashboard_takes_few_queries(
    django_assert_max_num_queries: DjangoAssertNumQueries,
) -> None:
    client = logged_in(AUTHOR)
    with django_assert_max_num_queries(25):
        assert client.get(reverse("admin:coverage")).status_code == 200
    with django_assert_max_num_queries(6):
        client.get(reverse("admin:coverage"))


def test_the_start_page_tells_what_to_do_and_what_i_wrote() -> None:
    spoil()
    client = logged_in(AUTHOR, "Maria")
    send(client, reverse("admin:dialogue_topic_change", args=(number("Tea"),)), note="looked at")
    page = client.get(reverse("admin:index")).content.decode()
    assert "1 change is not published yet." in page
    assert "Maria" in page
    assert "Topics without a name in some language: 1" in page
    assert reverse("admin:tree") in page
    other = logged_in(AUTHOR, "Ugo").get(reverse("admin:index")).content.decode()
    assert "You have changed nothing since then." in other


@pytest.mark.parametrize("role", [AUTHOR, PUBLISHER, RESEARCHER, ADMINISTRATOR])
def test_every_role_sees_dashboard_and_start_page(role: str) -> None:
    client = logged_in(role)
    assert client.get(reverse("admin:coverage")).status_code == 200
    page = client.get(reverse("admin:index")).content.decode()
    assert ("publish it" in page) == (role in (PUBLISHER, ADMINISTRATOR))


def test_nobody_sees_numbers() -> None:
    assert Client().get(reverse("admin:coverage")).status_code == 302
    client = logged_in("")
    assert client.get(reverse("admin:coverage")).status_code == 403
    start = client.get(reverse("admin:index"))
    assert start.status_code == 200
    assert "What to do next" not in start.content.decode()


@pytest.mark.usefixtures("empty_draft")
def test_an_empty_draft_has_a_start_page_and_a_dashboard() -> None:
    Sentence.objects.all().delete()
    Topic.objects.update(parent=None)
    Topic.objects.all().delete()
    client = logged_in(AUTHOR)
    assert "Add the first topic" in client.get(reverse("admin:index")).content.decode()
    assert client.get(reverse("admin:coverage")).status_code == 200
    assert client.get(reverse("admin:tree")).status_code == 200


def test_kinds_that_are_missing_are_found_in_the_list() -> None:
    assert read_coverage().total.missing[GAPS] == listed(
        f"{reverse('admin:dialogue_topic_changelist')}?gap=any"
    )
