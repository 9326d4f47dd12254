"""One node: gunicorn with a data folder of its own, and what it says of itself."""

import http.client
import json
import signal
import sys
from dataclasses import dataclass, field
from pathlib import Path

from cluster.network import Network
from cluster.processes import Process, end, kill, start, wait_until

START_SECONDS = 60.0
ANSWER_SECONDS = 2.0


@dataclass
class Node:
    """A gunicorn that can be started, killed, cut off and started again."""

    number: int
    network: Network
    folder: Path
    settings: dict[str, str]
    workers: int = 1
    process: Process | None = None
    address: tuple[str, int] = field(init=False)

    def __post_init__(self) -> None:
        self.address = self.network.address(self.number)
        (self.folder / "var").mkdir(parents=True, exist_ok=True)

    @property
    def name(self) -> str:
        """Return what the load balancer calls it."""
        return f"node{self.number + 1}"

    @property
    def log(self) -> Path:
        """Return its log file."""
        return self.folder / "log"

    def start(self, *, wait: bool = True) -> None:
        """Start it with its settings; wait until it is ready. Raises RuntimeError."""
        host, port = self.address
        command = [sys.executable, "-m", "gunicorn", "--config", "cair_site/gunicorn_conf.py"]
        command += ["--bind", f"{host}:{port}", "--workers", str(self.workers)]
        environment = self.settings | {"CAIR_VAR": str(self.folder / "var")}
        with self.log.open("ab") as log:
            self.process = start(self.network.command(self.number, command), log, environment)
        if wait:
            self.wait()

    def wait(self) -> None:
        """Wait until it is ready. Raises RuntimeError where it ends or takes too long."""
        took = wait_until(lambda: not self.running() or self.release() is not None, START_SECONDS)
        if took is None or not self.running():
            told = self.log.read_text(errors="replace")[-3000:]
            raise RuntimeError(f"{self.name} did not start:\n{told}")

    def running(self) -> bool:
        """Say whether its process is there."""
        return self.process is not None and self.process.poll() is None

    def release(self) -> int | None:
        """Return the number of the publication it serves, None where it does not answer."""
        connection = http.client.HTTPConnection(*self.address, timeout=ANSWER_SECONDS)
        try:
            connection.request("GET", "/readyz", headers={"Host": "localhost"})
            answer = connection.getresponse()
            number = json.loads(answer.read())["publication"]
        except (OSError, http.client.HTTPException, ValueError, KeyError):
            return None
        finally:
            connection.close()
        return int(number) if number is not None else None

    def serves(self, number: int) -> bool:
        """Say whether it serves a publication: all workers, as far as so many calls reach them."""
        calls = 1 if self.workers == 1 else 20 * self.workers
        return all(self.release() == number for _ in range(calls))

    def kill(self) -> None:
        """End it as a power cut would."""
        if self.process:
            kill(self.process)

    def stop(self) -> None:
        """End it as an update does: turns that have begun are answered."""
        if self.process:
            end(self.process, signal.SIGTERM)

    def cut(self) -> None:
        """Cut it off from the load balancer and the database."""
        if self.process:
            self.network.cut(self.number, self.process)

    def mend(self) -> None:
        """Let it back."""
        if self.process:
            self.network.mend(self.number, self.process)
