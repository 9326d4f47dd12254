"""The manifests of each overlay obey Kubernetes' schemas and hold together."""

from pathlib import Path
from typing import Any

import pytest

from cair_site import urls
from tests.deploy import manifests
from tests.deploy.files import ROOT, USER, Document, is_known
from tests.deploy.manifests import (
    OVERLAYS,
    WORKLOADS,
    containers,
    environment,
    labels,
    name,
    of_kind,
    pod,
    selects,
)

pytestmark = pytest.mark.skipif(
    not manifests.kustomize(), reason="needs kustomize or kubectl, to build the manifests"
)
VERSIONS = ("1.30", "1.34")
OF_GUNICORN = {"WEB_CONCURRENCY"}
PROBES = ("startupProbe", "readinessProbe", "livenessProbe")


@pytest.fixture(params=OVERLAYS)
def objects(request: pytest.FixtureRequest) -> list[Document]:
    """Return the objects of an overlay."""
    return manifests.built(request.param)


@pytest.mark.parametrize("version", VERSIONS)
def test_they_obey_the_schemas(objects: list[Document], version: str) -> None:
    validator = pytest.importorskip("kubernetes_validate")
    for one in objects:
        validator.validate(one, version, strict=True)
    wrong = {**objects[0], "imagined": True}
    with pytest.raises(validator.ValidationError):
        validator.validate(wrong, version, strict=True)


def test_all_are_in_one_namespace_and_no_name_comes_twice(objects: list[Document]) -> None:
    assert {one["metadata"]["namespace"] for one in objects} == {"cair"}
    names = [(one["kind"], name(one)) for one in objects]
    assert len(set(names)) == len(names)


def test_every_selector_finds_the_pods_of_one_deployment(objects: list[Document]) -> None:
    deployments = of_kind(objects, "Deployment")
    pods = {name(one): labels(one) for one in of_kind(objects, *WORKLOADS)}
    selectors: list[tuple[str, dict[str, Any]]] = []
    for one in of_kind(objects, "Deployment", "PodDisruptionBudget"):
        selectors.append((name(one), one["spec"]["selector"]))
    for one in of_kind(objects, "Service"):
        if "selector" in one["spec"]:
            selectors.append((name(one), {"matchLabels": one["spec"]["selector"]}))
    for one in deployments:
        spread = pod(one)["topologySpreadConstraints"]
        selectors += [(name(one), rule["labelSelector"]) for rule in spread]
    assert len(selectors) == 5 * len(deployments)
    for owner, selector in selectors:
        assert [found for found in pods if selects(selector, pods[found])] == [owner]


def test_every_policy_of_the_network_finds_pods(objects: list[Document]) -> None:
    pods = [labels(one) for one in of_kind(objects, *WORKLOADS)]
    for policy in of_kind(objects, "NetworkPolicy"):
        spec = policy["spec"]
        sides = [spec["podSelector"]]
        for rule in [*spec.get("ingress", []), *spec.get("egress", [])]:
            for side in [*rule.get("from", []), *rule.get("to", [])]:
                sides += [side["podSelector"]] if "podSelector" in side else []
        for selector in sides:
            assert [found for found in pods if selects(selector, found)], name(policy)


def test_who_is_not_let_in_stays_out(objects: list[Document]) -> None:
    closed = [
        one
        for one in of_kind(objects, "NetworkPolicy")
        if not {"ingress", "egress"} & set(one["spec"])
    ]
    assert [one["spec"]["policyTypes"] for one in closed] == [["Ingress", "Egress"]]
    (policy,) = closed
    for one in of_kind(objects, *WORKLOADS):
        assert selects(policy["spec"]["podSelector"], labels(one))


def test_pods_have_no_rights(objects: list[Document]) -> None:
    for one in of_kind(objects, *WORKLOADS):
        assert pod(one)["automountServiceAccountToken"] is False
        assert pod(one)["enableServiceLinks"] is False
        security = pod(one)["securityContext"]
        assert security["runAsNonRoot"] is True
        assert security["runAsUser"] == security["runAsGroup"] == USER
        assert security["seccompProfile"] == {"type": "RuntimeDefault"}
        for container in containers(one):
            assert container["securityContext"] == {
                "allowPrivilegeEscalation": False,
                "readOnlyRootFilesystem": True,
                "capabilities": {"drop": ["ALL"]},
            }
            assert {"cpu", "memory"} <= set(container["resources"]["requests"])
            assert "memory" in container["resources"]["limits"]


def test_pods_can_write_where_the_server_writes(objects: list[Document]) -> None:
    for one in of_kind(objects, *WORKLOADS):
        volumes = {volume["name"]: volume for volume in pod(one)["volumes"]}
        for container in containers(one):
            mounts = {mount["mountPath"]: mount["name"] for mount in container["volumeMounts"]}
            for place in ("/tmp", "/var/lib/cair"):  # noqa: S108
                assert "emptyDir" in volumes[mounts[place]]


def test_probes_ask_addresses_that_exist(objects: list[Document]) -> None:
    known = {f"/{pattern.pattern}" for pattern in urls.urlpatterns}
    for one in of_kind(objects, "Deployment"):
        (server,) = pod(one)["containers"]
        asked = {probe: server[probe]["httpGet"]["path"] for probe in PROBES}
        assert set(asked.values()) <= known
        assert asked["readinessProbe"] == "/readyz"
        assert asked["livenessProbe"] == "/livez"
        ports = {port["name"] for port in server["ports"]}
        assert {server[probe]["httpGet"]["port"] for probe in PROBES} <= ports


def test_nothing_is_lost_while_versions_change(objects: list[Document]) -> None:
    conf = (ROOT / "cair_site" / "gunicorn_conf.py").read_text()
    graceful = int(conf.partition("\ngraceful_timeout = ")[2].partition("\n")[0])
    for one in of_kind(objects, "Deployment"):
        assert one["spec"]["strategy"]["rollingUpdate"]["maxUnavailable"] == 0
        (server,) = pod(one)["containers"]
        command, seconds = server["lifecycle"]["preStop"]["exec"]["command"]
        assert command == "sleep"
        assert pod(one)["terminationGracePeriodSeconds"] > int(seconds) + graceful
        assert pod(one)["initContainers"][0]["command"][-1] == "--wait"


def test_each_deployment_scales_and_keeps_a_pod(objects: list[Document]) -> None:
    deployments = {name(one) for one in of_kind(objects, "Deployment")}
    scaled = of_kind(objects, "HorizontalPodAutoscaler")
    assert {one["spec"]["scaleTargetRef"]["name"] for one in scaled} == deployments
    assert all(one["spec"]["minReplicas"] >= 2 for one in scaled)
    assert {name(one) for one in of_kind(objects, "PodDisruptionBudget")} == deployments
    assert not any("replicas" in one["spec"] for one in of_kind(objects, "Deployment"))


def test_servers_are_told_settings_that_exist(objects: list[Document]) -> None:
    for one in of_kind(objects, *WORKLOADS):
        for container in containers(one):
            told = set(environment(container, objects)) - OF_GUNICORN
            assert {variable for variable in told if not is_known(variable)} == set()


def test_every_file_of_a_secret_is_there_and_no_value(objects: list[Document]) -> None:
    (secret,) = of_kind(objects, "Secret")
    for one in of_kind(objects, *WORKLOADS):
        (volume,) = [volume for volume in pod(one)["volumes"] if "secret" in volume]
        assert volume["secret"]["secretName"] == name(secret)
        for container in containers(one):
            given = environment(container, objects)
            files = {value for variable, value in given.items() if variable.endswith("_FILE")}
            assert files == {f"/run/secrets/cair/{key}" for key in secret["data"]}


def test_the_doors_lead_to_services_that_exist(objects: list[Document]) -> None:
    services = {name(one): one["spec"] for one in of_kind(objects, "Service")}
    (ingress,) = of_kind(objects, "Ingress")
    (rule,) = ingress["spec"]["rules"]
    behind = {path["path"]: path["backend"]["service"]["name"] for path in rule["http"]["paths"]}
    assert set(behind.values()) <= set(services)
    assert "selector" in services[behind["/"]]
    assert "selector" not in services[behind["/metrics"]]
    (server,) = pod(_hub(objects))["containers"]
    assert rule["host"] in environment(server, objects)["CAIR_HOSTS"].split(",")
    assert environment(server, objects)["CAIR_ORIGINS"] == f"https://{rule['host']}"
    assert rule["host"] in ingress["spec"]["tls"][0]["hosts"]


def _hub(objects: list[Document]) -> Document:
    (hub,) = [
        one
        for one in of_kind(objects, "Deployment")
        if labels(one)["app.kubernetes.io/component"] == "hub"
    ]
    return hub


def test_the_hub_finds_managers_that_answer_to_their_names() -> None:
    objects = manifests.built("split")
    deployments = {name(one): one for one in of_kind(objects, "Deployment")}
    services = {name(one) for one in of_kind(objects, "Service")}
    (hub,) = pod(_hub(objects))["containers"]
    for variable, path in (
        ("CAIR_PLAN_MANAGER_URL", "plan"),
        ("CAIR_DIALOGUE_MANAGER_URL", "dialogue"),
    ):
        url = environment(hub, objects)[variable]
        host = f"cair-{path}-manager"
        assert url == f"http://{host}:8000/api/v1/{path}/"
        assert host in services
        (manager,) = pod(deployments[host])["containers"]
        told = environment(manager, objects)
        assert told["CAIR_HOSTS"] == host
        assert (told["CAIR_HTTPS"], told["CAIR_KEYS_REQUIRED"]) == ("no", "no")
        assert "CAIR_PLAN_MANAGER_URL" not in told


def test_managers_that_ask_for_a_key_get_one(tmp_path: Path) -> None:
    overlay = manifests.prepare(tmp_path) / "overlays" / "split"
    path = overlay / "kustomization.yaml"
    text = path.read_text().replace("../../split]", "../../split, ../../split/keys]")
    path.write_text(text)
    objects = manifests.build(overlay)
    for one in of_kind(objects, "Deployment"):
        (server,) = pod(one)["containers"]
        told = environment(server, objects)
        assert told["CAIR_KEYS_REQUIRED"] == "yes"
        assert ("CAIR_SERVICE_KEY_FILE" in told) is (one is _hub(objects))
