"""The steps of the quick tour, and the language that a person has chosen."""

import pytest
from django.urls import reverse

from authoring.roles import AUTHOR, RESEARCHER
from authoring.tour import tour_steps
from tests.authoring.people import logged_in

NAMES = ("tree", "chat", "checks", "publish", "releases")


def test_every_step_points_at_a_place_of_the_menu() -> None:
    menu = [reverse(f"admin:{name}") for name in NAMES]
    assert [step.url for step in tour_steps(menu)] == ["", *menu]


def test_a_step_is_left_out_where_its_page_is_not_in_the_menu() -> None:
    tree = reverse("admin:tree")
    assert [step.url for step in tour_steps([tree])] == ["", tree]


def test_without_a_menu_there_is_no_tour() -> None:
    assert tour_steps([]) == []


@pytest.mark.django_db
def test_the_tour_is_on_the_pages_but_not_in_small_windows() -> None:
    client = logged_in(RESEARCHER)
    address = reverse("admin:dialogue_topic_changelist")
    assert 'id="tour"' in client.get(address).content.decode()
    assert 'id="tour"' not in client.get(f"{address}?_popup=1").content.decode()


@pytest.mark.django_db
def test_the_chosen_language_is_kept_and_leads_back() -> None:
    client = logged_in(AUTHOR)
    answer = client.post(reverse("set_language"), {"language": "it", "next": "/admin/tree/?q=tea"})
    assert answer.headers["Location"] == "/admin/tree/?q=tea"
    assert 'lang="it"' in client.get("/admin/").content.decode()


@pytest.mark.django_db
@pytest.mark.parametrize("elsewhere", ["https://elsewhere.example/", "//elsewhere.example/"])
def test_choosing_a_language_never_leads_elsewhere(elsewhere: str) -> None:
    answer = logged_in(AUTHOR).post(reverse("set_language"), {"language": "ja", "next": elsewhere})
    assert "elsewhere" not in answer.headers["Location"]
