"""The settings of a served site, its headers, its keys, and who gets in without one."""

import json
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from django.conf import settings as site
from django.contrib.sessions.backends.db import SessionStore
from django.core.management import CommandError, call_command
from django.http import HttpRequest
from django.test import Client, RequestFactory
from pytest_django.fixtures import Settings

from authoring import addresses, keys
from authoring.keys import make_key
from authoring.rates import Rates, TooOftenError
from cair_site import api_keys, chat_pass, checks, environment
from dialogue.engine.content import Content
from dialogue.turns import first_turn, read_state, write_state

ROOT = Path(__file__).parents[2]
OLD, NEW = "old-" + "0123456789abcdef" * 3, "new-" + "fedcba9876543210" * 3
TURN = json.dumps({"client_sentence": "Hello"})


@pytest.fixture(autouse=True)
def _fresh(monkeypatch: pytest.MonkeyPatch) -> None:
    """Begin each test with no calls counted and no keys known."""
    keys.forget()
    monkeypatch.setattr(chat_pass, "_rates", Rates(clock=lambda: 0.0))
    monkeypatch.setattr(api_keys, "_addresses", Rates(clock=lambda: 0.0))


def manage(tmp_path: Path, *arguments: str, **more: str) -> subprocess.CompletedProcess[str]:
    kept = {name: value for name, value in os.environ.items() if not name.startswith("CAIR_")}
    return subprocess.run(
        [sys.executable, "manage.py", *arguments],
        cwd=ROOT,
        env=kept | {"CAIR_VAR": str(tmp_path)} | more,
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )


def test_the_settings_of_a_deployment_are_clean(tmp_path: Path) -> None:
    done = manage(tmp_path, "check", "--deploy", "--fail-level", "INFO", CAIR_HTTPS="yes")
    assert done.returncode == 0, done.stderr
    assert "no issues" in done.stdout


@pytest.mark.parametrize(
    ("name", "value", "told"),
    [
        ("CAIR_SECRET_KEY", "short", "cair.E004"),
        ("CAIR_SECRET_KEY", "a" * 60, "cair.E004"),
        ("CAIR_SECRET_KEYS", f"{NEW},django-insecure-{OLD}", "cair.E004"),
        ("CAIR_STATE_KEYS", f"{NEW},short", "cair.E002"),
        ("CAIR_METRICS_TOKEN", "secret", "cair.E005"),
        ("CAIR_TRUSTED_PROXIES", "proxy", "CAIR_TRUSTED_PROXIES"),
        ("CAIR_LOG_FORMAT", "xml", "CAIR_LOG_FORMAT"),
    ],
)
def test_a_weak_or_wrong_setting_is_named(tmp_path: Path, name: str, value: str, told: str) -> None:
    done = manage(tmp_path, "check", **{name: value})
    assert done.returncode != 0
    assert told in done.stderr


@pytest.mark.parametrize("address", ["0.0.0.0:8000", "[::]:80", "192.168.1.2:80", ":8000"])
def test_debug_pages_are_not_served_to_others(address: str, settings: Settings) -> None:
    settings.SECRET_KEY, settings.CAIR_STATE_KEYS = OLD, [NEW]
    assert checks.refuse_to_serve([address]) == ""
    settings.DEBUG = True
    assert "CAIR_DEBUG" in checks.refuse_to_serve(["127.0.0.1:8000", address])
    assert checks.refuse_to_serve(["127.0.0.1:8000", "unix:/run/cair"]) == ""


def test_a_site_with_a_weak_key_is_not_served(settings: Settings) -> None:
    settings.SECRET_KEY, settings.CAIR_STATE_KEYS = "changeme" * 8, [NEW]
    assert "CAIR_SECRET_KEY" in checks.refuse_to_serve(["127.0.0.1:8000"])


@pytest.mark.django_db
@pytest.mark.usefixtures("published")
@pytest.mark.parametrize("path", ["/", "/admin/login/", "/api/v1/hub/", "/nothing"])
def test_every_page_forbids_what_is_from_elsewhere(path: str) -> None:
    policy = Client().get(path).headers["Content-Security-Policy"]
    assert policy.startswith("default-src 'self'")
    assert "unsafe" not in policy
    assert "frame-ancestors 'none'" in policy


@pytest.mark.django_db
def test_behind_tls_cookies_are_secure_and_browsers_stay_there(settings: Settings) -> None:
    settings.SESSION_COOKIE_SECURE = settings.CSRF_COOKIE_SECURE = True
    settings.SECURE_SSL_REDIRECT, settings.SECURE_HSTS_SECONDS = True, 31_536_000
    answer = Client().get("/admin/login/", secure=True)
    assert "max-age=31536000" in answer.headers["Strict-Transport-Security"]
    cookie = answer.cookies["csrftoken"]
    assert (cookie["secure"], cookie["samesite"]) == (True, "Lax")
    assert Client().get("/admin/login/").status_code == 301


def test_a_session_outlives_a_new_secret(settings: Settings) -> None:
    settings.SECRET_KEY = OLD
    kept = SessionStore().encode({"person": 1})
    settings.SECRET_KEY, settings.SECRET_KEY_FALLBACKS = NEW, [OLD]
    assert SessionStore().decode(kept) == {"person": 1}
    settings.SECRET_KEY_FALLBACKS = []
    assert SessionStore().decode(kept) == {}


def test_a_talk_goes_on_through_all_steps_of_a_new_key(
    published: Content, settings: Settings, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    settings.CAIR_STATE_KEYS = [OLD]
    file = tmp_path / "keys"

    def step(*arguments: str) -> list[str]:
        call_command("new_state_key", *arguments, "--write", str(file))
        assert file.stat().st_mode & 0o077 == 0
        return file.read_text().split(",")

    with pytest.raises(CommandError):
        step("--sign")
    states = [write_state(first_turn(published, "en", "").state)]
    for arguments in ((), ("--sign",)):
        before = list(settings.CAIR_STATE_KEYS)
        after = step(*arguments)
        for ours in (before, after):  # a server that has the new value, and one that has not yet
            settings.CAIR_STATE_KEYS = ours
            states.append(write_state(read_state(states[0])))
        for ours in (before, after):
            settings.CAIR_STATE_KEYS = ours
            assert len([read_state(state) for state in states]) == len(states)
    assert settings.CAIR_STATE_KEYS[1:] == [OLD]
    settings.CAIR_STATE_KEYS = step("--drop")
    assert read_state(states[-1])
    with pytest.raises(Exception, match="state"):
        read_state(states[0])
    assert OLD not in capsys.readouterr().out


@pytest.mark.parametrize("name", ["CAIR_SECRET_KEYS", "CAIR_METRICS_TOKEN", "CAIR_SERVICE_KEY"])
def test_a_secret_may_come_from_a_file(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "secret").write_text(f" {OLD}\n")
    monkeypatch.setenv(f"{name}_FILE", str(tmp_path / "secret"))
    assert environment.text(name) == OLD


def call(peer: str, forwarded: str = "") -> HttpRequest:
    headers = {"X-Forwarded-For": forwarded} if forwarded else {}
    return RequestFactory(REMOTE_ADDR=peer, headers=headers).get("/")


@pytest.mark.parametrize(
    ("peer", "forwarded", "expected"),
    [
        ("203.0.113.9", "1.2.3.4", "203.0.113.9"),
        ("10.0.0.1", "", "10.0.0.1"),
        ("10.0.0.1", "1.2.3.4", "1.2.3.4"),
        ("10.0.0.1", "9.9.9.9, 1.2.3.4", "1.2.3.4"),
        ("10.0.0.1", "1.2.3.4, 10.0.0.7", "1.2.3.4"),
        ("10.0.0.1", "Margaret", "10.0.0.1"),
        ("10.0.0.1", "1.2.3.4, Margaret, 10.0.0.7", "10.0.0.7"),
        ("10.0.0.1", "2001:db8:1:2:3::4", "2001:db8:1:2::/64"),
        ("::ffff:10.0.0.1", "1.2.3.4", "1.2.3.4"),
        ("", "1.2.3.4", ""),
    ],
)
def test_only_a_trusted_proxy_is_believed(
    peer: str, forwarded: str, expected: str, settings: Settings, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CAIR_TRUSTED_PROXIES", "10.0.0.0/8, 127.0.0.1")
    settings.CAIR_TRUSTED_PROXIES = environment.networks("CAIR_TRUSTED_PROXIES")
    assert addresses.caller(call(peer, forwarded)) == expected


def test_no_proxy_is_trusted_by_default() -> None:
    assert addresses.caller(call("127.0.0.1", "1.2.3.4")) == "127.0.0.1"


def test_buckets_do_not_heap_up() -> None:
    rates = Rates(clock=lambda: 0.0)
    for number in range(60_000):
        rates.take(number, 1)
    assert len(rates.buckets) <= 50_000
    with pytest.raises(TooOftenError):
        rates.take(59_999, 1)


def turn(client: Client, peer: str = "203.0.113.9", **headers: str) -> Any:
    return client.post("/api/v1/hub/", TURN, "application/json", headers=headers, REMOTE_ADDR=peer)


@pytest.mark.usefixtures("published")
def test_an_address_that_calls_too_often_waits(settings: Settings) -> None:
    settings.CAIR_ADDRESS_RATE = 3
    seen = [turn(Client()) for _ in range(4)]
    assert [one.status_code for one in seen] == [200, 200, 200, 429]
    assert seen[3].json()["error"]["code"] == "address.too_often"
    assert seen[3].headers["Retry-After"] == "21"
    assert turn(Client(), "203.0.113.10").status_code == 200


@pytest.mark.django_db
@pytest.mark.usefixtures("published")
def test_a_key_frees_from_the_rate_of_the_address_but_no_invented_one(settings: Settings) -> None:
    settings.CAIR_ADDRESS_RATE = 1
    key = make_key("robot", None, None)[1]
    assert {turn(Client(), **{"X-Api-Key": key}).status_code for _ in range(5)} == {200}
    seen = [turn(Client(), **{"X-Api-Key": f"invented{n}"}).status_code for n in range(3)]
    assert seen == [200, 429, 429]


@pytest.fixture
def visitor(settings: Settings, published: Content) -> Client:
    """Return the browser of somebody who has opened the web chat of a site with keys."""
    settings.CAIR_KEYS_REQUIRED = True
    client = Client()
    assert client.get("/").status_code == 200
    return client


@pytest.mark.django_db
def test_the_web_chat_talks_where_keys_are_required(visitor: Client) -> None:
    assert turn(visitor).status_code == 200
    assert visitor.get("/api/v1/hub/?language=it").status_code == 200
    explained = visitor.post("/api/v1/dialogue/explain/", TURN, "application/json")
    assert explained.status_code == 200
    assert turn(Client()).status_code == 401


@pytest.mark.django_db
@pytest.mark.parametrize("path", ["/api/v1/topics/", "/api/v1/plan/", "/api/v1/ontology/"])
def test_the_pass_of_the_chat_is_good_for_the_chat_alone(visitor: Client, path: str) -> None:
    assert visitor.get(path).status_code == 401


def test_the_pass_is_in_no_page_and_no_script_can_read_it(visitor: Client) -> None:
    cookie = visitor.cookies["cair_chat"]
    assert (cookie["httponly"], cookie["samesite"], cookie["path"]) == (True, "Strict", "/api/v1/")
    assert cookie["max-age"] == 900
    page = visitor.get("/")
    assert cookie.value not in page.content.decode()
    assert page.headers["Cache-Control"] == "no-store"


@pytest.mark.django_db
def test_a_pass_ends_and_cannot_be_made_up(
    visitor: Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    value = visitor.cookies["cair_chat"].value
    for wrong in (value[:-1], value + "x", "a:b:c", "x" + value, re.sub(":.*:", ":1:", value)):
        client = Client()
        client.cookies["cair_chat"] = wrong
        assert turn(client).status_code == 401
    monkeypatch.setattr("django.core.signing.time.time", lambda: 1e10)
    assert turn(visitor).status_code == 401


@pytest.mark.django_db
def test_a_pass_is_rated_and_so_is_its_address(visitor: Client, settings: Settings) -> None:
    settings.CAIR_CHAT_RATE = 2
    assert [turn(visitor).status_code for _ in range(3)] == [200, 200, 429]
    passes = []
    for _ in range(30):
        client = Client()
        client.get("/")
        passes.append(turn(client).status_code)
    assert passes.count(200) == 20 - 3
    assert turn(client).status_code == 429
    assert turn(client, "198.51.100.7").status_code == 200


@pytest.mark.usefixtures("published")
@pytest.mark.parametrize(("required", "rate"), [(False, 30), (True, 0)])
def test_no_cookie_is_set_where_it_is_not_needed(
    settings: Settings, required: bool, rate: int
) -> None:
    settings.CAIR_KEYS_REQUIRED, settings.CAIR_CHAT_RATE = required, rate
    assert "cair_chat" not in Client().get("/").cookies


def test_probes_are_asked_in_plain_http() -> None:
    exempt = site.SECURE_REDIRECT_EXEMPT
    assert all(any(re.search(one, path) for one in exempt) for path in ("livez", "readyz"))
