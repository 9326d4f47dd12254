"""Asks the server of this container whether it is ready: `python deploy/docker/health.py [URL]`.

Ends with 0 where it is, else with 1 and the reason.
"""

import sys
from urllib.request import urlopen

HERE = "http://127.0.0.1:8000/readyz"
SECONDS = 4


def main(url: str = HERE) -> int:
    """Ask once."""
    try:
        with urlopen(url, timeout=SECONDS):  # noqa: S310 - our own address
            return 0
    except OSError as error:
        sys.stderr.write(f"Not ready: {error}\n")
        return 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:2]))
