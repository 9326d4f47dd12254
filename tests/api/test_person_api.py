"""The person-specific layer over REST: what a state has learned, as individuals."""

from xml.etree import ElementTree

import pytest
import yaml
from django.test import Client

from dialogue.engine.content import Content
from dialogue.engine.state import DialogueState
from dialogue.turns import read_state, write_state
from tests.api.conftest import Api

RDF = "{http://www.w3.org/1999/02/22-rdf-syntax-ns#}"
CAIR = "{urn:cair:vocab#}"
OWL = "{http://www.w3.org/2002/07/owl#}"
RDFS = "{http://www.w3.org/2000/01/rdf-schema#}"


def liking(api: Api, sentence: str = "I love coffee") -> str:
    """Return the state of an English person who has said something."""
    state = api.start(language="en", culture="EN", seed="7")
    answer = api.post("hub/", client_sentence=sentence, dialogue_state=state)
    return str(answer["dialogue_state"])


def test_what_was_learned_becomes_individuals(api: Api) -> None:
    answer = api.post("dialogue/person/", dialogue_state=liking(api), name="Dorothy Smith")
    assert {
        "name": "DS_COFFEE",
        "topic": "Coffee",
        "likeliness": 1.0,
        "specific_of": "EN_COFFEE",
    } in answer["individuals"]


def test_it_holds_exactly_what_inspect_tells(api: Api) -> None:
    state = liking(api)
    told = api.post("dialogue/inspect/", dialogue_state=state)["likeliness"]
    rows = api.post("dialogue/person/", dialogue_state=state)["individuals"]
    assert {row["topic"]: row["likeliness"] for row in rows} == told != {}


def test_the_ontology_says_the_same_as_the_rows(api: Api) -> None:
    answer = api.post("dialogue/person/", dialogue_state=liking(api), name="DS")
    root = ElementTree.fromstring(answer["owl"])  # noqa: S314 - ours
    found = {
        (
            one.attrib[f"{RDF}about"].rpartition("#")[2],
            float(one.findtext(f"{CAIR}hasLikeliness", "")),
        )
        for one in root.iter(f"{OWL}NamedIndividual")
        if one.find(f"{CAIR}concernsUser") is not None
    }
    assert found == {(row["name"], row["likeliness"]) for row in answer["individuals"]} != set()


def test_a_state_that_has_learned_nothing_gives_no_individuals(api: Api) -> None:
    answer = api.post("dialogue/person/", dialogue_state=api.start())
    assert answer["individuals"] == []
    root = ElementTree.fromstring(answer["owl"])  # noqa: S314 - ours
    assert [one.attrib for one in root.iter(f"{OWL}NamedIndividual")] == [
        {f"{RDF}about": "urn:cair:kb#USER_PS"}
    ]


def test_individuals_specialise_those_of_the_persons_culture(api: Api) -> None:
    state = read_state(liking(api))
    italian = DialogueState("it", "IT", levels=state.levels)
    answer = api.post("dialogue/person/", dialogue_state=write_state(italian))
    assert {row["specific_of"][:3] for row in answer["individuals"]} == {"IT_"}
    assert {row["name"][:3] for row in answer["individuals"]} == {"PS_"}


def test_a_culture_that_is_gone_leaves_nothing_to_specialise(api: Api) -> None:
    state = read_state(liking(api))
    gone = DialogueState("en", "XX", levels=state.levels)
    answer = api.post("dialogue/person/", dialogue_state=write_state(gone))
    assert {row["specific_of"] for row in answer["individuals"]} == {""}
    assert "CULTURE_XX" not in answer["owl"]
    assert "<cair:hasSpecific" not in answer["owl"]


def test_topics_that_are_gone_are_left_out(api: Api) -> None:
    state = DialogueState("en", "EN").with_likeliness(99_999, 1.0)
    answer = api.post("dialogue/person/", dialogue_state=write_state(state))
    assert answer["individuals"] == []


def test_json_leaves_the_ontology_out(api: Api) -> None:
    state = liking(api)
    full = api.post("dialogue/person/", dialogue_state=state)
    rows = api.post("dialogue/person/", dialogue_state=state, format="json")
    assert rows == full | {"owl": ""}
    assert full["owl"]


def test_the_name_is_in_the_answer_only(api: Api, caplog: pytest.LogCaptureFixture) -> None:
    name = "Zebedee Quux"
    answer = api.post("dialogue/person/", dialogue_state=liking(api), name=name)
    assert f"<rdfs:label>{name}</rdfs:label>" in answer["owl"]
    assert "Zebedee" not in caplog.text


@pytest.mark.parametrize(
    "name", ['</rdfs:label><x>"&', "]]>", "\u202e", "山田花子", "e\u0301 \U0001f475", "\r\n\t"]
)
def test_any_name_makes_a_whole_file(api: Api, name: str) -> None:
    answer = api.post("dialogue/person/", dialogue_state=liking(api), name=name)
    root = ElementTree.fromstring(answer["owl"])  # noqa: S314 - ours
    label = root.find(f"{OWL}NamedIndividual/{RDFS}label")
    assert ("" if label is None else label.text) == name.strip()


@pytest.mark.parametrize("name", ["a\u0000b", "\u001b[31m", "\uffff", 7, None, ["x"], "x" * 101])
def test_a_name_that_is_none_is_refused(api: Api, name: object) -> None:
    state = api.start()
    assert api.refused("dialogue/person/", dialogue_state=state, name=name) == (400, "body.invalid")


def test_states_and_formats_that_are_none_are_refused(api: Api) -> None:
    assert api.refused("dialogue/person/") == (400, "body.invalid")
    assert api.refused("dialogue/person/", dialogue_state="") == (400, "state.unreadable")
    assert api.refused("dialogue/person/", dialogue_state="A" * 60) == (400, "state.damaged")
    wrong = api.refused("dialogue/person/", dialogue_state=api.start(), format="turtle")
    assert wrong == (400, "body.invalid")


def test_it_is_asked_with_post_only(api: Api) -> None:
    answer = api.client.get("/api/v1/dialogue/person/")
    assert (answer.status_code, answer.json()["error"]["code"]) == (405, "method.not_allowed")


def test_the_schema_names_the_call_and_its_fields(api: Api) -> None:
    schema = yaml.safe_load(api.client.get("/api/schema/").content)
    assert set(schema["paths"]["/api/v1/dialogue/person/"]) == {"post"}
    fields = schema["components"]["schemas"]["PersonRequest"]["properties"]
    assert set(fields) == {"dialogue_state", "name", "format"}


@pytest.mark.django_db
def test_nothing_is_stored(published: Content, api: Api, django_assert_num_queries: object) -> None:
    state = liking(api)
    with django_assert_num_queries(0):  # type: ignore[operator]
        assert Client().post(
            "/api/v1/dialogue/person/",
            {"dialogue_state": state, "name": "DS"},
            content_type="application/json",
        )
