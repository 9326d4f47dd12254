"""A running cluster: the database, the nodes, the load balancer, and what is published."""

import secrets
import shutil
import tempfile
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field
from pathlib import Path

from cluster.balancer import Balancer, start_balancer
from cluster.network import Network, network
from cluster.nodes import Node
from cluster.postgres import DATABASE, NoPostgresError, Postgres, private_postgres
from cluster.processes import (
    ROOT,
    NotPossibleError,
    manage,
    plain_environment,
    program,
    wait_until,
)

PUBLISH = """
import time
from dialogue.models import Sentence
from dialogue.publishing import publish
row = Sentence.objects.filter(language="en", frame__pool="start").first()
row.text = "Hello, this is release {token}."
row.save()
number = publish(note="trial").pk
print("published", number, time.time())
"""


@dataclass(frozen=True, slots=True)
class Wish:
    """What kind of cluster is wanted."""

    nodes: int = 3
    workers: int = 1
    port: int = 0
    namespaces: bool = True
    keep_logs: bool = False


@dataclass(frozen=True, slots=True)
class Published:
    """A publication, and when it was there, by the clock of this machine."""

    number: int
    at: float


@dataclass
class Cluster:
    """Everything that runs."""

    folder: Path
    network: Network
    database: Postgres
    nodes: list[Node]
    balancer: Balancer
    settings: dict[str, str] = field(repr=False, default_factory=dict)

    def publish(self) -> Published:
        """Publish something new."""
        token = secrets.token_hex(4)
        told = manage(self.settings, "shell", "-c", PUBLISH.format(token=token))
        line = next(one for one in told.splitlines() if one.startswith("published "))
        _word, number, at = line.split()
        return Published(int(number), float(at))

    def seconds_until_served(
        self, published: Published, nodes: list[Node], seconds: float = 30
    ) -> float | None:
        """Return after how long all of these nodes served a publication, None where they do not."""
        took = wait_until(lambda: all(one.serves(published.number) for one in nodes), seconds)
        return None if took is None else time.time() - published.at

    def wait_until_up(self, seconds: float = 60) -> float | None:
        """Wait until the load balancer sends turns to all nodes again."""
        names = {node.name for node in self.nodes}
        return wait_until(lambda: self.balancer.up() == names, seconds)


def node_settings(database: Postgres, network: Network, hosts: list[str]) -> dict[str, str]:
    """Return the environment that all nodes share: the keys, the database, what they are called."""
    host = network.own_address or "127.0.0.1"
    return plain_environment() | {
        "DATABASE_URL": database.url_of(DATABASE, host),
        "CAIR_SECRET_KEY": secrets.token_urlsafe(48),
        "CAIR_STATE_KEYS": secrets.token_urlsafe(48),
        "CAIR_HOSTS": ",".join(("localhost", "127.0.0.1", *hosts)),
    }


@contextmanager
def running(wish: Wish) -> Iterator[Cluster]:
    """Yield a cluster that is ready; afterwards all of it is ended and gone.

    Raises NotPossibleError where PostgreSQL or HAProxy cannot be had.
    """
    program("haproxy", "haproxy")
    folder = Path(tempfile.mkdtemp(prefix="cair-cluster-"))
    try:
        with ExitStack() as stack:
            yield _started(wish, folder, stack)
    finally:
        if not wish.keep_logs:
            shutil.rmtree(folder, ignore_errors=True)


def _started(wish: Wish, folder: Path, stack: ExitStack) -> Cluster:
    net = stack.enter_context(network(namespaces=wish.namespaces))
    try:
        database = stack.enter_context(private_postgres(net.own_address, net.subnet))
    except NoPostgresError as error:
        raise NotPossibleError(str(error)) from error
    hosts = sorted({net.address(number)[0] for number in range(wish.nodes)} - {"127.0.0.1"})
    shared = node_settings(database, net, hosts)
    own = shared | {"DATABASE_URL": database.url, "CAIR_VAR": str(folder / "operator")}
    (folder / "operator").mkdir()
    manage(own, "prepare", "--content", str(ROOT / "content"))
    nodes = [
        Node(number, net, folder / f"node{number + 1}", dict(shared), wish.workers)
        for number in range(wish.nodes)
    ]
    for node in nodes:
        stack.callback(node.kill)
        stack.callback(node.mend)
        node.start(wait=False)
    for node in nodes:
        node.wait()
    balancer = start_balancer(nodes, folder / "balancer", wish.port)
    stack.callback(balancer.stop)
    return Cluster(folder, net, database, nodes, balancer, own)
