"""Two experts on one page: whoever saves second is told, and nothing is lost silently."""

import pytest
from django.contrib import admin
from django.db.models import Model
from django.http import HttpResponse
from django.test import Client
from django.urls import reverse

from authoring.admin.base import ContentAdmin
from authoring.history.conflicts import SEEN, rebased
from authoring.roles import AUTHOR, RESEARCHER
from dialogue import models
from plans.models import Intent
from tests.admin.pages import form_of
from tests.authoring.people import logged_in

pytestmark = pytest.mark.usefixtures("small_draft")
Form = dict[str, str | list[str]]
EDITED = [model for model, shown in admin.site._registry.items() if isinstance(shown, ContentAdmin)]


@pytest.fixture
def maria() -> Client:
    return logged_in(AUTHOR, "Maria")


@pytest.fixture
def ken() -> Client:
    return logged_in(AUTHOR, "Ken")


def address(row: Model, kind: str = "change") -> str:
    return reverse(f"admin:{row._meta.app_label}_{row._meta.model_name}_{kind}", args=(row.pk,))


def drink() -> str:
    return address(models.Topic.objects.get(key="Drink"))


def milk() -> models.Topic:
    return models.Topic.objects.get(key="Milk")


def again(page: HttpResponse) -> Form:
    """Return what the page of a conflict sends when one's own text is saved over."""
    data: Form = {}
    for name, text in page.context["again"]:
        data[name] = [*data.get(name, []), text]
    return data | {SEEN: page.context["draft_seen"]}


@pytest.mark.parametrize("model", EDITED, ids=lambda model: model.__name__)
def test_every_form_of_the_draft_carries_what_it_showed(model: type[Model], maria: Client) -> None:
    row = model._default_manager.earliest("pk")
    page = maria.get(address(row))
    seen = page.context["draft_seen"]
    assert f'name="{SEEN}" value="{seen}"' in page.content.decode()
    assert maria.post(address(row), form_of(maria, address(row))).status_code == 302


@pytest.mark.parametrize("model", EDITED, ids=lambda model: model.__name__)
def test_every_form_of_the_draft_tells_who_comes_second(
    model: type[Model], maria: Client, ken: Client
) -> None:
    row = model._default_manager.earliest("pk")
    first, second = form_of(maria, address(row)), form_of(ken, address(row))
    name = "note" if "note" in first or hasattr(row, "note") else "position"
    assert maria.post(address(row), first | {name: "77"}).status_code == 302
    answer = ken.post(address(row), second | {name: "88"})
    assert answer.status_code == 409
    assert str(getattr(model._default_manager.get(pk=row.pk), name)) == "77"


def test_the_second_sees_both_texts_and_who_was_first(maria: Client, ken: Client) -> None:
    first, second = form_of(maria, drink()), form_of(ken, drink())
    maria.post(drink(), first | {"note": "by the nurses"})
    page = ken.post(drink(), second | {"note": "by the doctors"}).content.decode()
    assert "by the nurses" in page
    assert "by the doctors" in page
    assert "Maria changed the topic Drink" in page


def test_the_second_saves_over_it_deliberately(maria: Client, ken: Client) -> None:
    first, second = form_of(maria, drink()), form_of(ken, drink())
    maria.post(drink(), first | {"note": "by the nurses"})
    page = ken.post(drink(), second | {"note": "by the doctors"})
    assert ken.post(drink(), again(page)).status_code == 302
    assert models.Topic.objects.get(key="Drink").note == "by the doctors"


def test_a_third_change_is_told_again(maria: Client, ken: Client) -> None:
    first, second = form_of(maria, drink()), form_of(ken, drink())
    maria.post(drink(), first | {"note": "one"})
    page = ken.post(drink(), second | {"note": "two"})
    maria.post(drink(), form_of(maria, drink()) | {"note": "three"})
    answer = ken.post(drink(), again(page))
    assert answer.status_code == 409
    assert "three" in answer.content.decode()


def test_a_change_in_a_part_is_a_conflict(maria: Client, ken: Client) -> None:
    first, second = form_of(maria, drink()), form_of(ken, drink())
    maria.post(drink(), first | {"names-0-name": "beverage"})
    page = ken.post(drink(), second | {"note": "mine"})
    assert page.status_code == 409
    assert "beverage" in page.content.decode()


def test_what_is_lent_is_a_conflict(maria: Client, ken: Client) -> None:
    first, second = form_of(maria, drink()), form_of(ken, drink())
    maria.post(drink(), first | {"also": [str(milk().pk)]})
    page = ken.post(drink(), second | {"note": "mine"})
    assert page.status_code == 409
    assert "Milk" in page.content.decode()


def test_a_part_that_the_other_deleted_is_put_back_by_saving_over(
    maria: Client, ken: Client
) -> None:
    intent = address(Intent.objects.earliest("pk"))
    first, second = form_of(maria, intent), form_of(ken, intent)
    text = str(second["triggers-0-text"])
    maria.post(intent, first | {"triggers-0-DELETE": "on"})
    page = ken.post(intent, second | {"note": "mine"})
    assert page.status_code == 409
    assert text in {one.mine for one in page.context["differences"]}
    assert ken.post(intent, again(page)).status_code == 302
    assert Intent.objects.earliest("pk").triggers.filter(text=text).count() == 1


def test_a_part_that_the_other_added_stays_and_is_told(maria: Client, ken: Client) -> None:
    intent = Intent.objects.earliest("pk")
    second = form_of(ken, address(intent))
    intent.triggers.create(language="en", text="wholly new", position=99)
    page = ken.post(address(intent), second | {"note": "mine"})
    assert "wholly new" in page.content.decode()
    assert ken.post(address(intent), again(page)).status_code == 302
    assert intent.triggers.filter(text="wholly new").exists()


def test_a_row_deleted_meanwhile_gives_the_text_back(maria: Client, ken: Client) -> None:
    row = models.Frame.objects.get(key="GreenTea.c1")
    second = form_of(ken, address(row))
    maria.post(address(row, "delete"), {"post": "yes"})
    page = ken.post(address(row), second | {"sentences-0-text": "a text that took an hour"})
    assert page.status_code == 409
    assert "a text that took an hour" in page.content.decode()


def test_a_refused_form_keeps_what_it_showed_at_first(maria: Client, ken: Client) -> None:
    second = form_of(ken, drink())
    refused = ken.post(drink(), second | {"stop": "xyz"})
    models.Topic.objects.filter(key="Drink").update(note="changed in between")
    form = refused.context["adminform"].form
    data = second | {SEEN: str(form[SEEN].value()), "note": "mine"}
    assert ken.post(drink(), data).status_code == 409


def test_another_topic_is_no_conflict(maria: Client, ken: Client) -> None:
    second = form_of(ken, drink())
    maria.post(address(milk()), form_of(maria, address(milk())) | {"note": "x"})
    assert ken.post(drink(), second | {"note": "mine"}).status_code == 302


def test_a_researcher_learns_nothing_by_posting() -> None:
    answer = logged_in(RESEARCHER).post(drink(), {SEEN: "x"})
    assert answer.status_code == 403


@pytest.mark.parametrize(
    "nonsense",
    [
        {SEEN: "\0"},
        {SEEN: "x" * 99},
        {SEEN: "x", "names-TOTAL_FORMS": "9" * 30},
        {SEEN: "x", "names-INITIAL_FORMS": "-1"},
        {SEEN: "x", "parent": "no"},
        {SEEN: ""},
    ],
)
def test_nonsense_is_no_fault_and_saves_nothing(nonsense: Form, ken: Client) -> None:
    answer = ken.post(drink(), {"note": "nonsense"} | nonsense)
    assert answer.status_code in (200, 400, 409)
    assert not models.Topic.objects.filter(note="nonsense").exists()


def test_rows_that_are_gone_become_new_ones() -> None:
    from django.http import QueryDict

    data = QueryDict(
        "a-TOTAL_FORMS=3&a-INITIAL_FORMS=2&a-0-id=5&a-0-t=x&a-1-id=6&a-1-t=y&a-2-id=&a-2-t=z"
    )
    moved = rebased(data, "a", {"6"})
    assert moved["a-INITIAL_FORMS"] == "1"
    assert [(moved[f"a-{i}-id"], moved[f"a-{i}-t"]) for i in range(3)] == [
        ("6", "y"),
        ("", "x"),
        ("", "z"),
    ]
