"""The calls of docs/api.md work as they stand there."""

import re
import shutil
import subprocess

import pytest

from tests.server.conftest import ROOT, Server

BLOCK = re.compile(r"^```sh\n(.*?)^```$", re.MULTILINE | re.DOTALL)
ADDRESS = "http://127.0.0.1:8000"


@pytest.mark.skipif(not shutil.which("curl"), reason="curl is not installed")
def test_every_documented_call_succeeds(server: Server) -> None:
    text = (ROOT / "docs" / "api.md").read_text(encoding="utf-8")
    blocks = [
        block.replace(ADDRESS, f"http://127.0.0.1:{server.port}") for block in BLOCK.findall(text)
    ]
    assert sum(block.count("curl ") for block in blocks) > 15
    script = ["set -euo pipefail", 'curl() { command curl --fail -sS "$@"; }', *blocks]
    done = subprocess.run(  # noqa: S602 - what we wrote ourselves
        "\n".join(script), shell=True, executable="/bin/bash", capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    assert '"error"' not in done.stdout
