"""deploy/compose holds together: the specification's schema, its walls, its order, its secrets."""

import json
import re
from pathlib import Path
from typing import Any

import pytest

from tests.deploy.files import DEPLOY, ROOT, USER, documents, is_known

FOLDER = DEPLOY / "compose"
(COMPOSE,) = documents(FOLDER / "compose.yaml")
SERVICES: dict[str, dict[str, Any]] = COMPOSE["services"]
WEB = ("web1", "web2")
OURS = (*WEB, "migrate")


def test_it_obeys_the_schema_of_the_compose_specification() -> None:
    validators = pytest.importorskip("jsonschema")
    package = pytest.importorskip("check_jsonschema")
    place = Path(package.__file__).parent / "builtin_schemas" / "vendor" / "compose-spec.json"
    schema = json.loads(place.read_text())
    validator = validators.validators.validator_for(schema)(schema)
    assert [error.message for error in validator.iter_errors(COMPOSE)] == []
    broken = {**COMPOSE, "services": {"web1": {"imagine": "cair"}}}
    assert list(validator.iter_errors(broken))


@pytest.mark.parametrize("name", SERVICES)
def test_every_container_is_walled_in(name: str) -> None:
    service = SERVICES[name]
    assert service["read_only"] is True
    assert service["cap_drop"] == ["ALL"]
    assert "cap_add" not in service
    assert service["security_opt"] == ["no-new-privileges:true"]
    assert not service.get("privileged")
    number, _colon, group = service["user"].partition(":")
    assert int(number) > 0
    assert int(group) > 0
    limits = service["deploy"]["resources"]["limits"]
    assert set(limits) == {"cpus", "memory", "pids"}


def test_the_database_is_first_then_its_tables_then_servers_then_the_proxy() -> None:
    assert SERVICES["db"]["healthcheck"]["test"][:2] == ["CMD", "pg_isready"]
    assert SERVICES["migrate"]["depends_on"] == {"db": {"condition": "service_healthy"}}
    assert SERVICES["migrate"]["command"] == ["python", "deploy/docker/set_up.py"]
    done = {"migrate": {"condition": "service_completed_successfully"}}
    assert [SERVICES[name]["depends_on"] for name in WEB] == [done, done]
    ready = {name: {"condition": "service_healthy"} for name in WEB}
    assert SERVICES["proxy"]["depends_on"] == ready


def test_only_the_proxy_is_reached_from_outside() -> None:
    assert [name for name in SERVICES if "ports" in SERVICES[name]] == ["proxy"]
    inner = {name for name, network in COMPOSE["networks"].items() if network.get("internal")}
    for name, service in SERVICES.items():
        assert set(service["networks"]) <= inner or name == "proxy"
    assert "data" not in SERVICES["proxy"]["networks"]


def test_servers_are_as_the_image_expects() -> None:
    for name in OURS:
        assert SERVICES[name]["user"] == f"{USER}:{USER}"
        places = {place.partition(":")[0] for place in SERVICES[name]["tmpfs"]}
        assert places == {"/tmp", "/var/lib/cair"}  # noqa: S108
    build = SERVICES["migrate"]["build"]
    assert (FOLDER / build["context"]).resolve() == ROOT
    assert (ROOT / build["dockerfile"]).is_file()


@pytest.mark.parametrize("name", OURS)
def test_servers_are_told_settings_that_exist(name: str) -> None:
    given = SERVICES[name]["environment"]
    assert [variable for variable in given if not is_known(variable)] == []
    assert given["CAIR_KEYS_REQUIRED"] == given["CAIR_HTTPS"] == "yes"


@pytest.mark.parametrize("name", SERVICES)
def test_secrets_are_files_and_never_values(name: str) -> None:
    secret = re.compile(r"PASSWORD|SECRET|TOKEN|KEYS?(_|$)|DATABASE_URL")
    given = SERVICES[name].get("environment", {})
    told = [variable for variable in given if secret.search(variable)]
    told = [variable for variable in told if variable != "CAIR_KEYS_REQUIRED"]
    assert all(variable.endswith("_FILE") for variable in told)
    mounted = {f"/run/secrets/{secret}" for secret in SERVICES[name].get("secrets", [])}
    assert {given[variable] for variable in told} <= mounted


def test_every_secret_is_used_and_made() -> None:
    used = {secret for service in SERVICES.values() for secret in service.get("secrets", [])}
    assert used == set(COMPOSE["secrets"])
    for name, secret in COMPOSE["secrets"].items():
        assert secret == {"file": f"./secrets/{name}"}
    assert (FOLDER / "secrets" / ".gitignore").read_text() == "*\n!.gitignore\n"


def test_every_variable_of_env_example_is_used_and_named() -> None:
    text = (FOLDER / "compose.yaml").read_text()
    used = set(re.findall(r"\$\{([A-Z_]+)", text))
    told = set(re.findall(r"^([A-Z_]+)=", (FOLDER / ".env.example").read_text(), re.M))
    assert told <= used
    assert {"DOMAIN", "IMAGE", "HTTP_PORT", "HTTPS_PORT"} <= told


def test_the_proxy_knows_the_addresses_of_the_servers() -> None:
    conf = (FOLDER / "nginx.conf").read_text()
    named = set(re.findall(r"^\s+server (\S+):8000", conf, re.M))
    addresses = {SERVICES[name]["networks"]["inside"]["ipv4_address"] for name in WEB}
    assert named == addresses
    (subnet,) = COMPOSE["networks"]["inside"]["ipam"]["config"]
    assert SERVICES["web1"]["environment"]["CAIR_TRUSTED_PROXIES"] == subnet["subnet"]
    ports = {port.rpartition(":")[2] for port in SERVICES["proxy"]["ports"]}
    assert ports == set(re.findall(r"listen (\d+)", conf))


def test_servers_end_their_turns_before_they_are_killed() -> None:
    conf = (ROOT / "cair_site" / "gunicorn_conf.py").read_text()
    graceful = int(re.findall(r"^graceful_timeout = (\d+)", conf, re.M)[0])
    assert all(int(SERVICES[name]["stop_grace_period"][:-1]) > graceful for name in WEB)
    kept = int(re.findall(r"^keepalive = (\d+)", conf, re.M)[0])
    nginx = (FOLDER / "nginx.conf").read_text()
    upstream = nginx.partition("upstream cair {")[2].partition("}")[0]
    assert int(re.findall(r"keepalive_timeout (\d+)s", upstream)[0]) < kept
