"""The forms of the admin, sent as a browser sends them: what is shown, with a few changes."""

from collections.abc import Iterator

from django import forms
from django.http import HttpResponse
from django.test import Client


def form_of(client: Client, address: str) -> dict[str, str | list[str]]:
    """Return what the form of a page would send as it stands."""
    page = client.get(address)
    assert page.status_code == 200, address
    data: dict[str, str | list[str]] = dict(_fields(page.context["adminform"].form))
    for inline in page.context["inline_admin_formsets"]:
        data |= dict(_fields(inline.formset.management_form))
        for form in inline.formset.forms:
            data |= dict(_fields(form))
    return data


def _fields(form: forms.BaseForm) -> Iterator[tuple[str, str | list[str]]]:
    for bound in form:
        value = bound.value()
        if value is None or value is False:
            continue
        if isinstance(value, list | tuple):
            yield bound.html_name, [str(getattr(one, "pk", one)) for one in value]
        else:
            yield bound.html_name, str(value)
        if bound.field.show_hidden_initial:
            yield bound.html_initial_name, str(value)


def send(client: Client, address: str, **changes: str) -> HttpResponse:
    """Send the form of a page with some fields changed (`__` stands for `-`)."""
    data = form_of(client, address)
    return client.post(address, data | {name.replace("__", "-"): v for name, v in changes.items()})


def errors(response: HttpResponse) -> str:
    """Return every message of a form that was refused."""
    assert response.status_code == 200, "The form was accepted."
    forms_shown = [response.context["adminform"].form]
    found = []
    for inline in response.context["inline_admin_formsets"]:
        forms_shown += inline.formset.forms
        found += inline.formset.non_form_errors()
    for form in forms_shown:
        for field, messages in form.errors.get_json_data().items():
            found += [f"{field}: {message['message']}" for message in messages]
    return "\n".join(found)
