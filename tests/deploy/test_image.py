"""The image's tree serves as another user, without rights, with nothing to write but CAIR_VAR."""

import json
import subprocess
import time
from collections.abc import Iterator
from http.client import HTTPConnection
from pathlib import Path

import pytest

from tests.deploy import image
from tests.deploy.files import USER, stages
from tests.deploy.ports import free_port

pytestmark = [
    pytest.mark.server,
    pytest.mark.skipif(bool(image.missing()), reason=image.missing()),
]
SHOW = """
import os, pathlib
print(os.getuid(), [line.split()[1] for line in open('/proc/self/status') if line[:6] == 'CapEff'])
for place in ('/srv/cair', '/', '/usr', '/tmp', '/var/lib/cair'):
    try:
        (pathlib.Path(place) / 'new').write_text('x')
        print(place, 'written')
    except OSError as error:
        print(place, error.errno)
"""
READ_ONLY = 30


@pytest.fixture(scope="module")
def tree(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return /srv/cair of the image."""
    folder = tmp_path_factory.mktemp("image") / "cair"
    folder.mkdir()
    image.build(folder)
    return folder


@pytest.fixture(scope="module")
def var(tree: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return CAIR_VAR with a database that set_up.py has made."""
    folder = tmp_path_factory.mktemp("var")
    command = ["python", "deploy/docker/set_up.py"]
    code, said = image.run(tree, folder, command, image.settings())
    assert code == 0, said[-3000:]
    assert "Publication 1" in said
    return folder


@pytest.fixture(scope="module")
def port(tree: Path, var: Path) -> Iterator[int]:
    """Start what the image starts; return its port."""
    number = free_port()
    start = next(text for name, text in stages()[-1] if name == "CMD")
    words = ["python", "-m", *json.loads(start)]
    words[words.index("0.0.0.0:8000")] = f"127.0.0.1:{number}"
    with image.container(tree, var, words, image.settings()) as process:
        _wait_until_ready(process, number)
        yield number


def _wait_until_ready(process: "subprocess.Popen[str]", port: int) -> None:
    until = time.monotonic() + 120
    while time.monotonic() < until:
        assert process.poll() is None, process.stdout and process.stdout.read()
        try:
            if _ask(port, "GET", "/readyz")[0] == 200:
                return
        except OSError:
            time.sleep(0.2)
    pytest.fail("The server of the image does not get ready.")


def _ask(port: int, method: str, path: str, body: str | None = None) -> tuple[int, bytes]:
    connection = HTTPConnection("127.0.0.1", port, timeout=20)
    try:
        connection.request(method, path, body)
        answer = connection.getresponse()
        return answer.status, answer.read()
    finally:
        connection.close()


def test_the_process_has_no_rights_and_can_write_only_where_it_should(
    tree: Path, tmp_path: Path
) -> None:
    _code, said = image.run(tree, tmp_path, ["python", "-c", SHOW], image.settings())
    lines = said.splitlines()
    assert lines[0] == f"{USER} ['{'0' * 16}']"
    assert lines[1:] == [
        f"/srv/cair {READ_ONLY}",
        f"/ {READ_ONLY}",
        f"/usr {READ_ONLY}",
        "/tmp written",  # noqa: S108
        "/var/lib/cair written",
    ]


def test_the_image_holds_no_secret(tree: Path) -> None:
    assert not (tree / "var").exists()
    assert not [file for file in tree.rglob("*_key") if file.is_file()]


def test_a_second_set_up_changes_nothing(tree: Path, var: Path) -> None:
    command = ["python", "deploy/docker/set_up.py"]
    code, said = image.run(tree, var, command, image.settings())
    assert code == 0
    assert "Publication" not in said


def test_who_waits_goes_on_once_the_database_is_set_up(tree: Path, var: Path) -> None:
    command = ["python", "deploy/docker/set_up.py", "--wait"]
    assert image.run(tree, var, command, image.settings()) == (0, "")


def test_who_waits_in_vain_says_so(tree: Path, tmp_path: Path) -> None:
    command = ["python", "deploy/docker/set_up.py", "--wait", "--seconds", "0.1"]
    code, said = image.run(tree, tmp_path, command, image.settings())
    assert (code, "Waiting for the database" in said) == (1, True)


def test_people_talk_with_the_image(port: int) -> None:
    status, body = _ask(port, "GET", "/api/v1/hub/?language=en&culture=EN")
    assert status == 200
    state = json.loads(body)["dialogue_state"]
    turn = json.dumps({"client_sentence": "I love dogs", "dialogue_state": state})
    status, body = _ask(port, "POST", "/api/v1/hub/", turn)
    assert status == 200
    assert json.loads(body)["dialogue_sentence"]


def test_the_chat_finds_its_static_files(port: int) -> None:
    status, page = _ask(port, "GET", "/")
    assert status == 200
    sources = [part.split('"')[0] for part in page.decode().split('src="')[1:]]
    assert sources
    assert [_ask(port, "GET", source)[0] for source in sources] == [200] * len(sources)


def test_health_is_told_from_outside_and_inside(tree: Path, var: Path, port: int) -> None:
    command = ["python", "deploy/docker/health.py"]
    here = f"http://127.0.0.1:{port}/readyz"
    assert image.run(tree, var, [*command, here], image.settings()) == (0, "")
    nobody = f"http://127.0.0.1:{free_port()}/readyz"
    code, said = image.run(tree, var, [*command, nobody], image.settings())
    assert (code, said[:9]) == (1, "Not ready")
