"""/metrics: what is counted, by which closed lists of labels, and who may read it."""

import json
from collections.abc import Callable
from typing import Any

import pytest
from django.test import Client
from prometheus_client.parser import text_string_to_metric_families
from pytest_django.fixtures import Settings

from cair_site import metrics
from cair_site.turn_facts import language_of
from dialogue.engine.content import Content
from dialogue.turns import first_turn, write_state
from languages.known import LANGUAGES

pytestmark = pytest.mark.usefixtures("published")
TOKEN = "a-token-of-operators-0123456789"
Numbers = dict[tuple[str, frozenset[tuple[str, str]]], float]


def numbers() -> Numbers:
    text = metrics.text().decode()
    return {
        (one.name, frozenset(one.labels.items())): one.value
        for family in text_string_to_metric_families(text)
        for one in family.samples
    }


def added(call: Callable[[], Any]) -> Numbers:
    """Return what a call adds to the counts."""
    before = numbers()
    call()
    after = numbers()
    return {
        key: value - before.get(key, 0)
        for key, value in after.items()
        if value != before.get(key, 0) and key[0] != "cair_uptime_seconds"
    }


def named(found: Numbers, name: str) -> dict[str, float]:
    """Return the values of a metric by their labels, written "a=b,c=d"."""
    return {
        ",".join(sorted(f"{key}={value}" for key, value in labels)): value
        for (metric, labels), value in found.items()
        if metric == name
    }


def post(path: str, **message: object) -> Any:
    client = Client(raise_request_exception=False)
    return client.post(path, json.dumps(message), content_type="application/json")


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("service", ["hub", "dialogue", "plan"])
def test_a_turn_is_counted_by_service_and_language(service: str, language: str) -> None:
    found = added(lambda: post(f"/api/v1/{service}/", client_sentence="Hm", language=language))
    assert named(found, "cair_turns_total") == {f"language={language},plan=no,service={service}": 1}
    assert named(found, "cair_turn_seconds_count") == {f"service={service}": 1}


@pytest.mark.parametrize("path", ["/api/v1/hub/", "/api/v1/plan/", "/CAIR_hub"])
def test_a_turn_with_a_plan_is_told_apart(path: str) -> None:
    found = added(lambda: post(path, client_sentence="play the song Hey Brother"))
    (labels,) = named(found, "cair_turns_total")
    assert "plan=yes" in labels


def test_a_turn_of_an_existing_client_is_counted() -> None:
    found = added(lambda: post("/CAIR_hub", client_sentence="Hm", language="it-IT"))
    assert named(found, "cair_turns_total") == {"language=it,plan=no,service=compat": 1}


def test_the_size_of_the_state_is_counted() -> None:
    answers: list[Any] = []
    found = added(lambda: answers.append(post("/api/v1/hub/", client_sentence="I love tea")))
    size = len(answers[0].json()["dialogue_state"])
    assert named(found, "cair_state_characters_sum") == {"": size}


@pytest.mark.parametrize("path", ["/api/v1/hub/", "/api/v1/topics/", "/api/v1/hub/options/"])
def test_what_is_no_turn_is_not_counted_as_one(path: str) -> None:
    assert named(added(lambda: Client().get(path)), "cair_turns_total") == {}


@pytest.mark.parametrize(
    ("call", "code"),
    [
        (lambda: post("/api/v1/hub/", client_sentence=7), "body.invalid"),
        (lambda: post("/api/v1/hub/", dialogue_state="x" * 100), "state.damaged"),
        (lambda: post("/api/v1/hub/", language="xx"), "language.unknown"),
        (lambda: Client().get("/nothing/"), "not_found"),
        (lambda: Client().put("/api/v1/hub/"), "method.not_allowed"),
        (lambda: Client().get("/api/v1/hub/", headers={"Host": "else.example"}), "host.unknown"),
        (lambda: post("/CAIR_hub", client_sentence="a", dialogue_state="x"), "state.unreadable"),
    ],
)
def test_an_error_is_counted_by_its_code(call: Callable[[], Any], code: str) -> None:
    assert named(added(call), "cair_errors_total") == {f"code={code}": 1}


def test_labels_never_come_from_outside() -> None:
    def nonsense() -> None:
        for word in ("Margaret", "xx", 'a"b', "en\nplan"):
            post("/api/v1/plan/", client_sentence="hello", language=word)
            post("/CAIR_hub", client_sentence="hello", language=word)
        metrics.count_error("Margaret")
        metrics.count_turn("hub", "Margaret", 0.1, plan=True, state=7)

    nonsense()
    labels = {pair for _name, pairs in numbers() for pair in pairs if pair[0] != "le"}
    languages = {value for key, value in labels if key == "language"}
    assert languages <= {*LANGUAGES, "other"}
    assert "Margaret" not in str(labels)


def test_a_state_tells_its_language(published: Content) -> None:
    for language in LANGUAGES:
        for seed in (0, 1, 2**32 - 1):
            state = write_state(first_turn(published, language, "", seed).state)
            assert language_of(state) == language
    assert language_of("") == language_of("x" * 100) == ""


def test_the_release_and_the_uptime_are_told(published: Content) -> None:
    found = numbers()
    assert found[("cair_release", frozenset())] == published.number
    assert found[("cair_uptime_seconds", frozenset())] >= 0


def read(address: str = "127.0.0.1", **headers: str) -> int:
    return Client().get("/metrics", REMOTE_ADDR=address, headers=headers).status_code


@pytest.mark.parametrize("address", ["127.0.0.1", "::1", "::ffff:127.0.0.1"])
def test_this_machine_may_read(address: str) -> None:
    assert read(address) == 200


@pytest.mark.parametrize("address", ["10.0.0.1", "203.0.113.9", "", "unix", "2001:db8::1"])
def test_others_may_not_read(address: str) -> None:
    assert read(address) == 404


@pytest.mark.parametrize(
    "header", ["X-Forwarded-For", "Forwarded", "Via", "X-Real-IP", "X-Forwarded-Proto"]
)
def test_what_a_proxy_of_this_machine_brings_is_not_of_this_machine(header: str) -> None:
    assert read(**{header: "127.0.0.1"}) == 404


def test_with_a_token_only_the_token_counts(settings: Settings) -> None:
    settings.CAIR_METRICS_TOKEN = TOKEN
    assert read("203.0.113.9", Authorization=f"Bearer {TOKEN}") == 200
    for wrong in ("", "Bearer", f"Bearer {TOKEN}x", TOKEN, f"Basic {TOKEN}", "Bearer é"):
        assert read(Authorization=wrong) == 404


@pytest.mark.parametrize("path", ["/livez", "/readyz"])
def test_a_probe_needs_neither_name_nor_https_nor_database(path: str, settings: Settings) -> None:
    settings.SECURE_SSL_REDIRECT = True
    settings.CAIR_KEYS_REQUIRED = True
    assert Client().get(path, headers={"Host": "10.1.2.3:8000"}).status_code == 200
