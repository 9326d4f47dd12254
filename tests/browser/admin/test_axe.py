"""axe-core on every page of the admin: languages, light and dark, a desk and a tablet."""

import re
from collections.abc import Iterator
from pathlib import Path

import axe_playwright_python
import pytest
from django.contrib import admin
from django.urls import NoReverseMatch, reverse
from playwright.sync_api import Page, expect

from authoring.pages.table import PAGES
from tests.browser.admin.conftest import DESK, LOCALES, TABLET, Desk

pytestmark = pytest.mark.browser

AXE = (Path(axe_playwright_python.__file__).parent / "axe.min.js").read_text(encoding="utf-8")
RUN = """async () => {
  document.getAnimations().forEach((one) => one.finish());  // colours that are still changing
  const found = await axe.run(document, {resultTypes: ["violations"]});
  return found.violations
    .filter(({impact}) => impact === "serious" || impact === "critical")
    .map(({id, nodes}) => `${id}: ${nodes.length} x ${nodes[0].target.join(" ")}`);
}"""
SIDEWAYS = "document.documentElement.scrollWidth - document.documentElement.clientWidth"

#: What the pages with a part of their address to fill in are opened with.
WITH: dict[str, tuple[object, ...]] = {
    "release": (1,),
    "release_back": (1,),
    "release_draft": (1,),
    "sheet": ("sentences",),
    "topic_picture": (301,),
    "topic_said": (301,),
    "tree_move": ("GreenTea",),
}
#: Answers to scripts, files, and pages that only follow a form.
NO_PAGES = frozenset(
    [
        "intent_answer",
        "intent_check",
        "intent_failing",
        "try_sentence",
        "name_forms",
        "chat_turn",
        "chat_replay",
        "chat_save",
        "publish_status",
        "publish_result",
        "release_files",
        "tree_found",
        "tree_below",
        "tree_panel",
        "sheet_file",
        "sheet_preview",
        "sheet_save",
        "ontology_file",
        "ontology_upload",
        "ontology_import",
        "ontology_status",
        "ontology_apply",
        "ontology_discard",
    ]
)
MORE = ("/admin/tree/?open=GreenTea&q=tea", "/admin/plans/intent/1/delete/")
#: Pages whose address is asked of the database below.
ASKED = ("topic_sentence", "audit_back", "conversation")


@pytest.fixture(scope="module")
def addresses(desk: Desk) -> list[str]:
    """Return the address of every page, after something has been written and published."""
    with desk.open("administrator") as context:
        page = context.new_page()
        topic, frame, back = _change(page)
        conversation = _keep_a_talk(page)
    places = WITH | {
        "conversation": (conversation,),
        "topic_picture": (topic,),
        "topic_said": (topic,),
        "topic_sentence": (topic, frame),
    }
    pages = [
        reverse(f"admin:{page.name}", args=places.get(page.name, ()))
        for page in PAGES
        if page.name not in NO_PAGES and page.name != "audit_back"
    ]
    home = [reverse("admin:index"), reverse("admin:password_change")]
    return [*home, *pages, back, *MORE, *_lists_and_forms()]


def _number(page: Page, kind: str) -> str:
    found = re.search(rf"/{kind}/(\d+)/", page.url)
    assert found, page.url
    return found[1]


def _change(page: Page) -> tuple[str, str, str]:
    """Change a sentence twice, publish in between; return its topic, its number, the way back."""
    for words in ("A small cup, and the morning begins.", "A small cup, and the talk begins."):
        page.goto("/admin/dialogue/topic/?q=TeaWithMilk")
        page.locator("#result_list tbody a", has_text="TeaWithMilk").first.click()
        row = page.locator(".sentence-row", has=page.locator(".edit-here")).first
        topic, frame = _number(page, "topic"), (row.get_attribute("id") or "")[1:]
        row.locator(".edit-here").click()
        row.locator("textarea[lang=en]").fill(words)
        row.locator("form.in-place [type=submit]").click()
        expect(row.locator(".words")).to_have_text(words)
        page.goto("/admin/publish/")
        if "morning" in words:
            page.locator("#publish-form [type=submit]").click()
            page.wait_for_url(re.compile(r"/releases/\d+/$"))
    page.goto("/admin/audit/")
    back = page.locator(".change-ways a[href*='/audit/']").first.get_attribute("href")
    assert back
    return topic, frame, back


def _keep_a_talk(page: Page) -> str:
    """Save a talk of which nothing must hold; return the number of the conversation."""
    page.goto("/admin/chat/")
    page.locator(".chat-turn").first.wait_for()
    page.locator("#chat-keep").click()
    page.locator("#save-name").fill("A greeting")
    for must in page.locator("#save-turns select").all():
        must.select_option("any")
    page.locator("#save-form [type=submit]").click()
    expect(page.locator("#save-dialog")).to_be_hidden()
    page.goto("/admin/conversations/")
    page.locator("#content a", has_text="A greeting").first.click()
    return _number(page, "conversations")


def _lists_and_forms() -> Iterator[str]:
    """Yield the list of each model and its empty form; `+` stands for "the first row's form"."""
    for model in admin.site._registry:
        name = f"admin:{model._meta.app_label}_{model._meta.model_name}"
        yield reverse(f"{name}_changelist")
        yield f"{reverse(f'{name}_changelist')}+"
        try:
            yield reverse(f"{name}_add")
        except NoReverseMatch:
            continue


def _open(page: Page, address: str) -> str:
    """Open a page; return "" where there is none for this person or no row."""
    answer = page.goto(address.rstrip("+"))
    assert answer
    if address.endswith("+"):
        first = page.locator("#result_list tbody tr").first.locator("a[href*='/change/']").first
        if not first.count():
            return ""
        answer = page.goto(first.get_attribute("href") or "")
        assert answer
    if answer.status == 403 and address.endswith("/add/"):
        return ""
    assert answer.status == 200, f"{answer.status} {address}"
    return page.url


@pytest.mark.parametrize("language", ["en", "it", "ja"])
def test_every_page_is_free_of_serious_findings(
    desk: Desk, addresses: list[str], language: str
) -> None:
    found: dict[str, list[str]] = {}
    with desk.open("administrator", language) as context:
        page = context.new_page()
        for number, address in enumerate(addresses):
            if not _open(page, address):
                continue
            page.evaluate(AXE)
            for dark, size in _looks(number, language):
                page.emulate_media(color_scheme="dark" if dark else "light")
                page.set_viewport_size(size)
                wrong = page.evaluate(RUN)
                if page.evaluate(SIDEWAYS) > 0:
                    wrong.append("scrolls sideways")
                if wrong:
                    found[f"{address} {size['width']} {'dark' if dark else 'light'}"] = wrong
    assert found == {}


@pytest.mark.parametrize("language", ["en", "it", "ja"])
def test_the_login_is_free_of_serious_findings(desk: Desk, language: str) -> None:
    with desk.open(language=language) as context:
        page = context.new_page()
        page.goto("/admin/login/")
        page.evaluate(AXE)
        for scheme in ("light", "dark"):
            page.emulate_media(color_scheme=scheme)
            assert page.evaluate(RUN) == []


def test_every_page_is_looked_at() -> None:
    known = {*NO_PAGES, *WITH, *ASKED}
    unlisted = [page.name for page in PAGES if "<" in page.path and page.name not in known]
    assert unlisted == [], "Say in WITH or NO_PAGES how to open them."


def _looks(number: int, language: str) -> list[tuple[bool, dict[str, int]]]:
    """Return in which looks a page is seen: English has both colours and both sizes on every page,
    the other languages one of the four, another one on the next page."""
    pairs = [(False, DESK), (True, TABLET), (True, DESK), (False, TABLET)]
    if language == "en":
        return pairs[2:] if number % 2 else pairs[:2]
    return [pairs[(number + list(LOCALES).index(language)) % 4]]
