"""The whole walk of an expert: find, change, try, see what changes, publish, take it back."""

import re
from collections.abc import Callable
from dataclasses import dataclass

import pytest
from playwright.sync_api import Locator, Page, Route, expect

from tests.browser.admin import hub
from tests.browser.admin.conftest import Desk
from tests.server.conftest import wait_for

pytestmark = pytest.mark.browser

ASKED = ("Let us talk about green tea", "Yes, I do.")
INDIAN = '.hearers a[href*="culture=IN&language=en"]'
NEW = "Somebody told me that green tea tastes of rain in spring, number {number}."
WITHOUT_INS = """node => { const one = node.cloneNode(true);
  one.querySelectorAll("ins").forEach((mark) => mark.remove()); return one.textContent; }"""
WITHOUT_DEL = WITHOUT_INS.replace('"ins"', '"del"')


@dataclass
class Walker:
    """Somebody who writes and publishes, at a page of the browser."""

    desk: Desk
    page: Page

    def find_green_tea(self) -> None:
        """Search the tree from the start page, open the topic, let an Indian speaker listen."""
        self.page.goto("/admin/")
        self.page.locator('#menu a[href$="/tree/"]').click()
        self.page.wait_for_url("**/tree/")
        self.page.locator("#tree-q").fill("green tea")
        self.page.locator(".hits a", has_text="GreenTea").first.click()
        panel = self.page.locator("#tree-panel")
        expect(panel.locator("h2")).to_contain_text("GreenTea")
        panel.locator(".tree-actions a").first.click()
        self.page.locator(INDIAN).click()
        expect(self.page.locator(INDIAN)).to_have_attribute("aria-current", "true")

    def remark(self) -> Locator:
        """Return the row of the first remark that green tea has of its own."""
        return self.page.locator("#kind-c .sentence-row", has=self.page.locator(".edit-here")).first

    def words(self) -> str:
        """Return what stands there."""
        return self.remark().locator(".words").inner_text()

    def change(self, words: str) -> None:
        """Change the sentence in place."""
        self.page.wait_for_load_state()
        self.remark().locator(".edit-here").click()
        self.remark().locator("textarea[lang=en]").fill(words)
        self.remark().locator("form.in-place [type=submit]").click()
        expect(self.remark().locator(".words")).to_have_text(words)

    def talk_with_draft(self, seed: int) -> Locator:
        """Ask for green tea in the test chat and return the reply."""
        page = self.page
        page.goto("/admin/chat/")
        page.locator(".chat-turn").first.wait_for()
        page.locator("#chat-content").select_option("draft")
        page.locator("#chat-culture").select_option("IN")
        page.locator("#chat-language").select_option("en")
        page.locator("#chat-seed").fill(str(seed))
        page.locator("#chat-settings [type=submit]").click()
        expect(page.locator(".chat-turn")).to_have_count(1)
        expect(page.locator("#chat-status")).to_be_empty()
        for number, sentence in enumerate(ASKED, 2):
            page.locator("#chat-sentence").fill(sentence)
            page.locator("#chat-say [type=submit]").click()
            expect(page.locator(".chat-turn")).to_have_count(number)
        return page.locator(".chat-turn").last

    def expect_in_the_chat(self, words: str, seed: int) -> None:
        """Expect the words from the draft, and links from the rules to what they came from."""
        reply = self.talk_with_draft(seed)
        expect(reply.locator(".chat-says")).to_contain_text(words)
        reply.locator(".chat-why summary").click()
        expect(reply.locator(".chat-why ol > li").first).to_be_visible()
        expect(reply.locator('.chat-why a[href*="/frame/"]').first).to_be_visible()

    def expect_on_the_page_to_publish(self, old: str, new: str) -> None:
        """Expect the sentence with its old and its new words."""
        self.page.locator('#menu a[href$="/publish/"]').click()
        marks = self.page.locator(".changes .marks", has_text=new.split()[-1])
        expect(marks).to_have_count(1)
        assert marks.evaluate(WITHOUT_INS) == old
        assert marks.evaluate(WITHOUT_DEL) == new

    def publish(self, note: str) -> int:
        """Publish on the page and return the number of the release."""
        self.page.goto("/admin/publish/")
        self.page.locator("#publish-form [name=note]").fill(note)
        self.page.locator("#publish-form [type=submit]").click()
        return self._released()

    def go_back(self, number: int) -> int:
        """Make a former release the newest again."""
        self.page.goto("/admin/releases/")
        self.page.locator(f'a[href$="/releases/{number}/"]').first.click()
        self.page.locator(f'a[href$="/releases/{number}/back/"]').click()
        self.page.locator("form.asking [type=submit]").click()
        return self._released()

    def _released(self) -> int:
        self.page.wait_for_url(re.compile(r"/releases/\d+/$"), timeout=30_000)
        number = int(self.page.url.rstrip("/").rpartition("/")[2])
        server = self.desk.server
        served = wait_for(lambda: {server.publication() for _ in range(8)} == {number}, 60)
        assert served, f"Release {number} is not served by all workers."
        return number


def seed_that_says(desk: Desk, words: str) -> int:
    """Return the seed of a talk in which robots say this."""
    for seed in range(1, 200):
        if words in hub.talk(desk.server, seed, *ASKED):
            return seed
    raise AssertionError(f"Nobody says: {words}")


@pytest.mark.parametrize("language", ["en", "it", "ja"])
def test_an_expert_changes_a_sentence_and_takes_it_back(
    desk: Desk, opened: Callable[..., Page], language: str
) -> None:
    walker = Walker(desk, opened("publisher", language))
    page = walker.page
    former = desk.server.publication()
    assert former is not None
    walker.find_green_tea()
    expect(page.locator("html")).to_have_attribute("lang", language)
    old, new = walker.words(), NEW.format(number=former)
    seed = seed_that_says(desk, old)
    walker.change(new)
    walker.expect_in_the_chat(new, seed)
    assert old in hub.talk(desk.server, seed, *ASKED)
    walker.expect_on_the_page_to_publish(old, new)
    assert walker.publish(f"Rain in spring ({language})") > former
    assert new in hub.talk(desk.server, seed, *ASKED)

    walker.go_back(former)
    assert old in hub.talk(desk.server, seed, *ASKED)
    walker.find_green_tea()
    assert walker.words() == new, "Going back leaves the draft alone."
    walker.change(old)
    page.goto("/admin/publish/")
    expect(page.locator("main")).not_to_contain_text("rain in spring")


def test_a_wrong_variable_is_refused_where_it_stands(opened: Callable[..., Page]) -> None:
    page = opened("author")
    page.goto("/admin/dialogue/topic/?q=GreenTea")
    page.locator("#result_list tbody a", has_text="GreenTea").first.click()
    row = page.locator("#kind-c .sentence-row", has=page.locator(".edit-here")).first
    old = row.locator(".words").inner_text()
    page.wait_for_load_state()
    row.locator(".edit-here").click()
    row.locator("textarea[lang=en]").fill("Have you ever tried $hasNmae?")
    row.locator("form.in-place [type=submit]").click()
    refused = row.locator(".one-language", has=page.locator("textarea[lang=en]"))
    expect(refused.locator(".errorlist")).to_contain_text("$hasNmae")
    expect(refused.locator("textarea")).to_have_value("Have you ever tried $hasNmae?")
    expect(row.locator(".one-language .errorlist")).to_have_count(1)
    page.reload()
    expect(row.locator(".words")).to_have_text(old)


def test_the_second_of_two_experts_sees_the_words_of_the_first(
    opened: Callable[..., Page],
) -> None:
    pages = [opened("author"), opened("administrator")]
    for page in pages:
        page.goto("/admin/dialogue/topic/?q=MasalaChai")
        page.locator("#result_list tbody a", has_text="MasalaChai").first.click()
        page.locator(".sentence-row .edit-here").first.wait_for()
        page.wait_for_load_state()
        page.locator(".sentence-row .edit-here").first.click()
        page.locator("form.in-place textarea[lang=en]").wait_for()
    first, second = pages
    row = "li:has(form.in-place)"
    number = first.locator(row).get_attribute("id")
    first.locator(f"{row} textarea[lang=en]").fill("The first of us wrote this.")
    first.locator(f"{row} [type=submit]").click()
    expect(first.locator(f"#{number} .words")).to_have_text("The first of us wrote this.")
    second.locator(f"{row} textarea[lang=en]").fill("The second of us wrote that.")
    second.locator(f"{row} [type=submit]").click()
    told = second.locator(f"{row} .errorlist")
    expect(told.first).to_contain_text("Somebody else has changed this sentence meanwhile.")
    expect(second.locator(row)).to_contain_text("The first of us wrote this.")
    expect(second.locator(f"{row} textarea[lang=en]")).to_have_value("The second of us wrote that.")
    first.reload()
    expect(first.locator(f"#{number} .words")).to_have_text("The first of us wrote this.")


def test_a_researcher_reads_everything_and_changes_nothing(opened: Callable[..., Page]) -> None:
    page = opened("researcher")
    page.goto("/admin/dialogue/topic/?q=GreenTea")
    page.locator("#result_list tbody a", has_text="GreenTea").first.click()
    expect(page.locator(".sentence-row").first).to_be_visible()
    address = page.url
    expect(page.locator(".edit-here")).to_have_count(0)
    expect(page.locator("[name=_save]")).to_have_count(0)
    page.goto("/admin/publish/")
    expect(page.locator("#publish-form")).to_have_count(0)
    page.goto("/admin/")
    expect(page.locator("#content .addlink")).to_have_count(0)
    cookie = next(one["value"] for one in page.context.cookies() if one["name"] == "csrftoken")
    for target in (address, "/admin/publish/", "/admin/plans/intent/add/"):
        answer = page.request.post(
            target, headers={"X-CSRFToken": cookie, "Referer": page.url}, form={"draft": "1"}
        )
        assert answer.status == 403, target


def test_words_typed_while_the_page_still_loads_are_searched(opened: Callable[..., Page]) -> None:
    page = opened("author", "en")
    held: list[Route] = []
    page.route(re.compile(r"/tree(\.\w+)?\.js$"), lambda route: held.append(route))
    page.goto("/admin/tree/", wait_until="commit")
    page.locator("#tree-q").fill("green tea")
    assert wait_for(lambda: page.wait_for_timeout(50) or held, 60), "The script was not asked for."
    held[0].continue_()
    expect(page.locator(".hits a", has_text="GreenTea").first).to_be_visible()
