"""What operators and client developers must know is written down: settings, errors, addresses."""

import re
from pathlib import Path

from django.urls import URLPattern, URLResolver, get_resolver

from cair_site import settings
from cair_site.errors import ERRORS

ROOT = Path(__file__).resolve().parent.parent.parent
DOCS = ROOT / "docs"
READ = re.compile(r'environment\.\w+\(\s*"([A-Z_]+)"')
ASKED = re.compile(r"\$\((?:or \$\()?(CAIR_[A-Z_]+)|os\.environ(?:\.get\(|\[)\"([A-Z_]+)\"")


def table(page: str) -> dict[str, str]:
    """Return the rows of a page's tables by the code in their first cell."""
    rows = re.findall(r"^\| `([^`]+)` \|(.*)\|$", (DOCS / page).read_text(), re.MULTILINE)
    return dict(rows)


def variables() -> set[str]:
    """Return every variable that the site reads, and every setting named CAIR_…."""
    sources = [*(ROOT / "cair_site").glob("*.py"), ROOT / "Makefile"]
    text = "\n".join(path.read_text() for path in sources)
    asked = {one or other for one, other in ASKED.findall(text)}
    own = {name for name in dir(settings) if name.startswith("CAIR_")}
    return set(READ.findall(text)) | asked - {"DJANGO_SETTINGS_MODULE"} | own


def addresses(patterns: list[URLPattern | URLResolver], prefix: str = "/") -> set[str]:
    """Return the addresses of a list of patterns, those of the admin as one."""
    found: set[str] = set()
    for pattern in patterns:
        address = prefix + plain(str(pattern.pattern))
        if address == "/admin/" or isinstance(pattern, URLPattern):
            found.add(address)
        else:
            found |= addresses(pattern.url_patterns, address)
    return found


def plain(pattern: str) -> str:
    """Return a pattern as people write it: `^topics/(?P<name>[^/.]+)/$` is `topics/{name}/`."""
    text = pattern.removeprefix("^").removesuffix("$").removesuffix(r"\Z")
    text = text.removeprefix("(?:(?P<language>[a-z]{2})/)?").removesuffix("(?:/start)?/?")
    return re.sub(r"\(\?P<(\w+)>[^)]*\)", r"{\1}", text)


def test_every_setting_is_documented() -> None:
    assert variables() >= {"CAIR_PORT", "CAIR_VAR", "DATABASE_URL", "CAIR_LONGEST_BODY"}
    assert variables() - set(table("settings.md")) == set()


def test_no_setting_is_documented_that_is_gone() -> None:
    assert set(table("settings.md")) - variables() == set()


def test_the_documented_numbers_are_the_defaults() -> None:
    rows = table("settings.md")
    source = (ROOT / "cair_site" / "settings.py").read_text()
    defaults = re.findall(r'environment\.number\("([A-Z_]+)", ([\d_]+)', source)
    assert len(defaults) > 5
    for name, default in defaults:
        assert rows[name].startswith(f" `{default.replace('_', '')}` |")


def test_every_error_is_documented_with_its_status() -> None:
    rows = table("errors.md")
    statuses = {code: int(row.split("|")[0]) for code, row in rows.items()}
    assert statuses == {code: kind.status for code, kind in ERRORS.items()}


def test_every_address_is_documented() -> None:
    text = (DOCS / "api.md").read_text()
    known = addresses(get_resolver().url_patterns)
    assert {"/", "/api/v1/hub/", "/api/v1/topics/{name}/", "/CAIR_hub", "/admin/"} <= known
    assert {address for address in known if f"{address}`" not in text} == set()


def test_links_between_pages_lead_somewhere() -> None:
    for page in DOCS.glob("*.md"):
        for target in re.findall(r"\]\(([\w./-]+\.md)\)", page.read_text()):
            assert (page.parent / target).exists(), f"{page.name}: {target}"
