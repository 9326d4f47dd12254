"""The ontology in a browser: out by a researcher, in by an administrator, published; axe-clean."""

import re
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.browser.admin.conftest import DESK, TABLET
from tests.browser.admin.test_axe import AXE, RUN, SIDEWAYS

pytestmark = pytest.mark.browser

#: A sentence on a class: the text, between the property it belongs to and its end.
SENTENCE = re.compile(
    r'hasPositiveAndWait"/>\s*<owl:hasValue xml:lang="en">([^<&]{20,})</owl:hasValue>'
)
ADDED = "Tell me more, I have time."
HOSTILE = (
    '<?xml version="1.0"?><!DOCTYPE rdf:RDF [<!ENTITY a SYSTEM "file:///etc/passwd">]>'
    '<rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">&a;</rdf:RDF>'
)
#: A file is read by a process of its own, on a busy machine.
PATIENCE = 120_000


def taken_out(page: Page) -> str:
    """Download the draft and return the file."""
    page.goto("/admin/ontology/")
    with page.expect_download(timeout=PATIENCE) as download:
        page.get_by_role("button", name="Download .owl").click()
    assert download.value.suggested_filename.endswith(".owl")
    return Path(download.value.path()).read_text(encoding="utf-8")


def bring(page: Page, folder: Path, text: str, name: str = "edited.owl") -> None:
    """Upload a file and wait until it has been compared or refused."""
    file = folder / name
    file.write_text(text, encoding="utf-8")
    page.goto("/admin/ontology/")
    page.locator("#owl-file").set_input_files(file)
    page.locator("#upload [type=submit]").click()
    page.wait_for_url(re.compile(r"/ontology/import/\d+/$"))
    page.locator(".sums, .told").first.wait_for(timeout=PATIENCE)


def edited(text: str) -> tuple[str, str, str]:
    """Return the file with one sentence longer, the sentence as it was, and as it is."""
    found = SENTENCE.search(text)
    assert found
    old, new = found[1], f"{found[1]} {ADDED}"
    return text.replace(f">{old}<", f">{new}<"), old, new


def look(page: Page) -> None:
    """Assert that axe finds nothing serious and nothing sticks out."""
    page.evaluate(AXE)
    assert page.evaluate(RUN) == []
    assert page.evaluate(SIDEWAYS) <= 0


def test_what_a_researcher_edits_is_seen_brought_in_and_published(
    opened: Callable[..., Page], tmp_path: Path
) -> None:
    text, old, _new = edited(taken_out(opened("researcher")))
    page = opened("administrator")
    bring(page, tmp_path, text)
    expect(page.locator(".sums")).to_have_text("1 sentence changed")
    expect(page.locator(".changes li")).to_have_count(1)
    expect(page.locator(".marks ins")).to_contain_text("Tell me more")
    expect(page.locator(".marks")).to_contain_text(old.split("$")[0])
    look(page)
    page.get_by_role("button", name="Bring this into the draft").click()
    page.locator(".told.good").wait_for(timeout=PATIENCE)
    look(page)
    page.locator(".told.good a").click()
    expect(page.locator(".changes .marks ins").first).to_contain_text("Tell me more")
    page.locator("#publish-form [type=submit]").click()
    page.wait_for_url(re.compile(r"/releases/\d+/$"), timeout=PATIENCE)
    expect(page.locator(".messagelist .success")).to_be_visible()


def test_a_hostile_file_is_refused_with_a_sentence(
    opened: Callable[..., Page], tmp_path: Path
) -> None:
    page = opened("administrator")
    bring(page, tmp_path, HOSTILE, "<b>x.owl")
    expect(page.locator(".told.bad")).to_contain_text("nothing was written")
    expect(page.locator(".problems .found li").first).to_be_visible()
    expect(page.locator("body")).not_to_contain_text("root:")
    expect(page.locator(".facts-line")).to_contain_text("<b>x.owl")
    look(page)


@pytest.mark.parametrize("viewport", [DESK, TABLET], ids=["desk", "tablet"])
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_the_page_of_the_ontology_is_clean(
    opened: Callable[..., Page], viewport: dict[str, int], scheme: str
) -> None:
    page = opened("administrator", viewport=viewport, color_scheme=scheme)
    page.goto("/admin/ontology/")
    look(page)


def test_a_file_that_is_too_large_is_told_before_it_is_sent(
    opened: Callable[..., Page], tmp_path: Path
) -> None:
    page = opened("administrator")
    page.goto("/admin/ontology/")
    page.locator("#upload").evaluate("(form) => { form.dataset.most = 10; }")
    file = tmp_path / "large.owl"
    file.write_text("x" * 11)
    page.locator("#owl-file").set_input_files(file)
    expect(page.locator("#owl-file-told")).to_contain_text("The file has more than")
    page.locator("#upload [type=submit]").click()
    expect(page).to_have_url(re.compile(r"/admin/ontology/$"))


def test_an_import_is_looked_at_without_scripts(
    opened: Callable[..., Page], tmp_path: Path
) -> None:
    page = opened("administrator", java_script_enabled=False)
    file = tmp_path / "no.owl"
    file.write_text(HOSTILE)
    page.goto("/admin/ontology/")
    page.locator("#owl-file").set_input_files(file)
    page.locator("#upload [type=submit]").click()
    for _again in range(100):
        if page.locator(".told.bad").count():
            break
        page.wait_for_timeout(500)
        page.reload()
    expect(page.locator(".told.bad")).to_contain_text("nothing was written")
