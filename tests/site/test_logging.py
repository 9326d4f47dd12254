"""The log: JSON or plain, the id of the request, slow turns; never what somebody said."""

import io
import json
import logging
import re
from collections.abc import Iterator
from typing import Any

import pytest
from django.http import HttpRequest
from django.test import Client
from gunicorn.config import Config
from pytest_django.fixtures import Settings

from authoring.rates import Rates
from cair_site import observing
from cair_site.log_lines import FORMATTERS, Json, WithoutWords
from cair_site.request_ids import request_id
from cair_site.server_log import ServerLog

SECRET = "Margaret is ill"
FORMS = pytest.mark.parametrize("form", list(FORMATTERS))


class Lines:
    """A logger with a form of its own, and what it wrote."""

    def __init__(self, form: str) -> None:
        self.stream = io.StringIO()
        handler = logging.StreamHandler(self.stream)
        handler.setFormatter(FORMATTERS[form]())
        handler.addFilter(WithoutWords())
        self.logger = logging.Logger("tried")
        self.logger.addHandler(handler)

    @property
    def text(self) -> str:
        return self.stream.getvalue()


@pytest.fixture
def json_lines() -> Iterator[list[dict[str, Any]]]:
    """Return the lines that our own loggers write, as they are written."""
    lines: list[dict[str, Any]] = []

    class Keep(logging.Handler):
        def emit(self, record: logging.LogRecord) -> None:
            lines.append(json.loads(Json().format(record)))

    handler, logger = Keep(), logging.getLogger("cair")
    level = logger.level
    logger.addHandler(handler)
    logger.setLevel(logging.INFO)
    yield lines
    logger.removeHandler(handler)
    logger.setLevel(level)


def post(**headers: str) -> Any:
    body = json.dumps({"client_sentence": SECRET})
    return Client().post("/api/v1/hub/?a=b", body, "application/json", headers=headers)


def fail_twice() -> None:
    try:
        {}[SECRET]
    except KeyError as error:
        raise ValueError(f"wrong: {SECRET}") from error


@FORMS
def test_an_exception_is_told_without_its_words(form: str) -> None:
    lines = Lines(form)
    try:
        fail_twice()
    except ValueError:
        lines.logger.exception("It broke")
    assert "ValueError" in lines.text
    assert "KeyError" in lines.text
    assert "test_logging.py" in lines.text
    assert SECRET not in lines.text


@FORMS
def test_the_address_of_a_failed_request_is_not_told(form: str) -> None:
    lines = Lines(form)
    request = HttpRequest()
    more = {"request": request, "status_code": 500}
    lines.logger.error("%s: %s", "Server Error", f"/topics/{SECRET}", extra=more)
    assert "500" in lines.text
    assert SECRET not in lines.text


def test_a_json_line_is_one_line_with_its_parts() -> None:
    lines = Lines("JSON")
    token = request_id.set("0123456789ab")
    lines.logger.warning("one\ntwo %s", "è", extra={"fields": {"ms": 1.5}})
    request_id.reset(token)
    (line,) = lines.text.splitlines()
    told = json.loads(line)
    assert re.fullmatch(r"20\d\d-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}\+00:00", told.pop("time"))
    assert told == {
        "level": "WARNING",
        "logger": "tried",
        "message": "one\ntwo è",
        "request_id": "0123456789ab",
        "ms": 1.5,
    }


def test_a_plain_line_has_fields_and_the_id_too() -> None:
    lines = Lines("PLAIN")
    token = request_id.set("0123456789ab")
    lines.logger.warning("Slow", extra={"fields": {"ms": 1.5}})
    request_id.reset(token)
    assert lines.text.endswith("WARNING tried: Slow ms=1.5 request_id=0123456789ab\n")


@pytest.mark.usefixtures("published")
@pytest.mark.parametrize("given", ["abcdef12", "A" * 64, "1f-2.3_4abcd"])
def test_a_sane_id_is_kept(given: str) -> None:
    assert post(**{"X-Request-ID": given}).headers["X-Request-ID"] == given


@pytest.mark.usefixtures("published")
@pytest.mark.parametrize("given", ["", "short", "A" * 65, "a b c d e f", "é" * 10, "x" * 9 + "\n"])
def test_any_other_id_is_replaced(given: str) -> None:
    found = post(**{"X-Request-ID": given}).headers["X-Request-ID"]
    assert re.fullmatch("[0-9a-f]{24}", found)


@pytest.mark.usefixtures("published")
def test_each_answer_has_an_id_of_its_own() -> None:
    paths = ["/livez", "/readyz", "/", "/api/v1/hub/", "/nothing", "/CAIR_hub", "/metrics"]
    ids = {Client().get(path).headers["X-Request-ID"] for path in paths}
    assert len(ids) == len(paths)


@pytest.mark.usefixtures("published")
def test_a_turn_tells_its_release() -> None:
    assert post().headers["X-CAIR-Release"] == "1"


@pytest.mark.usefixtures("published")
def test_nothing_is_logged_of_a_turn_by_default(json_lines: list[dict[str, Any]]) -> None:
    post()
    assert json_lines == []


@pytest.mark.usefixtures("published")
def test_the_access_log_tells_the_route_without_its_values(
    settings: Settings, json_lines: list[dict[str, Any]]
) -> None:
    settings.CAIR_ACCESS_LOG = True
    post(**{"X-Request-ID": "of-this-turn"})
    Client().get(f"/api/v1/topics/{SECRET}/?name={SECRET}")
    Client().get(f"/{SECRET}")
    Client().generic(SECRET.upper().replace(" ", ""), "/livez")
    turn, topic, nothing, odd = json_lines
    assert turn["request_id"] == "of-this-turn"
    assert (turn["method"], turn["status"]) == ("POST", 200)
    assert turn["route"].startswith("api/v1/hub")
    assert topic["status"] == 404
    assert (nothing["route"], odd["method"]) == ("?", "?")
    assert "margaret" not in json.dumps(json_lines).lower()


@pytest.mark.usefixtures("published")
def test_a_slow_turn_tells_its_parts_and_sizes(
    settings: Settings, json_lines: list[dict[str, Any]], monkeypatch: pytest.MonkeyPatch
) -> None:
    settings.CAIR_SLOW_MS = 1
    clock = iter(range(0, 1000, 2))
    monkeypatch.setattr(observing.time, "perf_counter", lambda: float(next(clock)))
    answer = post()
    (line,) = json_lines
    assert line["logger"] == "cair.slow"
    assert line["ms"] >= 2000
    assert {"decode_ms", "match_ms", "dialogue_ms", "encode_ms", "total_ms"} <= line.keys()
    assert (line["service"], line["language"], line["release"]) == ("hub", "en", 1)
    assert line["bytes_out"] == len(answer.content)
    assert line["state_characters"] == len(answer.json()["dialogue_state"])
    assert line["request_id"] == answer.headers["X-Request-ID"]
    assert SECRET not in json.dumps(line)


@pytest.mark.usefixtures("published")
def test_slow_turns_do_not_fill_the_log(
    settings: Settings, json_lines: list[dict[str, Any]], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(observing, "_slow_rate", Rates(clock=lambda: 0.0))
    clock = iter(range(0, 100_000, 2))
    monkeypatch.setattr(observing.time, "perf_counter", lambda: float(next(clock)))
    settings.CAIR_SLOW_MS, settings.CAIR_SLOW_A_MINUTE = 1, 3
    for _ in range(8):
        post()
    assert len(json_lines) == 3


@FORMS
def test_the_server_does_not_quote_what_is_no_http(
    form: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("CAIR_LOG_FORMAT", form.lower())
    log = ServerLog(Config())
    try:
        log.warning(f"Invalid request from ip=127.0.0.1: Invalid HTTP request line: {SECRET!r}")
        try:
            fail_twice()
        except ValueError as error:
            log.exception("Error handling request %s %s", "GET", f"/{SECRET}")
            log.exception(error)  # noqa: TRY401 - as gunicorn does
        log.warning("Worker (pid:%s) was sent %s!", 7, "SIGKILL")
    finally:
        for handler in list(log.error_log.handlers):
            log.error_log.removeHandler(handler)
    text = capsys.readouterr().err
    assert SECRET not in text
    assert "no HTTP was refused" in text
    assert text.count("in fail_twice") >= 2
    assert "Worker (pid:7) was sent SIGKILL!" in text
