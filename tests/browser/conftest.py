"""A headless Chromium, and a web chat served for it."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, BrowserContext, Page, sync_playwright
from pytest_django.fixtures import Settings
from pytest_django.live_server_helper import LiveServer

CHROMIUM = Path("/usr/bin/chromium")
ARGUMENTS = (
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
)


@pytest.fixture(scope="session")
def chromium() -> Iterator[Browser]:
    if not CHROMIUM.exists():
        pytest.skip(f"No browser at {CHROMIUM}: install Debian's package chromium.")
    # Playwright keeps an event loop in this thread, where Django then refuses the database.
    with pytest.MonkeyPatch.context() as patch, sync_playwright() as playwright:
        patch.setenv("DJANGO_ALLOW_ASYNC_UNSAFE", "1")
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=list(ARGUMENTS))
        yield browser
        browser.close()


@pytest.fixture(autouse=True)
def _plain_static_files(settings: Settings) -> None:
    """Serve static/ as it is: nothing was collected for a test."""
    plain = {"BACKEND": "django.contrib.staticfiles.storage.StaticFilesStorage"}
    settings.STORAGES = settings.STORAGES | {"staticfiles": plain}


@pytest.fixture
def options() -> dict[str, Any]:
    """Return what the browser is like; a test changes it by parametrizing `options`."""
    return {}


@pytest.fixture
def context(chromium: Browser, live_server: LiveServer, options: dict[str, Any]) -> Iterator[Any]:
    """Open a fresh profile, as small as a phone, that knows the server's address."""
    usual = {"locale": "en-GB", "viewport": {"width": 390, "height": 844}}
    context: BrowserContext = chromium.new_context(base_url=live_server.url, **usual | options)
    context.set_default_timeout(10_000)
    yield context
    context.close()


@pytest.fixture
def page(context: BrowserContext, published: object) -> Page:
    """Return an empty page; the shipped content is published."""
    return context.new_page()
