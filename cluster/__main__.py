"""`python -m cluster`: a cluster to look at; Ctrl-C ends all of it."""

import argparse
import signal
import sys
import threading

from cluster.processes import NotPossibleError
from cluster.running import Cluster, Wish, running


def main() -> int:
    """Run a cluster until told to stop."""
    asked = _arguments()
    told = threading.Event()
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda _number, _frame: told.set())
    print("Starting PostgreSQL, the nodes and HAProxy ...", flush=True)
    try:
        wish = Wish(asked.nodes, asked.workers, asked.port, not asked.loopback, keep_logs=True)
        with running(wish) as cluster:
            _tell(cluster)
            told.wait()
            print("Ending all of it ...", flush=True)
    except NotPossibleError as error:
        print(f"No cluster here: {error}", file=sys.stderr)
        return 2
    return 0


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m cluster", description=__doc__)
    parser.add_argument("--nodes", type=int, default=3)
    parser.add_argument("--workers", type=int, default=1, help="of each node")
    parser.add_argument("--port", type=int, default=0, help="of the load balancer; 0: a free one")
    parser.add_argument("--loopback", action="store_true", help="no network namespaces")
    return parser.parse_args()


def _tell(cluster: Cluster) -> None:
    print(f"CAIR is at   {cluster.balancer.url}")
    print(f"network      {cluster.network.how}")
    print(f"database     127.0.0.1:{cluster.database.port} (PostgreSQL, process {_id(cluster)})")
    for node in cluster.nodes:
        host, port = node.address
        process = node.process.pid if node.process else "-"
        print(f"{node.name}        http://{host}:{port}/ (process {process}), log {node.log}")
    print(f"logs         {cluster.folder}")
    print("Ctrl-C ends all of it.", flush=True)


def _id(cluster: Cluster) -> int:
    return cluster.database.process.pid if cluster.database.process else 0


if __name__ == "__main__":
    sys.exit(main())
