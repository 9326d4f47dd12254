"""The authoring pages: all open, few queries, and what is wrong is refused at its field."""

import json

import pytest
from django.apps import apps
from django.contrib import admin
from django.db import IntegrityError, transaction
from django.db.models import Model
from django.test import Client
from django.urls import reverse
from pytest_django import DjangoAssertNumQueries

from dialogue import models
from dialogue.content import read_knowledge
from dialogue.engine.concepts import Topic
from dialogue.publishing import NotPublishableError, publish
from ontology_io.files.folder import Folder
from plans.models import Intent, IntentTest, Phrase, PlanAction, Slot, Trigger, ValueList
from tests.admin.pages import errors, send

pytestmark = pytest.mark.usefixtures("small_draft")
OURS = [
    model
    for app in ("dialogue", "plans")
    for model in apps.get_app_config(app).get_models()
    if admin.site.is_registered(model)
]
NAMES = [model.__name__ for model in OURS]


def page(model: type[Model], kind: str, *arguments: object) -> str:
    return reverse(f"admin:{model._meta.label_lower.replace('.', '_')}_{kind}", args=arguments)


def change(model: type[Model], **sought: object) -> str:
    return page(model, "change", model._default_manager.get(**sought).pk)


def topics() -> dict[str, Topic]:
    return {topic.key: topic for topic in read_knowledge().topics}


def many_more_rows() -> None:
    """Add thirty rows to each list, so that a query a row would be seen."""
    tea = models.Topic.objects.get(key="Tea")
    for place in range(30):
        topic = models.Topic.objects.create(key=f"Tea{place}", parent=tea, home_id=tea.home_id)
        models.Frame.objects.create(key=f"Tea{place}.q1", topic=topic, type="q")
        models.Publication.objects.create(checksum=str(place), data=b"")
        Intent.objects.create(key=f"tea{place}")


def test_every_page_of_ours_is_registered() -> None:
    assert set(NAMES) == {
        "Culture",
        "Frame",
        "Intent",
        "Phrase",
        "Publication",
        "Topic",
        "ValueList",
    }


@pytest.mark.parametrize("model", OURS, ids=NAMES)
def test_lists_open_with_a_bounded_number_of_queries(
    model: type[Model], admin_client: Client, django_assert_max_num_queries: DjangoAssertNumQueries
) -> None:
    publish()
    many_more_rows()
    with django_assert_max_num_queries(10):
        response = admin_client.get(page(model, "changelist"))
    assert response.status_code == 200
    assert "result_list" in response.content.decode()


@pytest.mark.parametrize("model", OURS, ids=NAMES)
def test_every_row_opens_and_saves_as_it_is(model: type[Model], admin_client: Client) -> None:
    publish()
    before = read_knowledge()
    for row in model._default_manager.all()[:8]:
        response = send(admin_client, page(model, "change", row.pk))
        assert response.status_code == 302, errors(response)
    assert read_knowledge() == before


@pytest.mark.parametrize("model", OURS, ids=NAMES)
def test_the_page_of_a_new_row_opens(model: type[Model], admin_client: Client) -> None:
    wanted = 403 if model is models.Publication else 200
    assert admin_client.get(page(model, "add")).status_code == wanted


@pytest.mark.parametrize("model", OURS, ids=NAMES)
def test_a_stranger_is_sent_to_the_login(model: type[Model], client: Client) -> None:
    assert client.get(page(model, "changelist")).status_code == 302


@pytest.mark.parametrize("words", ["milk", "latte", "牛乳"])
def test_a_topic_is_found_by_its_name(words: str, admin_client: Client) -> None:
    response = admin_client.get(page(models.Topic, "changelist"), {"q": words})
    assert [row.key for row in response.context["cl"].result_list] == ["Milk"]


def test_a_publication_can_neither_be_made_nor_deleted_here(
    admin_client: Client, small_draft: Folder
) -> None:
    row = publish()
    assert admin_client.post(page(models.Publication, "add")).status_code == 403
    assert admin_client.post(page(models.Publication, "delete", row.pk)).status_code == 403
    send(admin_client, page(models.Publication, "change", row.pk), note="The first")
    row.refresh_from_db()
    assert (row.note, publish().pk) == ("The first", row.pk)


@pytest.mark.parametrize(
    ("field", "value", "message"),
    [
        ("key", "Green tea", "Write one word of letters and digits, e.g. GreenTea."),
        ("key", "緑茶", "Write one word of letters and digits"),
        ("key", "Topic", "Topic is the root itself."),
        ("key", "Tea", "Topic with this Name in the ontology already exists."),
        ("stop", "qx", "Use the letters of sentence types."),
        ("pattern", "q z", "'z' in the pattern 'q z' is no sentence type"),
        ("note", "a\x07b", "Remove the invisible control characters"),
        ("names__0__name", "mi\x00lk", "Null characters are not allowed."),
        ("names__0__name", "mi\x1blk", "Remove the invisible control characters"),
        ("names__0__name", "$milk", "name: '$' cannot be part of a name."),
        ("names__0__fields", "{", "Enter a valid JSON."),
        ("names__0__fields", "[]x", "Enter a valid JSON."),
        ("names__0__fields", '["n"]', "Write texts by name"),
        ("names__0__fields", '{"n": 1}', "Write texts by name"),
        ("names__0__fields", '{"n": "x"}', "n: 'x' is no choice."),
        ("names__0__fields", '{"colour": "white"}', "colour: A name has no such field. Use one"),
        ("names__0__fields", '{"name": "milk"}', "The name itself has a field of its own."),
        ("keywords__0__first", "milk / cream", "Write one set of words apart by |"),
        ("instances__0__likeliness", "1.5", "less than or equal to 1."),
        ("instances__0__likeliness", "-0.1", "greater than or equal to 0."),
        ("instances__0__likeliness", "NaN", "Enter a number."),
        ("instances__0__likeliness", "much", "Enter a number."),
    ],
)
def test_what_is_wrong_in_a_topic_is_refused_at_its_field(
    field: str, value: str, message: str, admin_client: Client
) -> None:
    before = read_knowledge()
    response = send(admin_client, change(models.Topic, key="Milk"), **{field: value})
    assert message in errors(response)
    assert read_knowledge() == before


def test_a_japanese_name_is_checked_by_its_own_rules(admin_client: Client) -> None:
    number = models.TopicName.objects.get(topic__key="Milk", language="ja")
    place = list(models.TopicName.objects.filter(topic__key="Milk")).index(number)
    changes = {f"names__{place}__fields": '{"g": "m"}'}
    response = send(admin_client, change(models.Topic, key="Milk"), **changes)
    assert "g: A name has no such field. Use one of: kana, name, polite." in errors(response)


@pytest.mark.parametrize("below", ["Drink", "Tea", "GreenTea"])
def test_a_topic_is_never_below_itself(below: str, admin_client: Client) -> None:
    parent = str(models.Topic.objects.get(key=below).pk)
    response = send(admin_client, change(models.Topic, key="Drink"), parent=parent)
    assert "Drink would lie below itself. Choose a topic that is not below it." in errors(response)


def test_a_topic_never_leads_to_itself_nor_twice_to_another(admin_client: Client) -> None:
    milk = models.Topic.objects.get(key="Milk")
    address = change(models.Topic, key="Milk")
    response = send(admin_client, address, links__0__target=str(milk.pk))
    assert "A topic cannot lead to itself. Choose another one." in errors(response)
    tea = str(models.TopicLink.objects.get(topic=milk).target_id)
    more = {"links__TOTAL_FORMS": "2", "links__1__target": tea, "links__1__position": "2"}
    more["links__1__topic"] = str(milk.pk)
    assert "Please correct the duplicate data" in errors(send(admin_client, address, **more))


@pytest.mark.parametrize("value", ["1.001", "-0.001"])
def test_the_database_refuses_a_likeliness_outside_too(value: str) -> None:
    rows = models.TopicInstance.objects.filter(topic__key="Milk")
    with pytest.raises(IntegrityError, match="likeliness_0_to_1"), transaction.atomic():
        rows.update(likeliness=value)


NEW_NAMES = {
    "names__0__language": "en",
    "names__0__name": "cocoa",
    "names__0__fields": '{"count": "no"}',
    "names__1__language": "it",
    "names__1__name": "cioccolata",
    "names__1__fields": '{"g": "f"}',
    "names__2__language": "ja",
    "names__2__name": "ココア",
    "names__2__fields": "{}",
}


def test_a_new_topic_with_names_can_be_published(admin_client: Client) -> None:
    drink = str(models.Topic.objects.get(key="Drink").pk)
    response = send(admin_client, page(models.Topic, "add"), key="Cocoa", parent=drink, **NEW_NAMES)
    assert response.status_code == 302, errors(response)
    assert topics()["Cocoa"].likeliness == {"EN": 0.5, "JP": 0.5}
    assert models.TopicInstance.objects.filter(topic__key="Cocoa").count() == 2
    assert [topic.key for topic in read_knowledge().topics][-2] == "Cocoa"
    assert publish().counts["topics"] == 6


def test_a_new_topic_at_home_somewhere_is_liked_more_there(admin_client: Client) -> None:
    home = str(models.Culture.objects.get(code="JP").pk)
    send(admin_client, page(models.Topic, "add"), key="Cocoa", home=home, **NEW_NAMES)
    assert topics()["Cocoa"].likeliness == {"EN": 0.3, "JP": 0.7}


def test_a_new_topic_without_names_is_told_of_when_publishing(admin_client: Client) -> None:
    send(admin_client, page(models.Topic, "add"), key="Cocoa")
    with pytest.raises(NotPublishableError, match=r"D010 Cocoa: It has no name in en\. Hint: Add"):
        publish()


def test_a_renamed_topic_takes_its_sentences_along(admin_client: Client) -> None:
    number = models.Frame.objects.get(key="GreenTea.c1").pk
    send(admin_client, change(models.Topic, key="GreenTea"), key="Sencha")
    assert models.Frame.objects.get(pk=number).key == "Sencha.c1"
    assert topics()["Sencha"].frames[0].number == number


def test_a_new_culture_needs_nothing_else_to_be_published(admin_client: Client) -> None:
    names = json.dumps({"en": "Indian", "it": "indiana", "ja": "インド"})
    send(admin_client, page(models.Culture, "add"), code="IN", language="en", names=names)
    assert topics()["Milk"].likeliness == {"EN": 0.5, "JP": 0.5, "IN": 0.5}
    publish()


@pytest.mark.parametrize(
    ("model", "field", "value", "message"),
    [
        (models.Culture, "code", "en", "Write two to eight capitals, e.g. EN."),
        (models.Culture, "names", "[1]", "a text for each language."),
        (models.Culture, "names", '{"fr": "a"}', "use en, it, ja."),
        (models.Culture, "names", '{"en": 1}', "must be a text"),
        (Phrase, "key", "a b", "Write one word of small letters"),
        (Phrase, "texts", '{"en": ""}', "must be a text without outer blanks"),
        (ValueList, "values", '{"en": ["up"]}', "the words of each value."),
        (ValueList, "values", '{"en": {"louder": "up"}}', "write a list of words in [ ]."),
        (ValueList, "values", '{"en": {"louder": ["a|b"]}}', "write words one by one"),
        (ValueList, "values", '{"en": {"louder": [1]}}', "must be a text"),
        (Intent, "priority", "101", "less than or equal to 100"),
        (Intent, "slots__0__kind", "word", "Write text, topic, number, duration"),
        (Intent, "slots__0__questions", '{"en": ["a"]}', "must be a text"),
        (Intent, "triggers__0__text", "play {title", "at position 5 of"),
        (Intent, "plan_sentences__0__only", "Japan", "Write codes of cultures"),
        (Intent, "plan_actions__0__parameters", '["title"]', "names and values in order."),
        (Intent, "plan_actions__0__parameters", '[["a", "x b=c"]]', "A value cannot hold #"),
        (Intent, "plan_actions__0__parameters", '[["a", "x#y"]]', "Expected 'action="),
        (Intent, "plan_actions__0__action", "play song", "Write one word of small letters"),
        (Intent, "tests__0__sentence", "a -> b", "A test cannot hold '->'."),
        (Intent, "tests__0__parameters", '["a"]', "or leave it empty."),
        (Intent, "tests__0__parameters", '{"a b": "c"}', "write a name of small letters"),
        (Intent, "tests__0__parameters", '{"a": "b | c"}', "A test cannot hold"),
    ],
)
def test_what_is_wrong_elsewhere_is_refused_at_its_field(
    model: type[Model], field: str, value: str, message: str, admin_client: Client
) -> None:
    row = model._default_manager.earliest("pk")
    response = send(admin_client, page(model, "change", row.pk), **{field: value})
    assert message in errors(response)


def test_two_names_in_one_language_are_refused(admin_client: Client) -> None:
    changes = {"names__1__language": "en", "names__1__fields": "{}"}
    response = send(admin_client, change(models.Topic, key="Milk"), **changes)
    assert "Please correct the duplicate data for language" in errors(response)


def test_two_sentences_in_one_language_are_refused(admin_client: Client) -> None:
    address = change(models.Frame, key="Drink.q1")
    response = send(admin_client, address, sentences__1__language="en")
    assert "Please correct the duplicate data for language" in errors(response)


@pytest.mark.parametrize(
    ("field", "value", "message"),
    [
        ("sentences__0__text", "Do you like $hasName.x?", "$hasName.x is no form; use one of"),
        ("sentences__0__text", "{is|are", "'{' without '}', or with"),
        ("sentences__0__text", "a\x07b", "Remove the invisible control characters"),
        ("do", "play song", "is no parameter; write name=value."),
        ("key", "Milk.q1", "It must be Drink.q and a number, or left empty."),
        ("key", "Drink.p1", "It must be Drink.q and a number"),
        ("key", "Drink q1", "Write it like GreenTea.q1."),
        ("type", "", "Choose what kind of sentence it is."),
        ("pool", "start", "Choose either a topic or a pool."),
        ("topic", "", "Choose either a topic or a pool."),
    ],
)
def test_what_is_wrong_in_a_sentence_is_refused_at_its_field(
    field: str, value: str, message: str, admin_client: Client
) -> None:
    address = change(models.Frame, key="Drink.q1")
    assert message in errors(send(admin_client, address, **{field: value}))


NEW_SENTENCES = {
    "sentences__0__language": "en",
    "sentences__0__text": "Is there a cup for me?",
    "sentences__1__language": "it",
    "sentences__1__text": "C'è una tazza per me?",
    "sentences__2__language": "ja",
    "sentences__2__text": "一杯ありますか？",
}


@pytest.mark.parametrize(
    ("where", "key"),
    [
        ({"type": "q"}, "Drink.q2"),
        ({"type": "w"}, "Drink.w1"),
        ({"type": "q", "key": "Drink.q7"}, "Drink.q7"),
        ({"type": "", "topic": "", "pool": "start"}, "start.2"),
    ],
)
def test_a_new_sentence_gets_the_next_free_key_and_can_be_published(
    where: dict[str, str], key: str, admin_client: Client
) -> None:
    topic = {"topic": str(models.Topic.objects.get(key="Drink").pk)}
    address = page(models.Frame, "add")
    response = send(admin_client, address, **(topic | where), **NEW_SENTENCES)
    assert response.status_code == 302, errors(response)
    assert models.Frame.objects.latest("pk").key == key
    publish()


def test_a_sentence_moved_to_another_topic_gets_a_key_of_it(admin_client: Client) -> None:
    number = models.Frame.objects.get(key="GreenTea.c1").pk
    milk = str(models.Topic.objects.get(key="Milk").pk)
    send(admin_client, page(models.Frame, "change", number), topic=milk)
    assert models.Frame.objects.get(pk=number).key == "Milk.c1"


def test_a_line_of_a_pool_has_no_type(admin_client: Client) -> None:
    response = send(admin_client, change(models.Frame, key="start.1"), type="q")
    assert "A line of a pool has no type; leave it empty." in errors(response)


def test_an_intent_made_here_can_be_published(admin_client: Client) -> None:
    intent = Intent.objects.create(key="rest", position=9)
    Trigger.objects.create(intent=intent, language="en", text="take a rest")
    PlanAction.objects.create(intent=intent, action="rest")
    IntentTest.objects.create(intent=intent, language="en", sentence="Take a rest", parameters={})
    assert send(admin_client, change(Intent, key="rest")).status_code == 302
    assert not Slot.objects.filter(intent=intent).exists()
    assert publish().counts["intents"] == 2
