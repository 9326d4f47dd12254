"""The names of a topic in plain words, with the forms that are made of them."""

import json

import pytest
from django.test import Client
from django.urls import reverse

from dialogue import models
from tests.admin.pages import errors, send
from tests.authoring.topic_pages import page

pytestmark = pytest.mark.usefixtures("small_draft")


def place_of(key: str, language: str) -> int:
    rows = list(models.TopicName.objects.filter(topic__key=key))
    return next(place for place, row in enumerate(rows) if row.language == language)


def stored(key: str, language: str) -> dict[str, str]:
    fields = models.TopicName.objects.get(topic__key=key, language=language).fields
    assert isinstance(fields, dict)
    return fields


def test_a_plain_field_is_stored_among_the_forms(admin_client: Client) -> None:
    place = place_of("GreenTea", "it")
    changes = {f"names__{place}__form_n": "p", f"names__{place}__form_un": "una tazza"}
    assert send(admin_client, page("GreenTea"), **changes).status_code == 302
    assert stored("GreenTea", "it") == {"g": "m", "n": "p", "un": "una tazza"}


def test_an_emptied_plain_field_is_taken_away(admin_client: Client) -> None:
    changes = {f"names__{place_of('GreenTea', 'en')}__form_count": ""}
    assert send(admin_client, page("GreenTea"), **changes).status_code == 302
    assert stored("GreenTea", "en") == {}


@pytest.mark.parametrize(
    ("field", "value", "message"),
    [
        ("form_g", "", "form_g: g: The gender is missing."),
        ("form_g", "neuter", "form_g: Select a valid choice."),
        ("form_un", "$x", "form_un: un: '$' cannot be part of a name."),
        ("form_un", "a" * 121, "form_un: Ensure this value has at most 120 characters"),
        ("fields", json.dumps({"un": "a" * 5000}), "The further forms of a name are too long."),
    ],
)
def test_a_wrong_form_is_refused_at_its_own_field(
    field: str, value: str, message: str, admin_client: Client
) -> None:
    changes = {f"names__{place_of('GreenTea', 'it')}__{field}": value}
    assert message in errors(send(admin_client, page("GreenTea"), **changes))
    assert stored("GreenTea", "it") == {"g": "m"}


def forms_of(client: Client, **data: str) -> dict[str, object]:
    found = client.post(reverse("admin:name_forms"), data).json()
    assert isinstance(found, dict)
    return found


def test_the_forms_of_a_name_are_shown_while_it_is_written(admin_client: Client) -> None:
    found = forms_of(admin_client, language="it", name="tè verde", g="m")
    assert {"asked": "$hasName.di", "text": "del tè verde"} in found["forms"]


@pytest.mark.parametrize(
    ("data", "problem"),
    [
        ({"language": "it", "name": "tè"}, "The gender is missing."),
        ({"language": "fr", "name": "thé"}, "Choose a language."),
        ({"language": "en", "name": "a" * 200}, "Use at most 120 characters."),
        ({"language": "en", "name": "a\x00b"}, "cannot be part of a name"),
        ({}, "Choose a language."),
    ],
)
def test_a_name_that_has_no_forms_says_why(
    data: dict[str, str], problem: str, admin_client: Client
) -> None:
    found = forms_of(admin_client, **data)
    assert problem in str(found["problem"])
    assert found["forms"] == []


def test_a_topic_without_a_name_in_a_language_has_room_for_it(admin_client: Client) -> None:
    models.TopicName.objects.get(topic__key="Milk", language="it").delete()
    response = admin_client.get(page("Milk"))
    forms = response.context["inline_admin_formsets"][0].formset.forms
    assert [form.code for form in forms] == ["en", "ja", "it"]
    changes = {"names__2__name": "latte", "names__2__form_g": "m"}
    assert send(admin_client, page("Milk"), **changes).status_code == 302
    assert stored("Milk", "it") == {"g": "m"}
