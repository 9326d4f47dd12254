"""The Kubernetes manifests of an overlay as kustomize builds them, with secrets of a test."""

import shutil
import subprocess
import sys
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import yaml

from tests.deploy.files import DEPLOY, Document

FOLDER = DEPLOY / "kubernetes"
OVERLAYS = ("small", "large", "split")
WITH_SECRETS = ("small", "large")
WORKLOADS = ("Deployment", "Job")


def kustomize() -> list[str]:
    """Return the command that builds; empty where neither kustomize nor kubectl is there."""
    if shutil.which("kustomize"):
        return ["kustomize", "build"]
    return ["kubectl", "kustomize"] if shutil.which("kubectl") else []


def prepare(folder: Path) -> Path:
    """Copy the manifests and make secrets for them, as deploy/README.md says."""
    copy = folder / "kubernetes"
    shutil.copytree(FOLDER, copy, ignore=shutil.ignore_patterns("secrets"))
    for name in WITH_SECRETS:
        made = [sys.executable, str(DEPLOY / "docker" / "new_secrets.py")]
        made += [str(copy / "overlays" / name / "secrets")]
        made += ["--database-url", "postgresql://cair:pw@postgres.example/cair?sslmode=require"]
        subprocess.run(made, check=True, capture_output=True, timeout=30)
    return copy


def build(folder: Path) -> list[Document]:
    """Return what kustomize makes of a folder. Raises CalledProcessError."""
    command = [*kustomize(), str(folder)]
    done = subprocess.run(command, check=True, capture_output=True, text=True, timeout=60)
    return [document for document in yaml.safe_load_all(done.stdout) if document]


@lru_cache(None)
def built(overlay: str) -> list[Document]:
    """Return the objects of an overlay."""
    with TemporaryDirectory() as folder:
        return build(prepare(Path(folder)) / "overlays" / overlay)


def of_kind(objects: list[Document], *kinds: str) -> list[Document]:
    """Return the objects of some kinds."""
    return [one for one in objects if one["kind"] in kinds]


def name(one: Document) -> str:
    """Return the name of an object."""
    return str(one["metadata"]["name"])


def pod(workload: Document) -> dict[str, Any]:
    """Return the specification of the pods of a Deployment or a Job."""
    spec: dict[str, Any] = workload["spec"]["template"]["spec"]
    return spec


def containers(workload: Document) -> list[dict[str, Any]]:
    """Return all containers of a Deployment or a Job."""
    return [*pod(workload).get("initContainers", []), *pod(workload)["containers"]]


def labels(workload: Document) -> dict[str, str]:
    """Return the labels of the pods."""
    found: dict[str, str] = workload["spec"]["template"]["metadata"]["labels"]
    return found


def selects(selector: dict[str, Any], found: dict[str, str]) -> bool:
    """Return whether a label selector holds for labels."""
    same = all(found.get(key) == value for key, value in selector.get("matchLabels", {}).items())
    among = (
        found.get(rule["key"]) in rule["values"] for rule in selector.get("matchExpressions", [])
    )
    return same and all(among)


def environment(container: dict[str, Any], objects: list[Document]) -> dict[str, str]:
    """Return the environment of a container; its own lines stand above the ConfigMap's."""
    maps = {name(one): one["data"] for one in of_kind(objects, "ConfigMap")}
    found: dict[str, str] = {}
    for source in container.get("envFrom", []):
        found |= maps[source["configMapRef"]["name"]]
    return found | {line["name"]: line["value"] for line in container.get("env", [])}


def kustomizations() -> Iterator[tuple[Path, Document]]:
    """Yield each kustomization.yaml: its folder, what it says."""
    for path in sorted(FOLDER.rglob("kustomization.yaml")):
        yield path.parent, yaml.safe_load(path.read_text())
