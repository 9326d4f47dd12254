"""The quick tour, and the choice of the language of the admin."""

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from tests.browser.admin.conftest import Desk
from tests.browser.admin.test_axe import AXE, RUN

pytestmark = pytest.mark.browser

FORGET = """if (!sessionStorage.visited) {
  localStorage.removeItem("cair.tour");
  sessionStorage.visited = "yes";
}"""


@pytest.fixture
def page(desk: Desk, opened: Callable[..., Page]) -> Page:
    """Return the start page as somebody finds it who has never been here."""
    page = opened("publisher")
    page.goto("/admin/tree/")
    page.add_init_script(
        f"if (!sessionStorage.visited) {{ {FORGET}; sessionStorage.visited = 1; }}"
    )
    page.goto("/admin/")
    return page


def test_the_first_visit_begins_the_tour_and_the_second_does_not(page: Page) -> None:
    tour = page.get_by_role("dialog")
    expect(tour).to_be_visible()
    expect(tour).to_have_accessible_name("Welcome!")
    page.keyboard.press("Escape")
    expect(tour).to_be_hidden()
    expect(page.locator("#start-tour")).to_be_focused()
    page.reload()
    expect(page.locator("#start-tour")).to_be_visible()
    expect(tour).to_be_hidden()


def test_the_tour_is_taken_with_the_keyboard_alone(page: Page) -> None:
    tour = page.get_by_role("dialog")
    steps = tour.locator("section")
    for number in range(steps.count()):
        expect(steps.nth(number)).to_be_visible()
        expect(steps.nth(number).locator("h2")).to_be_focused()
        focused = "document.activeElement.dataset.tour === 'next'"
        while not page.evaluate(focused):
            page.keyboard.press("Tab")
        page.keyboard.press("Enter")
    expect(tour).to_be_hidden()
    expect(page.locator("#start-tour")).to_be_focused()


@pytest.mark.parametrize("width", [1280, 820])
def test_each_step_points_at_its_place_inside_the_window(page: Page, width: int) -> None:
    page.set_viewport_size({"width": width, "height": 900})
    tour, card = page.get_by_role("dialog"), page.locator(".tour-card")
    for step in tour.locator("section").all():
        box = card.bounding_box()
        assert box
        assert box["x"] >= 0
        assert box["x"] + box["width"] <= width
        address = step.get_attribute("data-at")
        if address:
            place = page.locator(f'#menu a[href="{address}"]').bounding_box()
            ring = page.locator(".tour-ring").bounding_box()
            assert place
            assert ring
            assert abs(ring["x"] - place["x"]) < 5
            assert box["y"] >= place["y"] + place["height"]
        page.keyboard.press("ArrowRight")


def test_the_tour_begins_again_when_asked_for(page: Page) -> None:
    page.keyboard.press("Escape")
    page.goto("/admin/coverage/")
    expect(page.get_by_role("dialog")).to_be_hidden()
    page.get_by_role("button", name="Tour").click()
    expect(page.get_by_role("dialog")).to_be_visible()
    page.get_by_role("button", name="Close the tour").click()
    expect(page.get_by_role("dialog")).to_be_hidden()


def test_the_tour_is_free_of_serious_findings(page: Page) -> None:
    page.evaluate(AXE)
    for scheme in ("light", "dark"):
        page.emulate_media(color_scheme=scheme)
        assert page.evaluate(RUN) == []
        page.keyboard.press("ArrowRight")


@pytest.mark.parametrize("language", ["it", "ja"])
def test_the_language_is_chosen_and_kept(opened: Callable[..., Page], language: str) -> None:
    page = opened("researcher")
    page.goto("/admin/coverage/?language=en")
    page.locator(f".languages [lang={language}]").click()
    expect(page.locator("html")).to_have_attribute("lang", language)
    expect(page).to_have_url(re.compile(r"/admin/coverage/\?language=en$"))
    expect(page.locator(".languages [aria-current]")).to_have_attribute("lang", language)
    page.goto("/admin/")
    expect(page.locator("html")).to_have_attribute("lang", language)


def test_the_header_has_one_switch_of_the_theme_and_an_icon(opened: Callable[..., Page]) -> None:
    for page in (opened("author"), opened()):
        page.goto("/admin/")
        expect(page.locator(".theme-toggle")).to_have_count(1)
        icon = page.locator("link[rel=icon]").get_attribute("href") or ""
        assert page.request.get(icon).ok
