"""Who sees and changes the pages of topics, and the list of topics."""

import pytest
from django.db.models import Max
from django.test import Client
from django.urls import reverse

from authoring.roles import ADMINISTRATOR, AUTHOR, PUBLISHER, RESEARCHER
from dialogue import models
from tests.authoring.topic_pages import member, page, topic

pytestmark = pytest.mark.usefixtures("small_draft")


def listed(client: Client, **asked: str) -> list[str]:
    response = client.get(reverse("admin:dialogue_topic_changelist"), asked)
    return [row.key for row in response.context["cl"].result_list]


def test_topics_are_narrowed(admin_client: Client) -> None:
    models.TopicName.objects.get(topic__key="Milk", language="it").delete()
    assert listed(admin_client, branch="Flower") == ["Flower"]
    assert "GreenTea" in listed(admin_client, branch="Drink")
    assert sorted(listed(admin_client, own="yes")) == ["Drink", "GreenTea"]
    assert listed(admin_client, missing="it") == ["Milk"]
    assert listed(admin_client, q="cuppa") == ["Tea"]


def test_the_list_counts_own_sentences_and_tells_of_missing_names(admin_client: Client) -> None:
    models.TopicName.objects.get(topic__key="Milk", language="it").delete()
    response = admin_client.get(reverse("admin:dialogue_topic_changelist"))
    rows = {row.key: row for row in response.context["cl"].result_list}
    assert (rows["Drink"].sentence_count, rows["Tea"].sentence_count) == (3, 0)
    assert rows["GreenTea"].branch_key == "Drink"
    assert "no name in Italian" in response.content.decode()


@pytest.mark.parametrize("role", [AUTHOR, PUBLISHER, ADMINISTRATOR])
def test_those_who_write_are_offered_to_change(role: str) -> None:
    body = member(role).get(page("GreenTea")).content.decode()
    assert "Say it differently here" in body
    assert "Add a sentence" in body


def test_a_researcher_only_reads() -> None:
    client = member(RESEARCHER)
    response = client.get(page("GreenTea"))
    body = response.content.decode()
    assert response.status_code == 200
    assert (
        "Do you like green tea?" in client.get(page("GreenTea") + "?language=en").content.decode()
    )
    assert "Say it differently here" not in body
    assert "Change here" not in body


def addresses() -> list[str]:
    number = topic("GreenTea").pk
    return [reverse(f"admin:topic_{name}", args=[number]) for name in ("said", "picture")]


def test_nobody_without_a_role_sees_anything() -> None:
    client = member("nobody")
    assert [client.get(one).status_code for one in addresses()] == [403, 403]
    assert client.post(reverse("admin:try_sentence")).status_code == 403
    assert Client().get(addresses()[0]).status_code == 302


def test_a_topic_that_is_gone_is_not_found(admin_client: Client) -> None:
    gone = (models.Topic.objects.aggregate(last=Max("pk"))["last"] or 0) + 1
    for name in ("said", "picture"):
        assert admin_client.get(reverse(f"admin:topic_{name}", args=[gone])).status_code == 404


def test_the_picture_is_drawn_with_links(admin_client: Client) -> None:
    body = admin_client.get(addresses()[1]).content.decode()
    assert body.count('class="box ') == 4
    assert f'href="{page("Milk")}"' in body
    assert "style=" not in body.partition('<svg class="neighbours"')[2].partition("</svg>")[0]
