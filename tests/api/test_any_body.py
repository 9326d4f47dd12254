"""Whatever JSON arrives, the answer is 200 or an error of the table."""

import json
from typing import Any

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from cair_site.errors import ERRORS
from dialogue.engine.content import Content
from tests.api.conftest import CLIENT

LEAVES = st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=40)
ANYTHING = st.recursive(
    LEAVES,
    lambda below: st.lists(below, max_size=4) | st.dictionaries(st.text(max_size=8), below),
    max_leaves=12,
)
FIELDS = {
    "client_sentence": ANYTHING | st.text(),
    "dialogue_state": ANYTHING | st.text(alphabet="ABCabc012-_", max_size=80),
    "language": ANYTHING | st.sampled_from(["en", "it", "ja", "it-IT", ""]),
    "culture": ANYTHING | st.sampled_from(["EN", "it", "JP", ""]),
    "seed": ANYTHING | st.integers(),
    "capabilities": ANYTHING | st.lists(st.text(max_size=9)),
    "kbplan_actions": ANYTHING
    | st.lists(
        st.fixed_dictionaries(
            {"action": st.sampled_from(["jump", "setlikeliness", "leave", "repeat", "more", "x"])},
            optional={
                "parameters": st.dictionaries(
                    st.sampled_from(["topic", "value", "startsentence"]),
                    st.none() | st.text() | st.sampled_from(["Music", "1.0", "nan", "p"]),
                )
            },
        ),
        max_size=4,
    ),
    "intent": ANYTHING | st.text(),
}
QUICK = settings(
    max_examples=300,
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow],
)


def check(path: str, body: bytes, method: str = "POST") -> Any:
    answer = CLIENT.generic(method, path, body, content_type="application/json")
    if answer.status_code != 200:
        code = answer.json()["error"]["code"]
        assert ERRORS[code].status == answer.status_code < 500
    return answer


@QUICK
@given(message=ANYTHING | st.fixed_dictionaries({}, optional=FIELDS))
def test_any_json_to_the_hub_is_answered(published: Content, message: object) -> None:
    check("/api/v1/hub/", json.dumps(message).encode())


@QUICK
@given(message=st.fixed_dictionaries({}, optional=FIELDS))
def test_any_json_to_the_dialogue_manager_is_answered(published: Content, message: object) -> None:
    check("/api/v1/dialogue/", json.dumps(message).encode())


@QUICK
@given(body=st.binary(max_size=200))
def test_any_bytes_to_the_hub_are_answered(published: Content, body: bytes) -> None:
    check("/api/v1/hub/", body)


OLD_FIELDS = FIELDS | {
    "sentence": ANYTHING,
    "dialogue_statistics": ANYTHING,
    "due_intervention": ANYTHING,
    "dialogue_state": ANYTHING
    | st.fixed_dictionaries({"state": ANYTHING, "conversation_history": ANYTHING}),
}


@QUICK
@given(message=st.fixed_dictionaries({}, optional=OLD_FIELDS))
def test_any_json_of_an_old_client_is_answered_with_200(
    published: Content, message: object
) -> None:
    body = json.dumps(message, allow_nan=True).encode()
    answer = check("/CAIR_hub", body, "PUT")
    if answer.status_code == 200:
        assert answer.json()["dialogue_state"] is not None
