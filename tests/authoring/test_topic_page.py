"""The topic page: what the robot says, likeliness, place."""

import pytest
from django.test import Client
from django.urls import reverse
from pytest_django import DjangoAssertNumQueries

from authoring.roles import AUTHOR
from dialogue import models
from dialogue.content import read_knowledge
from dialogue.engine.build import build_tree
from tests.admin.pages import errors, send
from tests.authoring.topic_pages import member, page, panel, texts, topic

pytestmark = pytest.mark.usefixtures("small_draft")


def test_inherited_sentences_are_filled_as_the_robot_says_them() -> None:
    assert texts(panel("GreenTea"), "q") == ["Do you like green tea?"]
    assert texts(panel("GreenTea", "EN", "it"), "q") == ["Ti piace il tè verde?"]
    assert texts(panel("Drink", "EN", "it"), "q") == ["Ti piacciono le bevande?"]


def test_inherited_variables_are_filled() -> None:
    assert texts(panel("GreenTea"), "p") == [
        "Lovely. There is always a good moment for a cup of green tea."
    ]


@pytest.mark.parametrize("key", ["Drink", "Tea", "Milk", "GreenTea", "Flower"])
@pytest.mark.parametrize("language", ["en", "it", "ja"])
@pytest.mark.parametrize("culture", ["EN", "JP"])
def test_the_page_says_what_the_tree_of_the_whole_draft_says(
    key: str, language: str, culture: str
) -> None:
    whole = build_tree(read_knowledge()).by_key[key]
    wanted = {
        line.number
        for letter, lines in whole.lines.items()
        for line in lines
        if line.fits(language, culture) and not (whole.gentle and letter in "qg")
    }
    shown = panel(key, culture, language)
    said = [one.said for part in shown.sections for group in part.groups for one in group.sentences]
    assert {one.number for one in said if one.here} == wanted


def test_own_sentences_come_first_and_others_name_their_owner() -> None:
    models.Frame.objects.create(key="GreenTea.q1", topic=topic("GreenTea"), type="q", position=99)
    frame = models.Frame.objects.get(key="GreenTea.q1")
    models.Sentence.objects.create(frame=frame, language="en", text="Is green tea for you?")
    section = panel("GreenTea").sections[0]
    assert [(one.group.own, one.name) for one in section.groups] == [
        (True, "green tea"),
        (False, "drinks"),
    ]


def test_a_sentence_for_another_culture_stands_apart() -> None:
    remark = next(one for one in panel("GreenTea", "EN").sections if one.section.letter == "c")
    assert (remark.section.count, remark.elsewhere[0].cultures) == (0, ("Japanese",))
    assert texts(panel("GreenTea", "JP"), "c")[0].startswith("In Japan")


def test_a_gentle_topic_never_asks_whether_one_likes_it() -> None:
    flower = panel("Flower")
    assert [one.section.letter for one in flower.sections if one.section.silent] == ["q", "g"]


def test_the_sentences_a_topic_hands_down_only_are_shown_at_it_too() -> None:
    one = next(part for part in panel("Drink").sections if part.section.letter == "p")
    assert [(said.said.here, said.where) for said in one.groups[0].sentences] == [
        (False, "only what is below this topic")
    ]


def test_lent_sentences_are_told_apart() -> None:
    topic("Flower").also.add(topic("Drink"))
    models.Topic.objects.filter(key="Flower").update(gentle=False)
    group = panel("Flower").sections[0].groups[0]
    assert (group.group.lent, group.sentences[0].said.text) == (True, "Do you like flowers?")


def test_a_sentence_that_cannot_be_read_does_not_hide_the_page() -> None:
    models.Sentence.objects.filter(frame__key="Drink.q1", language="en").update(text="{is|are")
    models.TopicName.objects.filter(topic__key="GreenTea", language="it").update(fields={"g": "x"})
    assert panel("GreenTea", "EN", "it").unnamed
    elsewhere = panel("GreenTea").sections[0].elsewhere
    assert "'{' without '}'" in elsewhere[0].said.warnings[0].message


def test_a_missing_form_is_told_beside_the_sentence() -> None:
    models.Sentence.objects.filter(frame__key="Drink.q1", language="en").update(
        text="Is $hasName.one for you?"
    )
    said = panel("GreenTea").sections[0].groups[0].sentences[0].said
    assert "This topic has no $hasName.one." in said.warnings[0].message


@pytest.mark.parametrize("asked", [("", ""), ("XX", "fr"), ("\x00" * 50, "en'")])
def test_an_unknown_listener_is_the_usual_one(asked: tuple[str, str]) -> None:
    shown = panel("GreenTea", *asked)
    assert (shown.culture, shown.language in ("en", "ja")) == ("JP", True)


def test_every_culture_and_language_is_one_click_away(admin_client: Client) -> None:
    response = admin_client.get(page("GreenTea"), {"culture": "EN", "language": "it"})
    assert [len(row.choices) for row in response.context["panel"].rows] == [3, 3]
    assert "Ti piace il tè verde?" in response.content.decode()


def test_the_page_takes_few_queries_for_an_author(
    django_assert_max_num_queries: DjangoAssertNumQueries,
) -> None:
    client = member(AUTHOR)
    for place in range(40):
        below = models.Topic.objects.create(key=f"Tea{place}", parent=topic("Tea"))
        models.TopicLink.objects.create(topic=topic("GreenTea"), target=below, position=place + 2)
        models.Variable.objects.create(
            topic=topic("GreenTea"), language="en", name=f"v{'a' * place}", text="x"
        )
    for address in (
        page("GreenTea"),
        page("Drink"),
        reverse("admin:topic_picture", args=[topic("Tea").pk]),
        reverse("admin:dialogue_topic_changelist"),
        reverse("admin:dialogue_frame_changelist"),
    ):
        with django_assert_max_num_queries(25):
            assert client.get(address).status_code == 200


def test_the_spread_of_the_branch_stands_behind_each_slider(admin_client: Client) -> None:
    response = admin_client.get(page("GreenTea"))
    inlines = response.context["inline_admin_formsets"]
    forms = next(one for one in inlines if one.opts.tab == "likeliness").formset.forms
    seen = [
        (one.culture_name, one.spread.least, one.spread.middle, one.spread.most) for one in forms
    ]
    assert seen == [("English", 0.4, 0.5, 0.5), ("Japanese", 0.5, 0.5, 0.7)]
    assert [bar.here for bar in forms[0].spread.bars].index(True) == 8


def test_a_topic_is_moved_but_never_below_itself(admin_client: Client) -> None:
    milk, tea = topic("Milk"), topic("Tea")
    assert send(admin_client, page("GreenTea"), parent=str(milk.pk)).status_code == 302
    refused = errors(send(admin_client, page("Milk"), parent=str(topic("GreenTea").pk)))
    assert "Milk would lie below itself. Choose a topic that is not below it." in refused
    assert topic("GreenTea").parent_id != tea.pk


def test_very_long_words_are_refused(admin_client: Client) -> None:
    refused = send(admin_client, page("Milk"), note="a" * 10_000_000)
    assert refused.status_code == 413
    assert "Ensure this value has at most 2000" in errors(
        send(admin_client, page("Milk"), note="a" * 100_000)
    )
    assert topic("Milk").note == ""
