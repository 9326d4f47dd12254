"""What must not be served does not start, and says why."""

import subprocess
import sys
from pathlib import Path

import pytest

from tests.server.conftest import ROOT, environment

pytestmark = pytest.mark.usefixtures("loopback")


def refused(var: Path, bind: str, **settings: str) -> str:
    """Return what gunicorn says when it does not start."""
    command = [sys.executable, "-m", "gunicorn", "--config", "cair_site/gunicorn_conf.py"]
    done = subprocess.run(
        [*command, "--bind", bind],
        cwd=ROOT,
        env=environment(var) | settings | {"TMPDIR": str(var)},
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
    )
    assert done.returncode != 0
    assert "Listening at" not in done.stderr
    assert not list(var.glob("cair-counts-*"))
    return done.stderr


def test_debug_pages_are_not_served_to_the_world(own_var: Path) -> None:
    assert "CAIR_DEBUG is on" in refused(own_var, "0.0.0.0:0", CAIR_DEBUG="yes")


@pytest.mark.parametrize("name", ["CAIR_SECRET_KEY", "CAIR_STATE_KEYS"])
def test_nothing_is_served_with_a_short_key(own_var: Path, name: str) -> None:
    assert name in refused(own_var, "127.0.0.1:0", **{name: "short-but-longer-than-16"})
