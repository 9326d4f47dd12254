"""Two experts change the same sentence on the topic's page: nothing is lost silently."""

from collections.abc import Callable

import pytest
from django.http import HttpResponse
from django.test import Client
from django.urls import reverse

from authoring.roles import AUTHOR
from dialogue import models
from tests.admin.pages import form_of, send
from tests.authoring.people import logged_in

pytestmark = pytest.mark.usefixtures("small_draft")

Data = dict[str, str]


@pytest.fixture
def maria() -> Client:
    return logged_in(AUTHOR, "Maria")


@pytest.fixture
def ken() -> Client:
    return logged_in(AUTHOR, "Ken")


def frame() -> models.Frame:
    return models.Frame.objects.get(key="Drink.q1")


def small() -> str:
    return reverse("admin:topic_sentence", args=[frame().topic_id, frame().pk])


def said(language: str = "en") -> str:
    return models.Sentence.objects.get(frame__key="Drink.q1", language=language).text


def held(page: HttpResponse) -> Data:
    """Return what the form of a page would send as it is."""
    form = page.context["form"]
    return {form.add_prefix(name): str(form[name].value() or "") for name in form.fields}


def shown(client: Client) -> Data:
    return held(client.get(small()))


def with_words(data: Data, **texts: str) -> Data:
    return data | {f"s{frame().pk}-{language}": text for language, text in texts.items()}


def test_the_second_sees_both_texts_and_who_was_first(maria: Client, ken: Client) -> None:
    first, second = shown(maria), shown(ken)
    assert maria.post(small(), with_words(first, en="By Maria?")).status_code == 302
    answer = ken.post(small(), with_words(second, en="By Ken?"))
    page = answer.content.decode()
    assert answer.status_code == 409
    assert "It says now: By Maria?" in page
    assert ">\nBy Ken?</textarea>" in page
    assert "Maria changed" in page
    assert said() == "By Maria?"


def test_the_script_gets_the_form_with_both_texts(maria: Client, ken: Client) -> None:
    second = shown(ken)
    maria.post(small(), with_words(shown(maria), en="By Maria?"))
    answer = ken.post(f"{small()}?part=1", with_words(second, en="By Ken?"))
    assert answer.status_code == 409
    assert answer.content.decode().lstrip().startswith('<form class="in-place"')


def test_the_second_saves_over_it_deliberately(maria: Client, ken: Client) -> None:
    second = shown(ken)
    maria.post(small(), with_words(shown(maria), en="By Maria?"))
    told = ken.post(small(), with_words(second, en="By Ken?"))
    assert ken.post(small(), held(told)).status_code == 302
    assert said() == "By Ken?"


def test_a_third_change_is_told_again(maria: Client, ken: Client) -> None:
    second = shown(ken)
    maria.post(small(), with_words(shown(maria), en="By Maria?"))
    told = ken.post(small(), with_words(second, en="By Ken?"))
    maria.post(small(), with_words(shown(maria), en="Once more?"))
    answer = ken.post(small(), held(told))
    assert answer.status_code == 409
    assert "Once more?" in answer.content.decode()


def test_words_that_somebody_added_in_a_language_are_kept(ken: Client) -> None:
    models.Sentence.objects.filter(frame=frame(), language="it").delete()
    second = shown(ken)
    models.Sentence.objects.create(frame=frame(), language="it", text="Di Maria?")
    told = ken.post(small(), with_words(second, en="By Ken?"))
    assert told.status_code == 409
    assert ken.post(small(), held(told)).status_code == 302
    assert (said("it"), said()) == ("Di Maria?", "By Ken?")


def test_words_that_somebody_took_away_are_not_put_back_unseen(ken: Client) -> None:
    second = shown(ken)
    models.Sentence.objects.filter(frame=frame(), language="it").delete()
    told = ken.post(small(), with_words(second, en="By Ken?"))
    assert told.status_code == 409
    assert "It has no words now." in str(told.context["form"].errors["it"])


def scope(row: models.Frame) -> None:
    row.scope = "below"
    row.save()


def cultures(row: models.Frame) -> None:
    row.only.set(models.Culture.objects.all()[:1])


@pytest.mark.parametrize("change", [scope, cultures])
def test_who_it_is_said_to_is_part_of_the_sentence(
    change: Callable[[models.Frame], None], ken: Client
) -> None:
    second = shown(ken)
    change(frame())
    told = ken.post(small(), with_words(second, en="By Ken?"))
    assert told.status_code == 409
    assert "Somebody else has changed this sentence" in told.content.decode()


def test_the_sentence_page_and_the_form_know_of_each_other(maria: Client, ken: Client) -> None:
    page = reverse("admin:dialogue_frame_change", args=[frame().pk])
    second, whole = shown(ken), form_of(ken, page)
    maria.post(small(), with_words(shown(maria), en="By Maria?"))
    assert ken.post(small(), with_words(second, en="By Ken?")).status_code == 409
    assert ken.post(page, whole | {"position": "77"}).status_code == 409
    assert send(maria, page, position="78").status_code == 302


@pytest.mark.parametrize("part", ["", "?part=1"])
def test_a_sentence_deleted_meanwhile_gives_the_words_back(part: str, ken: Client) -> None:
    second, address = shown(ken), small()
    frame().delete()
    answer = ken.post(address + part, with_words_of(second, "An hour of <work>"))
    assert answer.status_code == 409
    assert "An hour of &lt;work&gt;" in answer.content.decode()
    assert ken.post(address, {}).status_code == 404


def with_words_of(data: Data, text: str) -> Data:
    return {name: text if name.endswith("-en") else held for name, held in data.items()}


def test_another_sentence_is_no_conflict(ken: Client) -> None:
    second = shown(ken)
    models.Sentence.objects.filter(frame__key="GreenTea.c1").update(text="Another.")
    assert ken.post(small(), with_words(second, en="By Ken?")).status_code == 302


@pytest.mark.parametrize("seen", ["", "x", "\0", "y" * 5000])
def test_a_form_that_shows_nothing_saves_nothing(seen: str, ken: Client) -> None:
    data = with_words(shown(ken), en="By nobody?") | {f"s{frame().pk}-seen": seen}
    assert ken.post(small(), data).status_code == 409
    assert said() != "By nobody?"
