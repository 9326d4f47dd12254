"""The sentence page and the small form: previews, refusals with their place, ways back."""

from typing import Any

import pytest
from django.contrib.auth.models import Group, User
from django.test import Client
from django.urls import reverse

from authoring.roles import AUTHOR, RESEARCHER
from dialogue import models
from tests.admin.pages import errors, form_of, send
from tests.ontology.drafts import empty_draft, small_draft, small_folder

__all__ = ["empty_draft", "small_draft", "small_folder"]

pytestmark = pytest.mark.usefixtures("small_draft")


def topic(key: str) -> int:
    return models.Topic.objects.get(key=key).pk


def frame(key: str) -> models.Frame:
    return models.Frame.objects.get(key=key)


def page(key: str) -> str:
    return reverse("admin:dialogue_frame_change", args=[frame(key).pk])


def text(key: str, language: str) -> str:
    return models.Sentence.objects.get(frame__key=key, language=language).text


def place_of(key: str, language: str) -> int:
    rows = list(models.Sentence.objects.filter(frame__key=key))
    return next(place for place, row in enumerate(rows) if row.language == language)


def field(key: str, language: str) -> str:
    return f"sentences__{place_of(key, language)}__text"


# The sentence page refuses what cannot be said, with the place.


@pytest.mark.parametrize(
    ("key", "language", "words", "message"),
    [
        ("Drink.q1", "en", "Is it $color?", "The variable $color has no value here. At position 6"),
        (
            "Drink.q1",
            "en",
            "Is it $hasName.one?",
            "It cannot be said of Tea, Milk, GreenTea: ",
        ),
        (
            "Drink.q1",
            "it",
            "Vai $hasName.dove?",
            "It cannot be said of Drink, Tea, Milk and 1 more",
        ),
        ("Drink.q1", "ja", "{は|が}好き？", "A switch {...|...} is not used in Japanese."),
        ("Drink.q1", "it", "{a|b|c}?", "A switch with 3 options; it takes 2 or 4."),
        ("Drink.q1", "en", "Do\x1b you?", "Remove the invisible control character"),
        ("Drink.q1", "en", "a" * 401, "at most 400 characters (it has 401)"),
        ("start.1", "en", "Hello $hasName.", "This pool does not know $hasName."),
        ("begin.1", "en", "Take $toName.one.", ": This topic has no $toName.one"),
    ],
)
def test_what_cannot_be_said_is_refused_at_its_language(
    key: str, language: str, words: str, message: str, admin_client: Client
) -> None:
    before = text(key, language)
    name = field(key, language)
    refused = errors(send(admin_client, page(key), **{name: words}))
    assert message in refused.replace("Milk, Tea", "Tea, Milk")
    assert text(key, language) == before


def test_a_form_that_only_a_lower_topic_lacks_is_refused_too(admin_client: Client) -> None:
    models.TopicName.objects.filter(topic__key="Drink", language="en").update(
        fields={"n": "p", "bare": "drink", "one": "a drink"}
    )
    name = field("Drink.q1", "en")
    refused = errors(send(admin_client, page("Drink.q1"), **{name: "Is it $hasName.one?"}))
    assert "It cannot be said of Milk, Tea, GreenTea" in refused.replace("Tea, Milk", "Milk, Tea")
    kept = {name: "Is it $hasName.one?", "scope": "self"}
    assert send(admin_client, page("Drink.q1"), **kept).status_code == 302


def test_a_sentence_may_use_a_variable_of_a_topic_above(admin_client: Client) -> None:
    name = field("GreenTea.c1", "en")
    sent = send(admin_client, page("GreenTea.c1"), **{name: "Here is $unit tea."})
    assert sent.status_code == 302


def test_an_activity_that_cannot_be_made_is_refused(admin_client: Client) -> None:
    refused = errors(send(admin_client, page("Drink.g1"), do="playsong title=$hasName.zz"))
    assert "$hasName.zz is no form" in refused
    refused = errors(send(admin_client, page("Drink.g1"), do="playsong title=$color"))
    assert "Activity, title: it cannot be made for" in refused


def test_the_page_speaks_of_kinds_and_cultures_in_words(admin_client: Client) -> None:
    body = admin_client.get(page("GreenTea.c1")).content.decode()
    assert '<option value="q">yes/no question</option>' in body
    assert "Japanese</label>" in body.replace("\n", "")


# From the topic page and back.


def test_an_inherited_sentence_is_proposed_and_not_kept_until_saved(admin_client: Client) -> None:
    back = topic("GreenTea")
    address = (
        reverse("admin:dialogue_frame_add")
        + f"?topic={back}&type=q&from={frame('Drink.q1').pk}&back={back}&culture=EN&language=it"
    )
    before = models.Frame.objects.count()
    data = form_of(admin_client, address)
    shown = {
        data[f"sentences-{place}-language"]: data[f"sentences-{place}-text"] for place in range(3)
    }
    assert shown["it"] == text("Drink.q1", "it")
    assert models.Frame.objects.count() == before
    response = admin_client.post(address, data)
    made = frame("GreenTea.q1")
    assert {row.language: row.text for row in made.sentences.all()} == shown
    topic_page = reverse("admin:dialogue_topic_change", args=[back])
    assert response["Location"] == f"{topic_page}?culture=EN&language=it#s{made.pk}"


@pytest.mark.parametrize("back", ["//evil.example", "1;2", "９", "1" * 30, "-1"])
def test_one_only_comes_back_to_a_topic(back: str, admin_client: Client) -> None:
    address = f"{page('Drink.q1')}?back={back}"
    response = admin_client.post(address, form_of(admin_client, page("Drink.q1")))
    assert response["Location"] == reverse("admin:dialogue_frame_changelist")


# The small form.


def small(key: str) -> str:
    row = frame(key)
    return reverse("admin:topic_sentence", args=[row.topic_id, row.pk])


def written(client: Client, key: str, **texts: str) -> dict[str, Any]:
    form = client.get(small(key)).context["form"]
    shown = {name: form[name].value() for name in form.fields}
    return {form.add_prefix(name): words for name, words in (shown | texts).items()}


def test_a_sentence_is_changed_on_its_topics_page(admin_client: Client) -> None:
    data = written(admin_client, "Drink.q1", en="Are you fond of $hasName?")
    response = admin_client.post(f"{small('Drink.q1')}?culture=JP&language=en", data)
    assert text("Drink.q1", "en") == "Are you fond of $hasName?"
    assert response["Location"].endswith(f"?culture=JP&language=en#s{frame('Drink.q1').pk}")
    assert admin_client.post(
        f"{small('Drink.q1')}?part=1", written(admin_client, "Drink.q1")
    ).json()


@pytest.mark.parametrize(
    ("language", "words", "message"),
    [
        ("en", "", "Write the sentence."),
        ("en", "Is it $hasName.x?", "At position 6 of"),
        ("it", "Ti piace $colore?", "The variable $colore has no value here."),
        ("en", "a" * 500, "at most 400 characters"),
        ("ja", "a\x07b", "control character"),
    ],
)
def test_the_small_form_refuses_at_the_field_and_saves_nothing(
    language: str, words: str, message: str, admin_client: Client
) -> None:
    before = {one: text("Drink.q1", one) for one in ("en", "it", "ja")}
    other = "it" if language == "en" else "en"
    data = written(admin_client, "Drink.q1", **{language: words, other: "Bene? $hasName?"})
    response = admin_client.post(small("Drink.q1"), data)
    assert message in str(response.context["form"].errors[language])
    assert {one: text("Drink.q1", one) for one in before} == before


def test_a_sentence_is_only_changed_as_one_of_its_own_topic(admin_client: Client) -> None:
    address = reverse("admin:topic_sentence", args=[topic("Milk"), frame("Drink.q1").pk])
    assert admin_client.get(address).status_code == 404


def test_a_researcher_changes_nothing() -> None:
    user = User.objects.create_user("reader", is_staff=True)
    user.groups.add(Group.objects.get(name=RESEARCHER))
    client = Client()
    client.force_login(user)
    assert client.get(small("Drink.q1")).status_code == 403
    assert client.post(small("Drink.q1"), {}).status_code == 403
    assert client.get(page("Drink.q1")).status_code == 200
    user.groups.set([Group.objects.get(name=AUTHOR)])
    assert client.get(small("Drink.q1")).status_code == 200


# Previews.


def tried(client: Client, **data: object) -> dict[str, Any]:
    response = client.post(reverse("admin:try_sentence"), data)
    assert response.status_code == 200
    found = response.json()["languages"]
    assert isinstance(found, dict)
    return found


def test_words_are_tried_with_three_topics(admin_client: Client) -> None:
    found = tried(admin_client, topic=topic("Drink"), type="q", en="Do you like $hasName?")
    texts = {one["text"] for one in found["en"]["said"]}
    assert {"Do you like drinks?", "Do you like green tea?"} <= texts
    assert len(texts) == 3


def test_words_are_tried_with_one_topic_when_it_is_named(admin_client: Client) -> None:
    found = tried(
        admin_client,
        topic=topic("Drink"),
        about=topic("Milk"),
        type="q",
        it="Ti {piace|piacciono} $hasName?",
    )
    assert [one["text"] for one in found["it"]["said"]] == ["Ti piace il latte?"]


@pytest.mark.parametrize(
    ("words", "position"), [("Is it $hasName.x?", 6), ("a" * 401, 400), ("a\x00b", 1), ("{", 0)]
)
def test_unreadable_words_say_where(words: str, position: int, admin_client: Client) -> None:
    found = tried(admin_client, topic=topic("Drink"), type="q", en=words)
    assert (found["en"]["position"], bool(found["en"]["problem"])) == (position, True)


def test_words_are_looked_at_while_they_are_written(admin_client: Client) -> None:
    found = tried(admin_client, topic=topic("Milk"), type="q", en="Do you like $hasName.")
    assert found["en"]["said"][0]["warnings"][0]["message"] == "A question must end the sentence."


def test_a_line_of_a_pool_is_tried(admin_client: Client) -> None:
    found = tried(admin_client, pool="begin", en="Let us talk about $toName.", it="Ecco $colore.")
    assert any("green tea" in one["text"] for one in found["en"]["said"])
    assert "does not know $colore" in found["it"]["problem"]


@pytest.mark.parametrize(
    "data",
    [
        {},
        {"topic": "999999999", "en": "Hello."},
        {"topic": "x", "type": "zz", "scope": "?", "en": "Hello."},
        {"topic": "1" * 400, "culture": "\x00", "about": "-1", "en": "Hello."},
        {"pool": "no such pool", "en": "Hello."},
    ],
)
def test_a_strange_request_is_answered_quietly(data: dict[str, str], admin_client: Client) -> None:
    found = tried(admin_client, **data)
    assert found["en"]["said"] == []


def test_sentences_are_narrowed(admin_client: Client) -> None:
    models.Sentence.objects.get(frame__key="Drink.p1", language="ja").delete()
    address = reverse("admin:dialogue_frame_changelist")

    def listed(**asked: str) -> list[str]:
        rows = admin_client.get(address, asked).context["cl"].result_list
        return sorted(row.key for row in rows)

    assert listed(branch="Drink") == ["Drink.g1", "Drink.p1", "Drink.q1", "GreenTea.c1"]
    assert listed(missing="ja") == ["Drink.p1"]
    assert listed(type__exact="c") == ["GreenTea.c1"]
    assert listed(q="お好き") == ["Drink.q1"]
