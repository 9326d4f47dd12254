"""The database of a URL: SQLite in a file, or PostgreSQL through a pool of connections.

What stands after the `?` of a PostgreSQL URL: any connection option of PostgreSQL that is not
given elsewhere (`sslmode=require`, `sslrootcert=…`, `host=/run/postgresql`), and of our own

* `pool`: connections that one process keeps at most; 0 makes a new one each time, for a pooler
  in between such as PgBouncer, which may give every transaction another connection;
* `statement_seconds`: the longest time of one statement; 0 sets none, as is usual with `pool=0`:
  PgBouncer refuses connections that bring such a limit.
"""

from collections.abc import Mapping
from pathlib import Path
from urllib.parse import SplitResult, parse_qsl, unquote, urlsplit

from django.core.exceptions import ImproperlyConfigured

Settings = dict[str, object]

FORMS = "give sqlite:///path or postgresql://user:password@host:port/name?sslmode=require"
POOL, STATEMENT_SECONDS = 4, 60
MOST_CONNECTIONS, LONGEST_STATEMENT = 1000, 86_400
#: What a lost database costs a request at most, in seconds.
CONNECT_SECONDS = 3
#: A network that is cut is noticed within seconds, not after the quarter of an hour of TCP.
NETWORK = {
    "connect_timeout": str(CONNECT_SECONDS),
    "keepalives_idle": "5",
    "keepalives_interval": "2",
    "keepalives_count": "3",
    "tcp_user_timeout": "5000",
    "application_name": "cair",
}
#: What the URL says before the `?`, and what Django sets itself.
TAKEN = frozenset(("user", "password", "dbname", "client_encoding"))
SSL_MODES = ("disable", "allow", "prefer", "require", "verify-ca", "verify-full")
NUMBERS = frozenset(name for name, value in NETWORK.items() if value.isdecimal())


def database(url: str, default: Path) -> Settings:
    """Return Django's settings of the database of a URL, of the SQLite file `default` without one.

    Raises ImproperlyConfigured, which never tells the password.
    """
    if not url:
        return sqlite(default)
    try:
        parts = urlsplit(url)
        port = parts.port
    except ValueError as error:
        raise _wrong(f"{_safe(error)} {FORMS}") from None
    if parts.scheme == "sqlite":
        return _sqlite(parts)
    if parts.scheme in {"postgres", "postgresql"}:
        return _postgres(parts, port)
    raise _wrong(FORMS)


def sqlite(path: Path) -> Settings:
    """Return the settings of an SQLite file in write-ahead mode."""
    path.parent.mkdir(parents=True, exist_ok=True)
    return {
        "ENGINE": "django.db.backends.sqlite3",
        "NAME": str(path),
        "OPTIONS": {
            "init_command": "PRAGMA journal_mode=WAL; PRAGMA synchronous=NORMAL;",
            "transaction_mode": "IMMEDIATE",
            "timeout": 20,
        },
    }


def close_before_fork() -> None:
    """Close all connections and their pools: a child must not share them, nor miss their threads.

    The pool opens again, in each process its own, when a connection is needed.
    """
    from django.db import connections  # Settings are read before Django is there.

    connections.close_all()
    for connection in connections.all(initialized_only=True):
        close_pool = getattr(connection, "close_pool", None)
        if close_pool:
            close_pool()


def _sqlite(parts: SplitResult) -> Settings:
    if parts.netloc or parts.query or not parts.path.strip("/"):
        raise _wrong("after sqlite:// comes the path of a file, e.g. sqlite:////srv/cair/db")
    return sqlite(Path("/" + unquote(parts.path).lstrip("/")))


def _postgres(parts: SplitResult, port: int | None) -> Settings:
    name = unquote(parts.path.removeprefix("/"))
    if not name or "/" in name:
        raise _wrong(f"the name of the database is missing; {FORMS}")
    if parts.fragment:
        raise _wrong("write %23 for a # in the password")
    given = _options(parts.query)
    pool = _number(given, "pool", POOL, MOST_CONNECTIONS)
    usual = STATEMENT_SECONDS if pool else 0
    seconds = _number(given, "statement_seconds", usual, LONGEST_STATEMENT)
    host = unquote(parts.hostname or "")
    if host and "host" in given:
        raise _wrong("the host is given twice")
    _check(given)
    options: Settings = {**NETWORK, **given}
    if seconds:
        limit = f"-c statement_timeout={seconds}s"
        options["options"] = f"{limit} {given.get('options', '')}".strip()
    if pool:
        options["pool"] = _pool(pool)
    return {
        "ENGINE": "cair_site.postgresql",
        "NAME": name,
        "USER": unquote(parts.username or ""),
        "PASSWORD": unquote(parts.password or ""),
        "HOST": host,
        "PORT": str(port or ""),
        # A pool keeps the connections; without one, none outlives its request.
        "CONN_MAX_AGE": 0,
        # They would live longer than a transaction, and so than a connection of a pooler.
        "DISABLE_SERVER_SIDE_CURSORS": not pool,
        "OPTIONS": options,
    }


def _pool(most: int) -> Settings:
    """Return the options of the pool: it tries again each second while the database is away."""
    return {
        "min_size": 0,
        "max_size": most,
        "timeout": CONNECT_SECONDS,
        "reconnect_timeout": 1,
        "max_idle": 60,
        "max_lifetime": 1800,
        "num_workers": 1,
    }


def _options(query: str) -> dict[str, str]:
    try:
        pairs = parse_qsl(query, keep_blank_values=True, strict_parsing=bool(query))
    except ValueError:
        raise _wrong("after the ? come name=value pairs with & between them") from None
    given = dict(pairs)
    if len(given) < len(pairs):
        raise _wrong("an option is given twice")
    return given


def _number(given: dict[str, str], name: str, default: int, most: int) -> int:
    value = given.pop(name, str(default))
    if not (value.isascii() and value.isdecimal()) or int(value) > most:
        raise _wrong(f"{name} is {value!r}; give a whole number 0..{most}")
    return int(value)


def _check(given: Mapping[str, str]) -> None:
    """Refuse what PostgreSQL does not know, before the first connection would."""
    try:
        from psycopg import ProgrammingError
        from psycopg.conninfo import make_conninfo
    except ImportError as error:
        raise _wrong("psycopg is not installed: pip install 'psycopg[binary,pool]'") from error
    for name, value in given.items():
        if name in TAKEN:
            raise _wrong(f"{name} is not given after the ?; {FORMS}")
        try:
            make_conninfo(**{name: value})
        except (ProgrammingError, TypeError):
            raise _wrong(f"PostgreSQL has no connection option {name!r}") from None
        if name in NUMBERS and not (value.isascii() and value.isdecimal()):
            raise _wrong(f"{name} is {value!r}; give a whole number")
    mode = given.get("sslmode", SSL_MODES[0])
    if mode not in SSL_MODES:
        raise _wrong(f"sslmode is {mode!r}; give one of {', '.join(SSL_MODES)}")


def _safe(error: ValueError) -> str:
    """Return what urlsplit says of a wrong address, unless it repeats a part of it."""
    return "the port is a number;" if "ort" in str(error) else "the address cannot be read;"


def _wrong(text: str) -> ImproperlyConfigured:
    return ImproperlyConfigured(f"DATABASE_URL: {text}.")
