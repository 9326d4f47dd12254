"""Keys of the API: shown once, checked in memory, refused in the shape of our errors."""

from collections.abc import Iterator
from datetime import date

import pytest
from django.db import DatabaseError
from django.test import Client
from pytest_django import DjangoAssertNumQueries
from pytest_django.fixtures import Settings

from authoring import keys
from authoring.keys import Known, Ring, TooOftenError, UnknownKeyError, digest_of, make_key, revoke
from authoring.models import ApiKey
from authoring.roles import ADMINISTRATOR, AUTHOR
from dialogue.engine.content import Content
from tests.authoring.people import logged_in

KEY = "cair_12345678-and-the-rest"
GUARDED = ["/api/v1/hub/", "/api/v1/hub", "/api/v1/topics/", "/api/v1/actions/", "/CAIR_hub"]
GUARDED += ["/it/CAIR_hub/start", "/CAIR_hub/", "/api/v1/nothing/"]


@pytest.fixture(autouse=True)
def _alone(settings: Settings) -> Iterator[None]:
    settings.CAIR_POLL_SECONDS = 3600
    keys.forget()
    yield
    keys.forget()


@pytest.fixture
def required(settings: Settings, published: Content) -> None:
    settings.CAIR_KEYS_REQUIRED = True


def code(answer: object) -> tuple[int, str]:
    return answer.status_code, answer.json()["error"]["code"]  # type: ignore[attr-defined]


def new_key(rate: int | None = None) -> str:
    return make_key("robot", rate, None)[1]


def ring(rate: int | None, clock: list[float]) -> Ring:
    found = Ring(clock=lambda: clock[0])
    found.keys = {KEY[: keys.PREFIX_LENGTH]: Known(1, digest_of(KEY), rate)}
    return found


@pytest.mark.usefixtures("published")
@pytest.mark.parametrize("path", GUARDED[:-1])
def test_no_key_is_needed_by_default(path: str, client: Client) -> None:
    assert client.get(path).status_code == 200


@pytest.mark.django_db
@pytest.mark.usefixtures("required")
@pytest.mark.parametrize("path", GUARDED)
def test_without_a_key_nothing_is_answered(path: str, client: Client) -> None:
    answer = client.get(path)
    assert code(answer) == (401, "key.missing")
    assert answer.headers["WWW-Authenticate"] == "Api-Key"


@pytest.mark.django_db
@pytest.mark.usefixtures("required")
@pytest.mark.parametrize("path", ["/livez", "/readyz", "/", "/admin/login/", "/api/docs/"])
def test_other_pages_need_no_key(path: str, client: Client) -> None:
    assert client.get(path).status_code == 200


@pytest.mark.django_db
@pytest.mark.usefixtures("required")
@pytest.mark.parametrize("given", ["x", "cair_", "Bearer", "é" * 50, "cair_" + "a" * 5000])
def test_a_wrong_key_is_refused(given: str, client: Client) -> None:
    new_key()
    answer = client.get("/api/v1/hub/", headers={"Authorization": f"Api-Key {given}"})
    assert code(answer) == (403, "key.unknown")


@pytest.mark.django_db
@pytest.mark.usefixtures("required")
@pytest.mark.parametrize("change", [lambda key: key[:-1], lambda key: key + "a", str.swapcase])
def test_a_key_that_is_nearly_right_is_refused(change: object, client: Client) -> None:
    given = change(new_key())  # type: ignore[operator]
    assert client.get("/api/v1/hub/", headers={"X-Api-Key": given}).status_code == 403


@pytest.mark.django_db
@pytest.mark.usefixtures("required")
def test_a_turn_with_a_key_asks_the_database_nothing(
    client: Client, django_assert_num_queries: DjangoAssertNumQueries
) -> None:
    key = new_key()
    headers = ({"Authorization": f"Api-Key {key}"}, {"Authorization": f"api-key {key}"})
    client.get("/api/v1/hub/", headers={"X-Api-Key": key})
    for each in (*headers, {"X-Api-Key": key}):
        with django_assert_num_queries(0):
            answer = client.post("/api/v1/hub/", b"{}", "application/json", headers=each)
        assert answer.status_code == 200


@pytest.mark.django_db
@pytest.mark.usefixtures("required")
def test_a_revoked_key_is_refused_after_the_next_look(client: Client) -> None:
    key = new_key()
    assert client.get("/api/v1/hub/", headers={"X-Api-Key": key}).status_code == 200
    revoke(ApiKey.objects.get())
    keys._worker.ring.load()
    assert client.get("/api/v1/hub/", headers={"X-Api-Key": key}).status_code == 403


@pytest.mark.django_db
@pytest.mark.usefixtures("required")
def test_a_key_made_later_lets_in_after_the_next_look(client: Client) -> None:
    new_key()
    client.get("/api/v1/hub/", headers={"X-Api-Key": "x"})
    key = new_key()
    keys._worker.ring.load()
    assert client.get("/api/v1/hub/", headers={"X-Api-Key": key}).status_code == 200


@pytest.mark.django_db
@pytest.mark.usefixtures("required")
def test_a_key_used_too_often_is_told_when_to_come_again(client: Client) -> None:
    key = new_key(rate=2)
    seen = [client.get("/api/v1/hub/", headers={"X-Api-Key": key}) for _ in range(3)]
    assert [answer.status_code for answer in seen] == [200, 200, 429]
    assert code(seen[2]) == (429, "key.too_often")
    assert 1 <= int(seen[2].headers["Retry-After"]) <= 31


@pytest.mark.usefixtures("required")
def test_keys_that_cannot_be_read_let_nobody_in(
    client: Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    def gone(**_more: object) -> None:
        raise DatabaseError

    monkeypatch.setattr(ApiKey.objects, "filter", gone)
    assert code(client.get("/api/v1/hub/", headers={"X-Api-Key": "x"})) == (503, "key.unchecked")


def test_calls_come_back_with_time() -> None:
    clock = [0.0]
    tried = ring(60, clock)
    for _ in range(60):
        tried.let_in(KEY)
    with pytest.raises(TooOftenError) as told:
        tried.let_in(KEY)
    clock[0] += told.value.seconds
    tried.let_in(KEY)


def test_calls_do_not_heap_up_while_a_robot_rests() -> None:
    clock = [0.0]
    tried = ring(3, clock)
    tried.let_in(KEY)
    clock[0] = 1e6
    for _ in range(3):
        tried.let_in(KEY)
    with pytest.raises(TooOftenError):
        tried.let_in(KEY)


def test_the_beginning_of_a_key_is_not_enough() -> None:
    with pytest.raises(UnknownKeyError):
        ring(None, [0.0]).let_in(KEY[: keys.PREFIX_LENGTH])


@pytest.mark.django_db
def test_the_day_of_use_is_written_at_most_once_an_hour(
    django_assert_num_queries: DjangoAssertNumQueries,
) -> None:
    row, key = make_key("robot", None, None)
    clock = [0.0]
    tried = Ring(clock=lambda: clock[0])
    tried.let_in(key)
    tried.note_use()
    row.refresh_from_db()
    assert isinstance(row.last_used, date)
    ApiKey.objects.update(last_used=None)
    for clock[0] in (10.0, 3599.0):
        tried.let_in(key)
        with django_assert_num_queries(0):
            tried.note_use()
    clock[0] = 3600.0
    tried.note_use()
    row.refresh_from_db()
    assert row.last_used is not None


@pytest.mark.django_db
def test_a_new_key_is_shown_once_and_kept_nowhere() -> None:
    client = logged_in(ADMINISTRATOR)
    answer = client.post("/admin/keys/", {"label": "robot in the day room", "rate": "60"})
    key = answer.context["new_key"]
    assert key in answer.content.decode()
    assert "no-store" in answer.headers["Cache-Control"]
    row = ApiKey.objects.get()
    assert (row.digest, row.rate) == (digest_of(key), 60)
    assert row.created_by is not None
    assert key not in str(ApiKey.objects.values())
    assert key not in client.get("/admin/keys/").content.decode()
    assert row.prefix in client.get("/admin/keys/").content.decode()


@pytest.mark.django_db
@pytest.mark.parametrize(
    ("label", "rate"),
    [
        ("", ""),
        ("x" * 101, ""),
        ("a\x07", ""),
        ("a", "0"),
        ("a", "-1"),
        ("a", "1.5"),
        ("a", "²"),
        ("a", "9" * 40),
        ("a", "100001"),
    ],
)
def test_what_is_wrong_is_told_and_no_key_made(label: str, rate: str) -> None:
    answer = logged_in(ADMINISTRATOR).post("/admin/keys/", {"label": label, "rate": rate})
    assert answer.status_code == 400
    assert answer.context["faults"]
    assert not ApiKey.objects.exists()


@pytest.mark.django_db
def test_an_administrator_revokes_a_key() -> None:
    row, _key = make_key("robot", None, None)
    client = logged_in(ADMINISTRATOR)
    assert client.post("/admin/keys/", {"revoke": str(row.pk)}).status_code == 302
    row.refresh_from_db()
    assert row.revoked is not None
    for nonsense in ("x", "99999", "9" * 30):
        assert client.post("/admin/keys/", {"revoke": nonsense}).status_code == 404


@pytest.mark.django_db
def test_an_author_has_no_page_of_keys() -> None:
    client = logged_in(AUTHOR)
    assert client.get("/admin/keys/").status_code == 403
    assert client.post("/admin/keys/", {"label": "mine"}).status_code == 403
