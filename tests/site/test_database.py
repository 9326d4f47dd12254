"""A DATABASE_URL says what it says, a wrong one says why; JSON and locks on both databases."""

import threading
from pathlib import Path
from typing import Any

import pytest
from django.core.exceptions import ImproperlyConfigured
from django.db import OperationalError, connection, connections
from django.db.backends.sqlite3.base import DatabaseWrapper as Sqlite

from cair_site.databases import close_before_fork, database
from cair_site.one_at_a_time import one_at_a_time
from dialogue.models import Culture

DEFAULT = Path("/nowhere/cair.sqlite3")
PASSWORD = "s3cret"


def settings_of(url: str) -> dict[str, Any]:
    return database(url, DEFAULT)


def test_a_file_of_sqlite(tmp_path: Path) -> None:
    found = settings_of(f"sqlite:///{tmp_path}/a%20b/cair.sqlite3")
    assert found["ENGINE"] == "django.db.backends.sqlite3"
    assert Path(found["NAME"]) == tmp_path / "a b" / "cair.sqlite3"
    assert (tmp_path / "a b").is_dir()
    assert database("", tmp_path / "own") == database(f"sqlite:///{tmp_path}/own", DEFAULT)


def test_all_parts_of_a_url_of_postgresql() -> None:
    found = settings_of("postgresql://an%40na:p%2Fw%23@db.example:5433/ca%20ir?sslmode=require")
    named = {name: found[name] for name in ("NAME", "USER", "PASSWORD", "HOST", "PORT")}
    assert named == {
        "NAME": "ca ir",
        "USER": "an@na",
        "PASSWORD": "p/w#",
        "HOST": "db.example",
        "PORT": "5433",
    }
    assert found["OPTIONS"]["sslmode"] == "require"
    assert settings_of("postgres://db/cair")["PORT"] == ""


def test_the_host_may_be_a_socket() -> None:
    assert settings_of("postgresql:///cair?host=/run/pg")["OPTIONS"]["host"] == "/run/pg"
    assert settings_of("postgresql://%2Frun%2Fpg/cair")["HOST"] == "/run/pg"


def test_times_have_limits_which_the_url_may_change() -> None:
    usual = settings_of("postgresql://db/cair")["OPTIONS"]
    assert (usual["connect_timeout"], usual["options"]) == ("3", "-c statement_timeout=60s")
    assert usual["pool"]["timeout"] == 3
    url = "postgresql://db/cair?connect_timeout=9&statement_seconds=5&options=-c%20work_mem=9MB"
    other = settings_of(url)["OPTIONS"]
    assert other["connect_timeout"] == "9"
    assert other["options"] == "-c statement_timeout=5s -c work_mem=9MB"
    assert "options" not in settings_of("postgresql://db/cair?statement_seconds=0")["OPTIONS"]


def test_the_pool_has_a_size_or_is_none() -> None:
    assert settings_of("postgresql://db/cair")["OPTIONS"]["pool"]["max_size"] == 4
    assert settings_of("postgresql://db/cair?pool=9")["OPTIONS"]["pool"]["max_size"] == 9
    without = settings_of("postgresql://db/cair?pool=0")
    assert not {"pool", "options"} & without["OPTIONS"].keys()
    assert (without["CONN_MAX_AGE"], without["DISABLE_SERVER_SIDE_CURSORS"]) == (0, True)
    limited = settings_of("postgresql://db/cair?pool=0&statement_seconds=9")
    assert limited["OPTIONS"]["options"] == "-c statement_timeout=9s"


@pytest.mark.parametrize(
    ("url", "told"),
    [
        ("mysql://db/cair", "give sqlite:///path or postgresql://"),
        ("cair.sqlite3", "give sqlite:///path or postgresql://"),
        ("sqlite://cair.sqlite3", "path of a file"),
        ("sqlite:///", "path of a file"),
        ("sqlite:////tmp/x?mode=ro", "path of a file"),
        ("postgresql://db", "name of the database is missing"),
        ("postgresql://db/a/b", "name of the database is missing"),
        (f"postgresql://anna:{PASSWORD}@db:54x/cair", "the port is a number"),
        (f"postgresql://anna:{PASSWORD}@db:99999/cair", "the port is a number"),
        (f"postgresql://anna:{PASSWORD}@[db/cair", "the address cannot be read"),
        (f"postgresql://anna:{PASSWORD}#@db/cair", "DATABASE_URL"),
        (f"postgresql://anna:{PASSWORD}@db/cair#x", "write %23 for a #"),
        ("postgresql://db/cair?sslmod=require", "no connection option 'sslmod'"),
        ("postgresql://db/cair?sslmode=yes", "sslmode is 'yes'; give one of disable, allow"),
        ("postgresql://db/cair?sslmode", "name=value pairs"),
        ("postgresql://db/cair?sslmode=require&sslmode=disable", "given twice"),
        ("postgresql://db/cair?host=other", "the host is given twice"),
        (f"postgresql://db/cair?password={PASSWORD}", "password is not given after the"),
        ("postgresql://db/cair?connect_timeout=soon", "connect_timeout is 'soon'"),
        ("postgresql://db/cair?pool=many", "pool is 'many'; give a whole number 0..1000"),
        ("postgresql://db/cair?pool=-1", "pool is '-1'"),
        ("postgresql://db/cair?statement_seconds=1e9", "statement_seconds is '1e9'"),
    ],
)
def test_a_wrong_url_says_what_is_wrong_and_no_password(url: str, told: str) -> None:
    with pytest.raises(ImproperlyConfigured) as caught:
        settings_of(url)
    assert str(caught.value).startswith("DATABASE_URL: ")
    assert told in str(caught.value)
    assert PASSWORD not in str(caught.value)


def test_json_keeps_the_order_of_its_keys(db: None) -> None:
    names = {"zz": "1", "a": "2", "it": "3", "en": "4", "ja": "ü\\u0000\"'"}
    Culture.objects.create(code="XX", names=names, language="en")
    assert list(Culture.objects.get(code="XX").names.items()) == list(names.items())
    Culture.objects.filter(code="XX").update(names={"b": None, "a": [1.5, True]})
    assert Culture.objects.get(code="XX").names == {"b": None, "a": [1.5, True]}


def test_a_database_works_again_after_its_pool_was_closed(transactional_db: None) -> None:
    if connection.vendor == "sqlite":
        pytest.skip("SQLite has no pool, and a database in memory goes with its connection.")
    assert Culture.objects.count() == 0
    close_before_fork()
    close_before_fork()
    assert Culture.objects.count() == 0


def sqlite_of(path: Path) -> Sqlite:
    return Sqlite({**connections.settings["default"], **database("", path)}, "default")


def overlap(used: Any, works: tuple[str, str]) -> bool:
    """Say whether the second work begins while the first goes on."""
    inside = threading.Event()

    def second() -> None:
        with one_at_a_time(works[1], used):
            inside.set()

    thread = threading.Thread(target=second)
    with one_at_a_time(works[0], used):
        thread.start()
        overlapped = inside.wait(0.5)
    thread.join(10)
    assert inside.is_set()
    return overlapped


def test_the_same_work_waits_and_another_does_not(db: None, tmp_path: Path) -> None:
    used = sqlite_of(tmp_path / "x.sqlite3") if connection.vendor == "sqlite" else connection.copy()
    assert not overlap(used, ("migrate", "migrate"))
    assert overlap(used, ("migrate", "prepare"))


def test_work_that_fails_lets_go(db: None, tmp_path: Path) -> None:
    used = sqlite_of(tmp_path / "x.sqlite3") if connection.vendor == "sqlite" else connection.copy()
    with pytest.raises(ZeroDivisionError), one_at_a_time("migrate", used):
        _ = 1 // 0
    with one_at_a_time("migrate", used):
        pass


def test_a_statement_has_a_limit_of_time(db: None) -> None:
    if connection.vendor == "sqlite":
        pytest.skip("SQLite has no limit of time.")
    with connection.cursor() as cursor:
        cursor.execute("SHOW statement_timeout")
        assert cursor.fetchone() == ("1min",)
        cursor.execute("SET LOCAL statement_timeout = 10")
        with pytest.raises(OperationalError):
            cursor.execute("SELECT pg_sleep(5)")
