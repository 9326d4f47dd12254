"""The web chat on a site where calls need a key: it talks, also after its pass has ended."""

import pytest
from playwright.sync_api import BrowserContext, Page, expect
from pytest_django.fixtures import Settings

from tests.browser.test_chat import begin

pytestmark = pytest.mark.browser


@pytest.fixture(autouse=True)
def _keys_are_required(settings: Settings) -> None:
    settings.CAIR_KEYS_REQUIRED = True


def test_the_chat_talks_on_after_its_pass_has_ended(context: BrowserContext, page: Page) -> None:
    log = begin(page)
    assert "cair_chat" not in page.evaluate("document.cookie")
    for count in (2, 3):
        context.clear_cookies()
        page.locator("#sentence").fill("I love tea")
        page.locator("#send").click()
        expect(log.locator(".reply")).to_have_count(count)
    expect(page.locator("#talk-trouble")).to_be_empty()
    assert {one["name"] for one in context.cookies()} == {"cair_chat"}
