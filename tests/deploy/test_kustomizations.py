"""The files of deploy/kubernetes fit together, without kustomize."""

from pathlib import Path

import pytest
import yaml

from tests.deploy.files import Document, documents
from tests.deploy.manifests import FOLDER, WITH_SECRETS, kustomizations

FOUND = list(kustomizations())
NAMES = [str(folder.relative_to(FOLDER)) for folder, _says in FOUND]


def _named(says: Document) -> list[str]:
    named = [*says.get("resources", []), *says.get("components", [])]
    named += [patch["path"] for patch in says.get("patches", []) if "path" in patch]
    for generator in says.get("configMapGenerator", []):
        named += generator["envs"]
    return named


@pytest.mark.parametrize(("folder", "says"), FOUND, ids=NAMES)
def test_every_file_that_is_named_exists(folder: Path, says: Document) -> None:
    assert [name for name in _named(says) if not (folder / name).exists()] == []


@pytest.mark.parametrize(("folder", "says"), FOUND, ids=NAMES)
def test_every_file_beside_is_named(folder: Path, says: Document) -> None:
    beside = {path.name for path in folder.iterdir() if path.suffix in {".yaml", ".env"}}
    assert beside - set(_named(says)) == {"kustomization.yaml"}


@pytest.mark.parametrize(("folder", "says"), FOUND, ids=NAMES)
def test_a_patch_of_a_file_has_something_to_change(folder: Path, says: Document) -> None:
    kinds = {
        (one["kind"], container["name"])
        for path in FOLDER.rglob("*.yaml")
        for one in documents(path)
        if one["kind"] == "Deployment" and "image" in yaml.safe_dump(one)
        for container in one["spec"]["template"]["spec"]["containers"]
    }
    for patch in says.get("patches", []):
        for one in documents(folder / patch["path"]) if "path" in patch else []:
            template = one["spec"].get("template", {"spec": {"containers": []}})
            for container in template["spec"]["containers"]:
                assert (one["kind"], container["name"]) in kinds


@pytest.mark.parametrize("overlay", WITH_SECRETS)
def test_no_secret_is_in_the_repository(overlay: str) -> None:
    folder = FOLDER / "overlays" / overlay / "secrets"
    assert (folder / ".gitignore").read_text() == "*\n!.gitignore\n"
    objects = [one for path in FOLDER.rglob("*.yaml") for one in documents(path)]
    assert [one for one in objects if one["kind"] == "Secret"] == []
