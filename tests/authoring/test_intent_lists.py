"""Value lists, phrases, the list of intents, and the widgets of their pages."""

from html.parser import HTMLParser
from typing import Any

import pytest
from django.forms import CheckboxInput, HiddenInput
from django.http import QueryDict
from django.test import Client
from django.urls import reverse

from authoring.intent_page.draft_library import draft_library
from authoring.intent_page.list_widgets import Wordings, WordsByValue, outer_choices
from authoring.intent_page.posted import posted_intent
from authoring.intent_page.quick_widgets import QuickBox, QuickHidden
from authoring.intent_page.trying import marked
from authoring.intent_page.widgets import Expected, LanguageTexts, Parameters, decoded
from dialogue.models import Topic
from plans import models
from plans.engine.explain import Parameter
from tests.admin.pages import errors
from tests.authoring.intent_forms import ADD, FAILING, LIST, answer, plants, song

pytestmark = pytest.mark.usefixtures("small_draft", "nothing_kept")


def test_the_list_is_searched_by_sentence_and_told_what_fails(admin_client: Client) -> None:
    admin_client.post(reverse(ADD), plants() | {"tests-0-sentence": "Feed the cat"})
    page = admin_client.get(reverse(LIST), {"q": "innaffia"})
    assert [row.key for row in page.context["cl"].result_list] == ["water_the_plants"]
    page = admin_client.get(reverse(LIST), {"family": "household"})
    assert [row.key for row in page.context["cl"].result_list] == ["water_the_plants"]
    number = str(models.Intent.objects.get(key="water_the_plants").pk)
    assert admin_client.get(reverse(FAILING)).json()["failing"][number] == 1


def test_a_broken_row_of_the_draft_leaves_the_rest_to_be_tried(admin_client: Client) -> None:
    intent = models.Intent.objects.create(key="broken", position=9)
    models.Trigger.objects.create(intent=intent, language="en", text="play (this")
    models.Trigger.objects.create(intent=intent, language="en", text="break it")
    assert answer(admin_client, "Play Volare")["tried"]["winner"]["intent"] == "playsong"
    found = answer(admin_client, "Break it")
    assert found["tried"]["winner"]["intent"] == "broken"
    assert "Left out, because it cannot be read" in found["html"]


def test_a_value_list_is_written_one_word_a_line(admin_client: Client) -> None:
    row = models.ValueList.objects.get(key="volume_level")
    address = reverse("admin:plans_valuelist_change", args=[row.pk])
    data = {"key": "volume_level", "position": "0", "values_0_value": "louder"}
    data |= {"values_0_en": "louder\n up \n", "values_0_it": "più forte", "values_0_ja": ""}
    data |= {"values_1_value": "", "values_1_en": "", "values_1_it": "", "values_1_ja": ""}
    assert admin_client.post(address, data).status_code == 302
    row.refresh_from_db()
    assert row.values == {"en": {"louder": ["louder", "up"]}, "it": {"louder": ["più forte"]}}


def test_a_phrase_tells_where_it_is_used_and_what_is_wrong(admin_client: Client) -> None:
    models.Trigger.objects.filter(language="en").update(text="<really> play {title}")
    row = models.Phrase.objects.get(key="really")
    address = reverse("admin:plans_phrase_change", args=[row.pk])
    assert song() in admin_client.get(address).content.decode()
    data = {"key": "really", "position": "0", "texts_en": "really\n(so|very) much", "texts_it": ""}
    assert admin_client.post(address, data).status_code == 302
    row.refresh_from_db()
    assert row.texts == {"en": "really|(so|very) much"}
    response = admin_client.post(address, data | {"texts_en": "really\n(so"})
    assert "English: Open '(' without ')'" in errors(response)


def test_widgets_give_back_what_they_show() -> None:
    texts = LanguageTexts({}).value_from_datadict({"q_en": " Which? ", "q_it": ""}, None, "q")
    pairs = Parameters().value_from_datadict({"p.title": "{title}", "p.x": ""}, None, "p")
    must = {"t_must": "match", "t_line": "title = My Way | level = up"}
    wanted = Expected().value_from_datadict(must, None, "t")
    refused = Expected().value_from_datadict({"t_must": "not", "t_line": "a = b"}, None, "t")
    assert decoded(texts) == {"en": "Which?"}
    assert decoded(pairs) == [["title", "{title}"]]
    assert decoded(wanted) == {"title": "My Way", "level": "up"}
    assert refused is None
    rows = {"v_0_value": "up", "v_0_en": "louder|up", "v_0_it": "", "v_0_ja": "大きく"}
    found = decoded(WordsByValue().value_from_datadict(rows, None, "v"))
    assert found == {"en": {"up": ["louder", "up"]}, "ja": {"up": ["大きく"]}}
    assert outer_choices("a|(b|c) d|[e|f]") == ["a", "(b|c) d", "[e|f]"]
    assert Wordings().kept("a\n\n (b|c) d ") == "a|(b|c) d"


def test_a_form_is_read_without_its_deleted_and_empty_rows() -> None:
    data = QueryDict(mutable=True)
    data.update(plants() | {"triggers-0-DELETE": "on"})
    posted = posted_intent(data, 0)
    assert posted.intent.triggers["en"] == ("give the plants some water",)
    assert next(line.name for line in posted.triggers) == "triggers-2-text"


def test_captured_words_are_marked_where_they_stand() -> None:
    captured = [Parameter("b", "two", "two"), Parameter("a", "one", "one"), Parameter("c", "", "")]
    pieces = [(piece.text, piece.name) for piece in marked("say one and two", captured)]
    assert pieces == [("say ", ""), ("one", "a"), (" and ", ""), ("two", "b")]


def test_a_change_of_a_topic_does_not_compile_the_intents_anew() -> None:
    before = draft_library()
    Topic.objects.get(key="Milk").save()
    assert draft_library() is before
    models.Intent.objects.get(key="playsong").triggers.create(language="en", text="sing for me")
    assert draft_library() is not before


@pytest.mark.parametrize("quick", [(QuickHidden, HiddenInput), (QuickBox, CheckboxInput)])
@pytest.mark.parametrize("value", [None, "", 'a "<b>"', 7, True, False])
def test_quick_inputs_say_what_the_usual_ones_say(quick: Any, value: object) -> None:
    made, usual = (
        widget({"data-x": "<1>"}).render("a<b", value, {"id": "c", "disabled": True, "x": False})
        for widget in quick
    )
    parsed = [html5(each) for each in (made, usual)]
    assert parsed[0] == parsed[1]


def html5(html: str) -> dict[str, str | None]:
    found: dict[str, str | None] = {}
    reader = HTMLParser()
    reader.handle_starttag = lambda _tag, attrs: found.update(attrs)  # type: ignore[method-assign]
    reader.feed(html)
    return found
