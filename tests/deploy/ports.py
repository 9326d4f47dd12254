"""Ports of loopback for the tests of deploy/."""

import socket


def free_port() -> int:
    """Return a port that nobody listens at now."""
    with socket.socket() as opened:
        opened.bind(("127.0.0.1", 0))
        number: int = opened.getsockname()[1]
        return number
