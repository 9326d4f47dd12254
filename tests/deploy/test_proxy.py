"""nginx with our configuration loses no turn, lets no metrics out, writes nothing down."""

import json
import re
import socket
import ssl
import subprocess
import sys
import time
from collections.abc import Iterator
from http.client import HTTPConnection

import pytest

from tests.deploy.files import ROOT
from tests.deploy.proxy import (
    HERE,
    HOST,
    NGINX,
    Service,
    environment_of,
    kill,
    running,
    start_server,
    wait,
)

pytestmark = [
    pytest.mark.server,
    pytest.mark.skipif(NGINX is None, reason="needs nginx: apt-get install nginx-light"),
]
PLANTED = "Margherita-from-the-address-line"


@pytest.fixture(scope="module")
def service(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Service]:
    """Start two servers with the shipped content, and the proxy."""
    service = Service(tmp_path_factory.mktemp("service"))
    (service.folder / "var").mkdir()
    set_up = [sys.executable, "deploy/docker/set_up.py"]
    environment = environment_of(service.folder / "var")
    done = subprocess.run(
        set_up, cwd=ROOT, env=environment, capture_output=True, text=True, check=False, timeout=120
    )
    assert done.returncode == 0, done.stderr[-3000:]
    with running(service):
        yield service


@pytest.fixture
def one_server(service: Service) -> Iterator[Service]:
    """Let the first server be dead, and bring it back."""
    kill(service.servers[0])
    yield service
    service.servers[0] = start_server(service, 0)
    wait(service.behind[0], "/readyz")


def test_nginx_finds_no_fault_in_the_configuration(service: Service) -> None:
    test = [str(NGINX), "-t", "-c", str(service.folder / "nginx.conf")]
    said = subprocess.run(test, capture_output=True, text=True, check=False, timeout=30)
    assert "test is successful" in said.stderr
    assert "[warn]" not in said.stderr.replace('the "user" directive makes sense only', "")


def test_a_talk_goes_on_over_both_servers(service: Service) -> None:
    state = service.start()
    for _turn in range(6):
        answer, said = service.turn(state)
        assert answer.status == 200
        state = said["dialogue_state"]
    asked = {line["server"] for line in service.lines() if line["path"] == "/api/v1/hub/"}
    assert {f"{HERE}:{port}" for port in service.behind} <= asked


def test_connections_are_kept(service: Service) -> None:
    connection = service.connect()
    connection.request("GET", "/livez", headers={"Host": HOST})
    connection.getresponse().read()
    first = connection.sock
    connection.request("GET", "/livez", headers={"Host": HOST})
    assert connection.getresponse().status == 200
    assert connection.sock is first
    connection.close()


def test_plain_http_is_sent_to_https_with_its_method(service: Service) -> None:
    connection = HTTPConnection(HERE, service.plain, timeout=10)
    connection.request("POST", "/api/v1/hub/", "{}", {"Host": HOST})
    answer = connection.getresponse()
    assert answer.status == 308
    assert answer.getheader("Location") == f"https://{HOST}/api/v1/hub/"
    connection.close()


def test_pages_know_that_they_are_behind_tls(service: Service) -> None:
    answer, _page = service.ask("GET", "/admin/login/")
    assert answer.status == 200
    assert "max-age=31536000" in str(answer.getheader("Strict-Transport-Security"))
    assert "Secure" in str(answer.getheader("Set-Cookie"))


@pytest.mark.parametrize(
    "path", ["/metrics", "/metrics/", "//metrics", "/x/../metrics", "/%6detrics"]
)
def test_nobody_outside_reads_the_metrics(service: Service, path: str) -> None:
    answer, body = service.ask("GET", path)
    assert answer.status == 404
    assert b"cair_" not in body


def test_no_turn_is_lost_when_a_server_dies(one_server: Service) -> None:
    state = one_server.start()
    for _turn in range(10):
        answer, said = one_server.turn(state)
        assert answer.status == 200, said
        state = said["dialogue_state"]


def test_where_no_server_is_left_the_error_has_our_shape(service: Service) -> None:
    state = service.start()
    for server in service.servers:
        kill(server)
    try:
        answer, said = service.turn(state)
        assert answer.status == 503
        assert answer.getheader("Retry-After") == "1"
        assert set(said["error"]) == {"code", "message", "hint"}
        assert said["error"]["code"] == "service.unreachable"
    finally:
        for number in range(2):
            service.servers[number] = start_server(service, number)
        for port in service.behind:
            wait(port, "/readyz")
    until = time.monotonic() + 60
    while (status := service.turn(state)[0].status) != 200 and time.monotonic() < until:
        time.sleep(0.2)
    assert status == 200


def test_a_body_that_is_too_large_is_refused_in_our_shape(service: Service) -> None:
    answer, body = service.ask("POST", "/api/v1/hub/", b"x" * 2_000_000)
    assert answer.status == 413
    assert json.loads(body)["error"]["code"] == "body.too_large"
    answer, body = service.ask("POST", "/api/v1/hub/", b"x" * 500_000)
    assert answer.status == 413
    assert json.loads(body)["error"]["code"] == "body.too_large"


def test_ids_of_requests_go_through_if_they_are_ids(service: Service) -> None:
    state = service.start()
    for given, kept in (("robot-0001", True), ('robot"} {', False), ("x" * 100, False)):
        before = len(service.lines())
        service.turn(state, X_Request_ID=given)
        told = service.next_line(before)["id"]
        assert (told == given) is kept
        assert re.fullmatch(r"[A-Za-z0-9._-]{8,64}", told)


def test_a_slow_client_holds_no_server(service: Service) -> None:
    state = service.start()
    slow = []
    for _client in range(40):
        trust = ssl.create_default_context(cafile=str(service.folder / "tls.crt"))
        trust.check_hostname = False
        opened = trust.wrap_socket(socket.create_connection((HERE, service.tls)))
        head = f"POST /api/v1/hub/ HTTP/1.1\r\nHost: {HOST}\r\nContent-Length: 1000\r\n\r\n{{"
        opened.sendall(head.encode())
        slow.append(opened)
    try:
        assert service.turn(state)[0].status == 200
    finally:
        for opened in slow:
            opened.close()


def test_nothing_that_people_say_is_written_down(service: Service) -> None:
    state = service.start()
    body = json.dumps({"client_sentence": PLANTED, "dialogue_state": state})
    service.ask("POST", f"/api/v1/hub/?said={PLANTED}", body)
    service.ask("POST", "/api/v1/hub/", body, Cookie=PLANTED, Referer=PLANTED, User_Agent=PLANTED)
    service.ask("GET", f"/nowhere?said={PLANTED}")
    for file in service.folder.rglob("*"):
        if file.is_file() and "var" not in file.parts:
            assert PLANTED.encode() not in file.read_bytes(), file.name
