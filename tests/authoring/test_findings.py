"""Checks: run, kept for everybody, shown in plain words with the row to edit."""

import pytest
from django.test import Client
from django.urls import reverse
from django.utils import translation
from pytest_django import DjangoAssertNumQueries

from authoring.checks import findings
from authoring.checks.findings import Found, check_now, findings_for, last_check
from authoring.checks.findings_words import HINTS, KINDS, language_of, plain
from authoring.models import CheckRun
from authoring.pages import checks
from dialogue.models import Frame, Sentence, Topic, TopicName
from ontology_io.files.folder import Folder
from plans.engine.remarks import CODES
from plans.models import IntentTest, Trigger
from tests.authoring.people import logged_in

pytestmark = pytest.mark.django_db


def break_the_draft() -> None:
    TopicName.objects.get(topic__key="Milk", language="it").delete()
    Sentence.objects.get(frame__key="GreenTea.c1", language="ja").delete()


def page(client: Client, **asked: str) -> str:
    response = client.get(reverse("admin:checks"), asked)
    assert response.status_code == 200
    return str(response.content.decode())


def check_again(client: Client) -> str:
    response = client.post(reverse("admin:checks"), follow=True)
    assert response.status_code == 200
    return str(response.content.decode())


def test_before_the_first_check_there_is_none(small_draft: Folder, admin_client: Client) -> None:
    assert last_check() is None
    assert findings_for(["Milk"]) == {}
    assert "has not been checked yet" in page(admin_client)


def test_what_was_found_is_kept_for_all_with_one_query(
    small_draft: Folder, django_assert_num_queries: DjangoAssertNumQueries
) -> None:
    break_the_draft()
    checked = check_now()
    with django_assert_num_queries(1):
        again = last_check()
    assert again is not None
    assert (again.found, again.draft, again.total) == (checked.found, checked.draft, checked.total)
    assert again.errors == 1
    check_now()
    assert CheckRun.objects.count() == 1


def test_a_finding_names_the_row_to_edit_its_branch_and_its_language(small_draft: Folder) -> None:
    break_the_draft()
    by_code = {one.code: one for one in check_now().found}
    name, sentence = by_code["D010"], by_code["D015"]
    milk = Topic.objects.get(key="Milk").pk
    line = Frame.objects.get(key="GreenTea.c1").pk
    assert (name.row, name.number, name.branch, name.language) == (
        "dialogue.topic",
        milk,
        "Drink",
        "it",
    )
    assert (sentence.row, sentence.number, sentence.language) == ("dialogue.frame", line, "ja")


def test_errors_come_first(small_draft: Folder) -> None:
    break_the_draft()
    blocks = [one.blocks for one in check_now().found]
    assert blocks == sorted(blocks, reverse=True)
    assert {True, False} == set(blocks)


def test_a_stored_test_that_fails_warns_with_its_sentence(small_draft: Folder) -> None:
    test = IntentTest.objects.get(sentence="I like tea")
    test.sentence = "Play I like tea"
    test.save()
    (found,) = [one for one in check_now().found if one.code == "T001"]
    assert (found.where, found.language, found.blocks, found.row) == (
        "playsong",
        "en",
        False,
        "plans.intent",
    )
    assert "‘Play I like tea’: matched by" in found.message


def test_an_intent_that_cannot_be_read_blocks(small_draft: Folder) -> None:
    Trigger.objects.filter(language="en").update(text="play {song")
    found = [one for one in check_now().found if one.code == "P001"]
    assert found
    assert all(one.blocks and one.row == "plans.intent" for one in found)
    assert found[0].language == "en"


def test_a_topic_has_the_findings_of_its_sentences_too(small_draft: Folder) -> None:
    break_the_draft()
    check_now()
    found = findings_for(["GreenTea", "GreenTea.c1", "Milk", "Tea"])
    assert {key: [one.code for one in these] for key, these in found.items()} == {
        "GreenTea": ["D015"],
        "GreenTea.c1": ["D015"],
        "Milk": ["D010"],
    }


def test_a_cycle_of_topics_is_told_not_a_crash(small_draft: Folder) -> None:
    drink, tea = Topic.objects.get(key="Drink"), Topic.objects.get(key="Tea")
    Topic.objects.filter(pk=drink.pk).update(parent=tea)
    assert "D003" in {one.code for one in check_now().found}


def test_the_page_shows_findings_in_words_with_links(
    small_draft: Folder, admin_client: Client
) -> None:
    break_the_draft()
    text = check_again(admin_client)
    milk = Topic.objects.get(key="Milk").pk
    assert "A topic without a name in a language" in text
    assert "It has no name in Italian." in text
    assert f'href="{reverse("admin:dialogue_topic_change", args=[milk])}">Milk</a>' in text
    assert "Nothing has changed since then." in text


def test_the_page_counts_changes_since_the_check(small_draft: Folder, admin_client: Client) -> None:
    check_now()
    for topic in Topic.objects.all()[:3]:
        topic.save()
    assert "3 changes since then: check again." in page(admin_client)


@pytest.mark.parametrize(
    ("asked", "seen", "hidden"),
    [
        ({"kind": "D010"}, "no name in Italian", "says nothing in Japanese"),
        ({"language": "ja"}, "says nothing in Japanese", "no name in Italian"),
        ({"branch": "Drink"}, "no name in Italian", "should be"),
        ({"branch": "-"}, "should be", "no name in Italian"),
        ({"kind": "<script>"}, "Nothing of this kind", "no name in Italian"),
    ],
)
def test_filters_show_one_kind_branch_or_language(
    asked: dict[str, str], seen: str, hidden: str, small_draft: Folder, admin_client: Client
) -> None:
    break_the_draft()
    check_now()
    text = page(admin_client, **asked)
    assert seen in text
    assert hidden not in text


def test_what_is_too_much_is_counted(
    small_draft: Folder, admin_client: Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(findings, "MOST_KEPT", 2)
    monkeypatch.setattr(checks, "MOST_SHOWN", 1)
    break_the_draft()
    checked = check_now()
    assert (len(checked.found), checked.errors) == (2, 1)
    assert checked.total > 2
    assert "1 more is not shown" in page(admin_client)


def test_the_page_takes_few_queries(
    small_draft: Folder, admin_client: Client, django_assert_max_num_queries: DjangoAssertNumQueries
) -> None:
    break_the_draft()
    check_now()
    with django_assert_max_num_queries(10):
        page(admin_client)


def test_the_same_draft_is_not_checked_twice_at_once(
    small_draft: Folder, admin_client: Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    check_again(admin_client)
    monkeypatch.setattr(checks, "check_now", None)
    check_again(admin_client)


@pytest.mark.parametrize("role", ["author", "publisher", "researcher", "administrator"])
def test_every_role_may_check(role: str, small_draft: Folder) -> None:
    assert "Checked: " in check_again(logged_in(role))


def test_nobody_else_may(small_draft: Folder) -> None:
    assert logged_in("").get(reverse("admin:checks")).status_code == 403
    assert Client().post(reverse("admin:checks")).status_code == 302
    assert last_check() is None


def test_all_kinds_are_named() -> None:
    assert set(CODES) <= set(KINDS)
    assert set(HINTS) <= set(KINDS)
    assert language_of("D009", "The likeliness 2 in IN is outside 0..1.") == ""
    assert language_of("C005", "There is nothing in it.") == ""


def test_languages_are_named_in_the_language_of_the_page() -> None:
    with translation.override("it"):
        assert plain("D015", "It says nothing in ja.") == "It says nothing in giapponese."


def test_a_finding_of_an_unknown_kind_is_shown_by_its_code() -> None:
    (group,) = checks.grouped([Found("X999", "Tea", "Strange.")], 10)
    assert (group.kind, group.shown[0].url) == ("X999", "")


def test_what_falls_short_of_a_quality_bar_warns_with_its_row(small_draft: Folder) -> None:
    found = [one for one in check_now().found if one.code == "C3" and one.where == "Drink"]
    drink = Topic.objects.get(key="Drink").pk
    assert {(one.row, one.number, one.branch, one.blocks) for one in found} == {
        ("dialogue.topic", drink, "Drink", False)
    }


def test_with_an_error_only_the_errors_are_told_first(small_draft: Folder) -> None:
    break_the_draft()
    assert "C3" not in {one.code for one in check_now().found}
