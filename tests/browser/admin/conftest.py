"""The authoring admin as experts meet it: a server of its own, and a browser for each person."""

import re
import shutil
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, BrowserContext, Page

from tests.server.conftest import ROOT, Server, manage, start_server

DESK = {"width": 1280, "height": 900}
TABLET = {"width": 820, "height": 1180}
LOCALES = {"en": "en-GB", "it": "it-IT", "ja": "ja-JP"}
_PASSWORD = re.compile(r"^(\w+): password (\S+)", re.MULTILINE)
_NO_TOUR = "localStorage.setItem('cair.tour', 'seen');"


@dataclass
class Desk:
    """A server with the shipped content, one person a role, and a browser."""

    server: Server
    browser: Browser
    passwords: dict[str, str]
    cookies: dict[str, Any] = field(default_factory=dict)

    @property
    def address(self) -> str:
        """Return where the server is."""
        return f"http://127.0.0.1:{self.server.port}"

    def open(self, role: str = "", language: str = "en", **options: Any) -> BrowserContext:
        """Return a fresh browser in a language, with a person of this role logged in."""
        kept = self._logged_in(role) if role else None
        usual = {"viewport": DESK, "locale": LOCALES[language], "storage_state": kept}
        context = self.browser.new_context(base_url=self.address, **usual | options)
        context.set_default_timeout(15_000)
        context.add_init_script(_NO_TOUR)
        return context

    def _logged_in(self, role: str) -> Any:
        if role not in self.cookies:
            with self.browser.new_context(base_url=self.address) as context:
                self.log_in(context.new_page(), role)
                self.cookies[role] = {**context.storage_state(), "origins": []}
        return self.cookies[role]

    def log_in(self, page: Page, role: str) -> None:
        """Fill in the form of the login."""
        page.goto("/admin/login/")
        page.locator("#id_username").fill(role)
        page.locator("#id_password").fill(self.passwords[role])
        page.locator("#login-form [type=submit]").click()
        page.locator("#user-tools").wait_for()


@pytest.fixture(autouse=True)
def _plain_static_files() -> None:
    """Use what `manage.py prepare` collected: the server is a process of its own."""


@contextmanager
def prepared_desk(browser: Browser, folder: Path) -> Iterator[Desk]:
    """Start a server with the shipped content in an empty folder; end it afterwards."""
    var = folder / "var"
    manage(var, "prepare", "--content", str(ROOT / "content"))
    passwords = dict(_PASSWORD.findall(manage(var, "demo")))
    server = start_server(var, folder / "log")
    try:
        yield Desk(server, browser, passwords)
    finally:
        server.stop()
        shutil.rmtree(var)


@pytest.fixture(scope="session")
def desk(chromium: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Desk]:
    """Serve the shipped content; the tests of this folder share it."""
    with prepared_desk(chromium, tmp_path_factory.mktemp("desk")) as desk:
        yield desk


@pytest.fixture
def opened(desk: Desk) -> Iterator[Callable[..., Page]]:
    """Return a function that opens an empty page for a person; it is closed after the test."""
    with ExitStack() as stack:

        def open_(role: str = "", language: str = "en", **options: Any) -> Page:
            context = stack.enter_context(desk.open(role, language, **options))
            return context.new_page()

        yield open_
