"""Make the pictures of docs/authors-guide.md again: `python -m tests.browser.admin.make_pictures`.

A server with the shipped content is started for it; nothing of this checkout is changed but the
pictures in docs/pictures/admin.
"""

import os
import tempfile
from contextlib import ExitStack
from pathlib import Path

from playwright.sync_api import Locator, Page, expect, sync_playwright

from tests.browser.admin.conftest import Desk, prepared_desk
from tests.browser.admin.test_intent_and_sheets import SAID, TRIGGERS, changed_sheet, fill
from tests.browser.admin.test_walk import Walker, seed_that_says
from tests.browser.conftest import ARGUMENTS, CHROMIUM
from tests.server.conftest import ROOT, wait_for

FOLDER = ROOT / "docs" / "pictures" / "admin"
SIZE = {"width": 1280, "height": 800}
NEW = "They say the second cup of green tea is the friendlier one."
TEXTS = {
    "it": "Dicono che la seconda tazza di tè verde sia quella più amichevole.",
    "ja": "緑茶は二杯目のほうが、気持ちがほぐれるそうですね。",
}


def take(page: Page, name: str, at: Locator | None = None, above: int = 80) -> None:
    """Take a picture of the window, scrolled so that something stands near its top."""
    if at:
        place = at.evaluate("node => node.getBoundingClientRect().top + scrollY")
        page.evaluate(f"scrollTo(0, {place - above})")
    page.mouse.move(0, 0)
    page.wait_for_timeout(200)
    page.screenshot(path=FOLDER / f"{name}.png")


def tour(desk: Desk) -> None:
    with desk.open("publisher", viewport=SIZE) as context:
        page = context.new_page()
        page.goto("/admin/")
        take(page, "start")
        page.locator("#start-tour").click()
        page.keyboard.press("ArrowRight")
        take(page, "tour")


def write(walker: Walker) -> int:
    """Find the topic and change a sentence; return the seed of a talk in which it is said."""
    page = walker.page
    page.goto("/admin/tree/")
    page.locator("#tree-q").fill("green tea")
    page.locator(".hits a", has_text="GreenTea").first.wait_for()
    take(page, "search")
    page.locator(".hits a", has_text="GreenTea").first.click()
    expect(page.locator("#tree-panel h2")).to_contain_text("GreenTea")
    page.wait_for_load_state()
    take(page, "tree", page.locator("#tree-panel"), 150)
    walker.find_green_tea()
    take(page, "topic", page.locator("#content h1"), 60)
    seed = seed_that_says(walker.desk, walker.words())
    row = walker.remark()
    row.locator(".edit-here").click()
    row.locator("textarea[lang=en]").fill(NEW)
    for language, words in TEXTS.items():
        row.locator(f"textarea[lang={language}]").fill(words)
    expect(row.locator(".tried").last).to_contain_text(TEXTS["ja"])
    take(page, "change", page.locator("#kind-c"), 40)
    row.locator("form.in-place [type=submit]").click()
    expect(row.locator(".words")).to_have_text(NEW)
    return seed


def wrong(walker: Walker) -> None:
    """Write a variable that does not exist."""
    page, row = walker.page, walker.remark()
    row.locator(".edit-here").click()
    row.locator("textarea[lang=en]").fill("The second cup of $hasNmae is the friendlier one.")
    row.locator("form.in-place [type=submit]").click()
    expect(row.locator(".errorlist").first).to_contain_text("$hasNmae")
    take(page, "wrong", page.locator("#kind-c"), 40)


def try_and_publish(walker: Walker, seed: int) -> None:
    """Try it in the chat, look at what changes, publish, begin to go back."""
    page, former = walker.page, walker.desk.server.publication()
    reply = walker.talk_with_draft(seed)
    reply.locator(".chat-why summary").click()
    take(page, "chat", reply, 120)
    page.goto("/admin/publish/")
    page.locator("#publish-form [name=note]").fill("A friendlier sentence about green tea")
    take(page, "publish")
    page.locator("#publish-form [type=submit]").click()
    page.wait_for_url("**/releases/*/")
    server = walker.desk.server
    wait_for(lambda: former not in {server.publication() for _ in range(8)}, 60)
    page.goto("/admin/releases/")
    take(page, "releases")
    page.goto(f"/admin/releases/{former}/back/")
    take(page, "back")


def intent(page: Page) -> None:
    """Write an intent and try a sentence before it is saved."""
    page.goto("/admin/plans/intent/add/")
    page.locator("#id_key").fill("water_plants")
    page.locator('[name="_shown"][value="all"]').check()
    fill(page, "triggers", TRIGGERS)
    fill(page, "plan_sentences", SAID)
    page.locator('[name="_shown"][value="en"]').check()
    page.locator("#try-form [name=sentence]").fill("Could you please water all my flowers?")
    page.locator("#try-form button").click()
    page.locator("#try-answer .verdict").wait_for()
    take(page, "intent", page.locator("#part-triggers"), 60)


def sheet(page: Page, folder: Path) -> None:
    """Bring in a sheet with one changed cell."""
    page.goto("/admin/sheets/")
    page.locator(".kinds a").first.click()
    changed_sheet(page, folder)
    page.locator("tr.changed").wait_for()
    take(page, "sheet-changes")


def languages(desk: Desk) -> None:
    """Take the page of the topic in the other languages of the admin."""
    for language, address in (("it", "culture=IT&language=it"), ("ja", "culture=JP&language=ja")):
        with desk.open("publisher", language, viewport=SIZE) as context:
            walker = Walker(desk, context.new_page())
            walker.find_green_tea()
            chosen = walker.page.locator(f'.hearers a[href*="{address}"]')
            chosen.click()
            expect(chosen).to_have_attribute("aria-current", "true")
            take(walker.page, f"topic-{language}", walker.page.locator("#content h1"), 60)


def main() -> None:
    """Make all pictures."""
    os.environ.setdefault("DJANGO_SETTINGS_MODULE", "cair_site.settings")
    FOLDER.mkdir(parents=True, exist_ok=True)
    with ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        playwright = stack.enter_context(sync_playwright())
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=list(ARGUMENTS))
        desk = stack.enter_context(prepared_desk(browser, folder))
        context = stack.enter_context(desk.open("publisher", viewport=SIZE))
        walker = Walker(desk, context.new_page())
        tour(desk)
        seed = write(walker)
        wrong(walker)
        try_and_publish(walker, seed)
        intent(walker.page)
        sheet(walker.page, folder)
        walker.page.goto("/admin/coverage/")
        take(walker.page, "coverage")
        languages(desk)


if __name__ == "__main__":
    main()
