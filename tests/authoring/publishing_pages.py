"""What the tests of publishing share."""

from django.http import HttpResponse
from django.test import Client
from django.urls import reverse

from authoring.models import PublishRun
from authoring.releases.publish_run import begin, carry_out
from dialogue.draft import draft_version
from dialogue.models import TopicName

JSON = {"Accept": "application/json"}


def page(client: Client, **asked: str) -> str:
    response = client.get(reverse("admin:publish"), asked)
    assert response.status_code == 200
    return str(response.content.decode())


def send(client: Client, **data: str) -> HttpResponse:
    return client.post(reverse("admin:publish"), {"draft": str(draft_version()), **data})


def followed(client: Client, **data: str) -> str:
    data = {"draft": str(draft_version()), **data}
    response = client.post(reverse("admin:publish"), data, follow=True)
    return str(response.content.decode())


def warm_milk() -> None:
    row = TopicName.objects.get(topic__key="Milk", language="en")
    row.name = "warm milk"
    row.save()


def run_now(note: str = "") -> PublishRun:
    return carry_out(begin(None, note, draft_version()))
