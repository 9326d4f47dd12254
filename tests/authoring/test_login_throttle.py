"""Guessing passwords: a name is locked for its address, in words and for some minutes."""

import logging
from datetime import timedelta
from typing import Any

import pytest
from django.contrib.auth.models import User
from django.test import Client
from django.utils import timezone
from pytest_django.fixtures import Settings

from authoring import login_throttle
from authoring.models import LoginAttempts
from authoring.roles import AUTHOR
from tests.authoring.people import PASSWORD, person

pytestmark = pytest.mark.django_db
HERE, ELSEWHERE = "203.0.113.9", "198.51.100.7"


@pytest.fixture(autouse=True)
def rosa() -> User:
    """Return an author who has a password."""
    return person(AUTHOR, "rosa")


def log_in(password: str, name: str = "rosa", address: str = HERE) -> Any:
    form = {"username": name, "password": password, "next": "/admin/"}
    return Client().post("/admin/login/", form, REMOTE_ADDR=address)


def let_in(answer: Any) -> bool:
    return bool(answer.status_code == 302)


def locked(answer: Any) -> bool:
    return "Too many failed logins" in answer.content.decode()


def test_a_name_is_locked_after_five_failures_even_for_the_right_password() -> None:
    seen = [log_in("wrong") for _ in range(5)]
    assert not any(map(let_in, seen))
    assert not any(map(locked, seen))
    answer = log_in(PASSWORD)
    assert not let_in(answer)
    assert "Try again in 15 min." in answer.content.decode()


def test_the_fifth_attempt_may_be_the_right_one() -> None:
    for _ in range(4):
        log_in("wrong")
    assert let_in(log_in(PASSWORD))
    for _ in range(4):
        log_in("wrong")
    assert let_in(log_in(PASSWORD))


def test_the_lock_ends(settings: Settings) -> None:
    for _ in range(5):
        log_in("wrong")
    past = timezone.now() - timedelta(minutes=settings.CAIR_LOGIN_MINUTES, seconds=1)
    LoginAttempts.objects.update(since=past, locked_until=timezone.now() - timedelta(seconds=1))
    assert let_in(log_in(PASSWORD))


def test_waiting_behind_a_lock_does_not_make_it_longer() -> None:
    for _ in range(5):
        log_in("wrong")
    before = list(LoginAttempts.objects.order_by("pk").values())
    for _ in range(5):
        assert locked(log_in("wrong"))
    assert list(LoginAttempts.objects.order_by("pk").values()) == before


def test_failures_of_long_ago_do_not_count(settings: Settings) -> None:
    for _ in range(4):
        log_in("wrong")
    past = timezone.now() - timedelta(minutes=settings.CAIR_LOGIN_MINUTES, seconds=1)
    LoginAttempts.objects.update(since=past)
    for _ in range(4):
        assert not locked(log_in("wrong"))
    assert let_in(log_in(PASSWORD))


def test_others_are_not_locked_out() -> None:
    person(AUTHOR, "ugo")
    for _ in range(6):
        log_in("wrong")
    assert let_in(log_in(PASSWORD, name="ugo"))
    assert let_in(log_in(PASSWORD, address=ELSEWHERE))


@pytest.mark.parametrize("name", ["ROSA", "ｒｏｓａ", "Rosa"])
def test_a_name_written_otherwise_is_the_same_name(name: str) -> None:
    for _ in range(5):
        log_in("wrong", name=name)
    assert locked(log_in("wrong"))


def test_an_unknown_name_is_locked_like_a_known_one() -> None:
    for _ in range(5):
        log_in("wrong", name="nobody")
    assert locked(log_in("wrong", name="nobody"))


def test_an_address_that_tries_many_names_is_locked(settings: Settings) -> None:
    settings.CAIR_LOGIN_FAILURES = 2
    for number in range(2 * login_throttle.NAMES):
        assert not locked(log_in("wrong", name=f"name{number}"))
    assert locked(log_in(PASSWORD))
    assert let_in(log_in(PASSWORD, address=ELSEWHERE))


def test_a_header_does_not_make_another_address(settings: Settings) -> None:
    for number in range(5):
        form = {"username": "rosa", "password": "wrong"}
        headers = {"X-Forwarded-For": f"198.51.100.{number}"}
        Client().post("/admin/login/", form, REMOTE_ADDR=HERE, headers=headers)
    assert locked(log_in(PASSWORD))


def test_many_at_once_gain_nothing() -> None:
    begun = [login_throttle.begin("rosa", HERE) for _ in range(50)]
    assert begun.count(0) == 5


def test_neither_name_nor_address_nor_password_is_kept(
    caplog: pytest.LogCaptureFixture, rosa: User
) -> None:
    with caplog.at_level(logging.INFO, "cair.audit"):
        log_in("a-secret-word", name="my-password-by-mistake")
        log_in(PASSWORD)
    kept = str(list(LoginAttempts.objects.values())) + caplog.text
    lines = [vars(one)["fields"] for one in caplog.records if one.name == "cair.audit"]
    assert lines == [
        {"result": "failed", "address": HERE},
        {"result": "done", "address": HERE, "user": rosa.pk},
    ]
    for word in ("rosa", "mistake", "secret-word"):
        assert word not in kept
    assert HERE not in str(list(LoginAttempts.objects.values()))


def test_what_is_old_is_forgotten() -> None:
    log_in("wrong", name="nobody")
    LoginAttempts.objects.update(since=timezone.now() - timedelta(days=1))
    log_in("wrong", address=ELSEWHERE)
    assert LoginAttempts.objects.count() == 2


def test_an_empty_form_is_no_attempt() -> None:
    for _ in range(10):
        log_in("", name="")
    assert not LoginAttempts.objects.exists()
