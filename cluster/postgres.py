"""A private PostgreSQL on loopback: `python -m cluster.postgres COMMAND…` runs a command on one.

Its data are in a folder that is deleted afterwards. Started by root, it runs as a user without
rights. It is ended by its process id, also where the command fails or is told to stop.
"""

import os
import pwd
import secrets
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from types import FrameType
from typing import NoReturn, TypedDict

from cluster.processes import free_port

#: Where the programs of the server are, which are seldom on the PATH.
PLACES = ("usr/lib/postgresql/*/bin", "usr/pgsql-*/bin", "usr/local/pgsql/bin")
#: Who the server is where root starts it: PostgreSQL refuses to be root.
UNPRIVILEGED = ("postgres", "nobody")
SECONDS = 60
USER, DATABASE = "cair", "cair"
#: Tests need no safety from power cuts.
QUICK = ("fsync=off", "full_page_writes=off", "synchronous_commit=off", "max_connections=60")


class NoPostgresError(RuntimeError):
    """PostgreSQL is not installed, or does not start."""


def program(name: str) -> str:
    """Return the path of a program of the newest PostgreSQL. Raises NoPostgresError."""
    found = [path for place in PLACES for path in Path("/").glob(f"{place}/{name}")]
    newest = max(found, key=lambda path: (len(path.parts[-3]), path.parts[-3]), default=None)
    known = str(newest) if newest else shutil.which(name)
    if known is None:
        raise NoPostgresError("PostgreSQL is not installed: apt-get install postgresql")
    return known


@dataclass
class Postgres:
    """A server with one empty database, `cair`, whose user may make more."""

    folder: Path
    port: int
    password: str = field(default_factory=lambda: secrets.token_urlsafe(16), repr=False)
    process: "subprocess.Popen[bytes] | None" = None
    #: An address of this machine besides the loopback, and the network that may call there.
    own_address: str = ""
    subnet: str = ""
    #: Settings of the server beside those of all tests, e.g. "ssl=on".
    settings: tuple[str, ...] = ()

    @property
    def certificate(self) -> Path:
        """Return the file of the certificate, where it speaks TLS."""
        return self.folder / "server.crt"

    @property
    def url(self) -> str:
        """Return the DATABASE_URL of the database."""
        return self.url_of(DATABASE)

    def url_of(self, name: str, host: str = "127.0.0.1") -> str:
        """Return the DATABASE_URL of a database of this name."""
        return f"postgresql://{USER}:{self.password}@{host}:{self.port}/{name}"

    def ask(self, question: str, database: str = DATABASE) -> list[tuple[object, ...]]:
        """Return the rows of an SQL statement, each statement a transaction of its own."""
        import psycopg  # Not for those who have no psycopg.

        with psycopg.connect(self.url_of(database), autocommit=True) as connection:
            cursor = connection.execute(question.encode())
            return cursor.fetchall() if cursor.description else []

    def new_database(self, name: str) -> str:
        """Make an empty database; return its DATABASE_URL."""
        self.ask(f'CREATE DATABASE "{name}"')
        return self.url_of(name)

    def make(self) -> None:
        """Make the files of the server and its user."""
        give(self.folder)
        secret = self.folder / "password"
        secret.write_text(self.password, encoding="ascii")
        give(secret)
        command = [program("initdb"), "--pgdata", str(self.folder / "data"), "--no-sync"]
        command += ["--username", USER, "--pwfile", str(secret), "--auth", "scram-sha-256"]
        command += ["--encoding", "UTF8", "--locale", "C.UTF-8"]
        done = subprocess.run(command, capture_output=True, text=True, check=False, **who())
        secret.unlink()
        if done.returncode:
            raise NoPostgresError(f"initdb: {done.stderr[-2000:]}")
        if self.subnet:
            with (self.folder / "data" / "pg_hba.conf").open("a", encoding="ascii") as rules:
                rules.write(f"host all all {self.subnet} scram-sha-256\n")

    def make_tls(self) -> None:
        """Make a certificate of its own for 127.0.0.1, and refuse connections without TLS."""
        key, names = self.folder / "server.key", "subjectAltName=IP:127.0.0.1,DNS:localhost"
        command = ["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2"]
        command += ["-subj", "/CN=localhost", "-addext", names]
        command += ["-keyout", str(key), "-out", str(self.certificate)]
        subprocess.run(command, capture_output=True, check=True)
        key.chmod(0o600)
        give(key)
        give(self.certificate)
        rules = self.folder / "data" / "pg_hba.conf"
        rules.write_text("hostssl all all 127.0.0.1/32 scram-sha-256\n", encoding="ascii")
        files = (f"ssl_key_file={key}", f"ssl_cert_file={self.certificate}")
        self.settings = (*self.settings, "ssl=on", *files)

    def start(self) -> None:
        """Start the server and wait until it answers."""
        command = [program("postgres"), "-D", str(self.folder / "data"), "-p", str(self.port)]
        addresses = ",".join(filter(None, ("127.0.0.1", self.own_address)))
        command += ["-c", f"listen_addresses={addresses}", "-c", "unix_socket_directories="]
        for setting in (*QUICK, *self.settings):
            command += ["-c", setting]
        with (self.folder / "log").open("ab") as log:
            self.process = subprocess.Popen(command, stdout=log, stderr=log, **who())
        until = time.monotonic() + SECONDS
        while self.process.poll() is None and time.monotonic() < until:
            if self._answers():
                return
            time.sleep(0.1)
        self.stop()
        told = (self.folder / "log").read_text(errors="replace")[-2000:]
        raise NoPostgresError(f"PostgreSQL did not start:\n{told}")

    def stop(self, *, at_once: bool = False) -> None:
        """End this server, and only this; connections are cut, with `at_once` without a word."""
        process, self.process = self.process, None
        if process is None or process.poll() is not None:
            return
        process.send_signal(signal.SIGQUIT if at_once else signal.SIGINT)
        try:
            process.wait(SECONDS)
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGQUIT)
            process.wait(SECONDS)

    def _answers(self) -> bool:
        command = [program("pg_isready"), "-q", "-h", "127.0.0.1", "-p", str(self.port)]
        return subprocess.run(command, check=False).returncode == 0


class Who(TypedDict, total=False):
    """As whom a program runs, as subprocess takes it."""

    user: int
    group: int
    extra_groups: list[int]
    cwd: str


def who() -> Who:
    """Return as whom the server's programs run: as this user, or where this is root as another."""
    if os.geteuid():
        return {}
    for name in UNPRIVILEGED:
        try:
            user = pwd.getpwnam(name)
        except KeyError:
            continue
        return {"user": user.pw_uid, "group": user.pw_gid, "extra_groups": [], "cwd": "/"}
    raise NoPostgresError("Root needs a user without rights for PostgreSQL: postgres or nobody.")


def give(path: Path) -> None:
    """Give a file to whom the server's programs run as."""
    whose = who()
    if whose:
        os.chown(path, whose["user"], whose["group"])


@contextmanager
def private_postgres(
    own_address: str = "", subnet: str = "", *, tls: bool = False
) -> Iterator[Postgres]:
    """Yield a started server; afterwards it is ended and its data are gone.

    With `own_address` it listens there too, for those of `subnet`; with `tls` it speaks only TLS.
    """
    folder = Path(tempfile.mkdtemp(prefix="cair-postgres-"))
    server = Postgres(folder, free_port(), own_address=own_address, subnet=subnet)
    try:
        server.make()
        if tls:
            server.make_tls()
        server.start()
        try:
            server.ask(f'CREATE DATABASE "{DATABASE}"', "postgres")
            yield server
        finally:
            server.stop()
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def _told_to_stop(number: int, frame: FrameType | None) -> NoReturn:
    raise SystemExit(128 + number)


def main(command: list[str]) -> int:
    """Run a command with DATABASE_URL set to a private server; return what it returned."""
    signal.signal(signal.SIGTERM, _told_to_stop)
    with private_postgres() as server:
        environment = os.environ | {"DATABASE_URL": server.url}
        return subprocess.run(command, env=environment, check=False).returncode


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
