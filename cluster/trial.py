"""`python -m cluster.trial`: breaks a cluster in every way under steady load, and counts.

Promised: no turn fails, every state goes on, a publication is served by every node within five
seconds, and turns need no database.
"""

import argparse
import secrets
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from cluster.load import Counted, Load
from cluster.processes import NotPossibleError, end_when_told
from cluster.report import Row, Seen, write_report
from cluster.running import Cluster, Wish, running

TAKE_OVER_SECONDS = 5.0
DATABASE_AWAY = CUT_OFF = 10.0
STEADY = 5.0
SETTLE = 1.5


@dataclass(frozen=True, slots=True)
class Pace:
    """How many people talk, and how many turns they take together in a second."""

    talkers: int = 30
    a_second: float = 30.0


class Trial:
    """A running cluster, people who talk, and what was seen."""

    def __init__(self, cluster: Cluster, load: Load) -> None:
        self.cluster, self.load = cluster, load
        self.rows: list[Row] = []
        self.began = time.monotonic()

    def run(self) -> list[Row]:
        """Do everything, one after the other; return a row for each."""
        for _name, step in self.steps():
            step()
        self.load.end()
        whole = self.load.counted(self.began, time.monotonic())
        seen = Seen(f"{self.load.inspected()} states looked into")
        self.rows.append(Row("all of it", time.monotonic() - self.began, whole, seen))
        return self.rows

    def steps(self) -> Iterator[tuple[str, Callable[[], None]]]:
        """Yield the names of the steps and what does them."""
        yield "steady", self.steady
        yield "publish", self.publish
        yield "kill", self.kill
        yield "restart the database", self.restart_database
        yield "database away", self.database_away
        yield "cut off", self.cut_off
        yield "new key", self.new_key

    @contextmanager
    def _counting(self, what: str) -> Iterator[Seen]:
        """Count the turns of a step into a row of its own."""
        seen, began = Seen(), time.monotonic()
        yield seen
        time.sleep(SETTLE)
        until = time.monotonic()
        counted = self.load.counted(began, until)
        self.rows.append(Row(what, until - began, counted, seen))
        print(self.rows[-1].line(), flush=True)

    def steady(self) -> None:
        """Let people talk undisturbed, to compare with."""
        with self._counting("nothing happens"):
            time.sleep(STEADY)

    def publish(self) -> None:
        """Publish a new release."""
        with self._counting("a new release is published") as seen:
            self._publish(seen)

    def kill(self) -> None:
        """Kill a node as a power cut would, and start it again."""
        node = self.cluster.nodes[0]
        with self._counting("a node is killed (SIGKILL)"):
            node.kill()
            time.sleep(STEADY)
        with self._counting("it is started again"):
            node.start()
            self._wait_until_up()

    def restart_database(self) -> None:
        """Restart the database; publish something afterwards."""
        with self._counting("the database restarts, then a release") as seen:
            self.cluster.database.stop()
            self.cluster.database.start()
            self._publish(seen)

    def database_away(self) -> None:
        """Stop the database for a while; publish something afterwards."""
        with self._counting("the database is away for 10 s") as seen:
            self.cluster.database.stop(at_once=True)
            began = time.monotonic()
            time.sleep(DATABASE_AWAY)
            away = self.load.counted(began, time.monotonic())
            seen.add(f"{away.turns} turns without it, {away.failed} failed")
            self.cluster.database.start()
        with self._counting("it is back, then a release") as seen:
            self._publish(seen)

    def cut_off(self) -> None:
        """Cut a node off, publish something meanwhile, let the node back."""
        node, others = self.cluster.nodes[1], [*self.cluster.nodes[:1], *self.cluster.nodes[2:]]
        with self._counting("a node is cut off, meanwhile a release") as seen:
            began = time.monotonic()
            node.cut()
            published = self.cluster.publish()
            seen.take_over(self.cluster.seconds_until_served(published, others), "the others")
            time.sleep(max(0.0, began + CUT_OFF - time.monotonic()))
        with self._counting("it is let back") as seen:
            node.mend()
            back = time.time()
            served = self.cluster.seconds_until_served(published, [node])
            late = None if served is None else served - (back - published.at)
            seen.take_over(late, "it, since it is back")
            self._wait_until_up()

    def new_key(self) -> None:
        """Roll all nodes to a new key of states in two rounds: first all read it, then all use it.

        In one round, a state signed by a node with the new key would meet one without.
        """
        old = self.cluster.settings["CAIR_STATE_KEYS"]
        new = secrets.token_urlsafe(48)
        for keys, what in ((f"{old},{new}", "read a new key"), (f"{new},{old}", "sign with it")):
            with self._counting(f"one by one, nodes {what} (SIGTERM)"):
                for node in self.cluster.nodes:
                    node.stop()
                    node.settings["CAIR_STATE_KEYS"] = keys
                    node.start()
                    self._wait_until_up()

    def _publish(self, seen: Seen) -> None:
        published = self.cluster.publish()
        seen.take_over(
            self.cluster.seconds_until_served(published, self.cluster.nodes), "all nodes"
        )

    def _wait_until_up(self) -> None:
        if self.cluster.wait_until_up() is None:
            raise RuntimeError("The load balancer does not see all nodes again.")


def run(wish: Wish, pace: Pace) -> tuple[list[Row], str]:
    """Start a cluster, break it, and return what was seen and how its network was made."""
    with running(wish) as cluster, Load(cluster.balancer.port, pace.talkers, pace.a_second) as load:
        how = (
            f"{wish.nodes} nodes with {wish.workers} worker(s), PostgreSQL, HAProxy; "
            f"{cluster.network.how}; {pace.talkers} talks, {pace.a_second:g} turns a second."
        )
        return Trial(cluster, load).run(), how


def faults(rows: list[Row]) -> list[str]:
    """Return which promises were broken, with what was seen."""
    found = [
        f"{row.what}: {text}"
        for row in rows[:-1]
        for text in (*row.counted.faults, *row.seen.too_slow(TAKE_OVER_SECONDS))
    ]
    return [*found, *_last(rows[-1].counted)]


def _last(whole: Counted) -> list[str]:
    """Return faults of the whole that no step has: those after the last one."""
    bad = whole.failed or whole.not_continued
    told = f"{whole.failed} turns failed, {whole.not_continued} states did not go on"
    return [told, *whole.faults] if bad else []


def main() -> int:
    """Run the trial, print and write its table; 0 where all promises were kept."""
    end_when_told()
    parser = argparse.ArgumentParser(prog="python -m cluster.trial", description=__doc__)
    parser.add_argument("--nodes", type=int, default=3)
    parser.add_argument("--workers", type=int, default=1, help="of each node")
    parser.add_argument("--talkers", type=int, default=30)
    parser.add_argument("--rate", type=float, default=30.0, help="turns a second, all together")
    parser.add_argument("--loopback", action="store_true", help="no network namespaces")
    parser.add_argument("--out", type=Path, default=Path("docs/operations"), help="a folder")
    asked = parser.parse_args()
    wish = Wish(asked.nodes, asked.workers, namespaces=not asked.loopback)
    try:
        rows, how = run(wish, Pace(asked.talkers, asked.rate))
    except NotPossibleError as error:
        print(f"No cluster here: {error}", file=sys.stderr)
        return 2
    print(write_report(rows, how, asked.out))
    broken = faults(rows)
    print("\n".join(broken) or "Every promise was kept.")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
