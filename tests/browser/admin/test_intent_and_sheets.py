"""A new request for robots, written in a form; a cell of a spreadsheet, seen before it is saved."""

import csv
import io
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

pytestmark = pytest.mark.browser

TRIGGERS = {
    "en": [
        "(water|give water to) [all] (the|my) (plants|flowers)",
        "(the|my) (plants|flowers) (need|want) [some] water",
    ],
    "it": [
        "[mi] (annaffia|annaffi|innaffia|bagna) [tutte|tutti] (le|i) [mie|miei] (piante|fiori)",
        "(le|i) [mie|miei] (piante|fiori) hanno (sete|bisogno di acqua)",
    ],
    "ja": [
        "(植物|花|お花) に [お] 水 を (あげて|やって)",
        "(植物|花|お花) の 水やり を [お願い]",
    ],
}
SAID = {
    "en": ["The plants will be glad of some water.", "A little water does every plant good."],
    "it": ["Alle piante un po' d'acqua farà bene.", "Un po' d'acqua rinfresca ogni fiore."],
    "ja": ["お花も喜びますね。", "お水をあげると、お花が元気になりますね。"],
}
# Phrasings that no line lists word by word.
SAYINGS = {
    "en": ["Could you please water all my flowers?", "Robot, my plants want some water!"],
    "it": ["Per favore, mi annaffi tutti i miei fiori?", "Senti, le mie piante hanno sete!"],
    "ja": ["すみません、お花に水をあげてください", "植物に水をやってくれますか"],
}
NOT_MEANT = "I watered the plants this morning"


def fill(page: Page, part: str, texts: dict[str, list[str]]) -> None:
    """Write the lines of a part of the form, in all languages."""
    for language, lines in texts.items():
        group = page.locator(f'[data-part="{part}"] .language[data-language="{language}"]')
        for place, text in enumerate(lines):
            group.locator("textarea.sentence").nth(place).fill(text)


def try_it(page: Page, language: str, sentence: str) -> str:
    """Return the intent that takes a sentence for sure, "" for none."""
    page.locator("#try-form [name=language]").select_option(language)
    page.locator("#try-form [name=sentence]").fill(sentence)
    page.locator("#try-form button").click()
    expect(page.locator("#try-answer .said")).to_contain_text(sentence)
    verdict = page.locator("#try-answer .verdict")
    return verdict.locator("a").inner_text() if verdict.locator(".badge.good").count() else ""


def test_an_intent_is_written_in_three_languages_and_understands_what_no_line_lists(
    opened: Callable[..., Page],
) -> None:
    page = opened("author")
    page.goto("/admin/plans/intent/add/")
    page.locator("#id_key").fill("walk_water_plants")
    page.locator('[name="_shown"][value="all"]').check()
    fill(page, "triggers", TRIGGERS)
    fill(page, "plan_sentences", SAID)
    page.locator("[name=_save]").click()
    expect(page.locator(".messagelist .success")).to_be_visible()
    page.goto("/admin/intents/try/")
    understood = {
        sentence: try_it(page, language, sentence)
        for language, sentences in SAYINGS.items()
        for sentence in sentences
    }
    assert [one for one, intent in understood.items() if intent != "walk_water_plants"] == []
    assert try_it(page, "en", NOT_MEANT) != "walk_water_plants"


def taken_out(page: Page) -> str:
    """Return the sheet of the sentences about food and drink."""
    page.locator("#filter-branch").select_option("FoodAndDrink")
    with page.expect_download() as download:
        page.locator('[name=form][value="csv"]').click()
    return Path(download.value.path()).read_text(encoding="utf-8-sig")


def changed_sheet(page: Page, folder: Path) -> str:
    """Take a sheet out, change its first English cell, bring it in; return the sheet as it was."""
    text = taken_out(page)
    rows = list(csv.reader(io.StringIO(text)))
    column = rows[0].index("English")
    rows[1][column] = f"Tell me: {rows[1][column]}"
    changed = folder / "sheet.csv"
    with changed.open("w", newline="", encoding="utf-8-sig") as file:
        csv.writer(file).writerows(rows)
    page.locator("#sheet-file").set_input_files(changed)
    page.locator("form[enctype] [type=submit]").click()
    return text


def test_one_changed_cell_of_a_sheet_is_shown_before_it_is_saved(
    opened: Callable[..., Page], tmp_path: Path
) -> None:
    page = opened("author")
    page.goto("/admin/sheets/")
    page.locator(".kinds a").first.click()
    address = page.url
    before = changed_sheet(page, tmp_path)
    expect(page.locator("tr.changed")).to_have_count(1)
    expect(page.locator("tr.changed .differs")).to_have_count(1)
    expect(page.locator("tr.changed ins")).to_contain_text("Tell me:")
    page.goto(address)
    assert taken_out(page) == before
