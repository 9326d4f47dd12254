"""Clients generated from docs/openapi.yaml are built and talk with a real gunicorn."""

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest
import yaml

from tests.server.conftest import ROOT, Server

pytestmark = pytest.mark.server
HERE = Path(__file__).parent
SCHEMA = ROOT / "docs" / "openapi.yaml"
GENERATOR = shutil.which("openapi-generator-cli")
ADDRESS = "http://127.0.0.1:8000"
INCLUDED = re.compile(r'#include "CppRestOpenAPIClient/(model/\w+)\.h"')
COMPILER = shutil.which("g++") or ""
with_generator = pytest.mark.skipif(
    not (GENERATOR and shutil.which("java")), reason="openapi-generator-cli or java is missing"
)


def run(*command: str, folder: Path, seconds: int = 60) -> str:
    """Run a program that must succeed; return what it printed."""
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=seconds)
    assert done.returncode == 0, (done.stdout + done.stderr)[-3000:]
    return done.stdout


def generate(language: str, folder: Path) -> Path:
    """Return the folder with a generated client."""
    command = ["openapi-generator-cli", "generate", "-i", str(SCHEMA), "-g", language]
    command += ["-o", str(folder / language)]
    run(*command, folder=folder, seconds=120)
    return folder / language


def typescript_of_the_guide(server: Server) -> str:
    guide = (ROOT / "docs" / "client-guide.md").read_text(encoding="utf-8")
    (code,) = re.findall(r"^```ts\n(.*?)^```$", guide, re.MULTILINE | re.DOTALL)
    assert ADDRESS in code
    return code.replace(ADDRESS, f"http://127.0.0.1:{server.port}")


@pytest.fixture(scope="module")
def packages(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with what npm has of the TypeScript generator."""
    if not (shutil.which("node") and shutil.which("npm")):
        pytest.skip("node or npm is not installed")
    folder = tmp_path_factory.mktemp("typescript")
    shutil.copy(HERE / "package.json", folder)
    command = ["npm", "install", "--ignore-scripts", "--no-audit", "--no-fund"]
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=120)
    except subprocess.TimeoutExpired:
        pytest.skip("npm did not come to an end in two minutes")
    if done.returncode:
        pytest.skip(f"npm could not install: {done.stderr[-300:]}")
    return folder


def test_typescript_is_checked_and_talks(server: Server, packages: Path) -> None:
    run("npx", "openapi-typescript", str(SCHEMA), "-o", "cair.d.ts", folder=packages)
    (packages / "talk.ts").write_text(typescript_of_the_guide(server), encoding="utf-8")
    kinds = ["--module", "es2022", "--moduleResolution", "bundler", "--target", "es2022"]
    run("npx", "tsc", "--strict", *kinds, "--lib", "es2022,dom", "talk.ts", folder=packages)
    said = run("node", "talk.js", folder=packages)
    assert "does: playsong { title: 'Hey Brother' }" in said
    assert len([line for line in said.splitlines() if line]) >= 4


def test_typescript_refuses_a_field_of_a_wrong_type(server: Server, packages: Path) -> None:
    run("npx", "openapi-typescript", str(SCHEMA), "-o", "cair.d.ts", folder=packages)
    wrong = typescript_of_the_guide(server).replace('"en"', "5")
    (packages / "wrong.ts").write_text(wrong, encoding="utf-8")
    kinds = ["--module", "es2022", "--moduleResolution", "bundler", "--target", "es2022"]
    command = ["npx", "tsc", "--strict", "--noEmit", *kinds, "--lib", "es2022,dom", "wrong.ts"]
    done = subprocess.run(command, cwd=packages, capture_output=True, text=True, timeout=60)
    assert "Type 'number' is not assignable to type 'string'" in done.stdout


def sources_of_the_hub(client: Path) -> list[str]:
    """Return the C++ files that the Hub's calls need; all models would take minutes."""
    wanted, found = ["api/HubApi"], set()
    while wanted:
        found.add(part := wanted.pop())
        text = (client / f"include/CppRestOpenAPIClient/{part}.h").read_text(encoding="utf-8")
        wanted += set(INCLUDED.findall(text)) - found
    files = [client / f"src/{part}.cpp" for part in found] + list(client.glob("src/*.cpp"))
    return [str(file) for file in files]


@with_generator
def test_cpp_is_compiled_and_talks(server: Server, tmp_path: Path) -> None:
    header = ["-E", "-x", "c++", "-include", "cpprest/http_client.h", os.devnull]
    if not COMPILER or subprocess.run([COMPILER, *header], capture_output=True).returncode:
        pytest.skip("g++ or libcpprest-dev is not installed")
    client = generate("cpp-restsdk", tmp_path)
    libraries = ["-lcpprest", "-lboost_system", "-lssl", "-lcrypto", "-lpthread"]
    command = [COMPILER, "-std=c++14", "-w", f"-I{client / 'include'}", str(HERE / "talk.cpp")]
    files = sources_of_the_hub(client)
    run(*command, *files, "-o", "talk", *libraries, folder=tmp_path, seconds=400)
    said = run("./talk", f"http://127.0.0.1:{server.port}", folder=tmp_path)
    assert "plan: #action=playsong title=Hey Brother\ndoes: playsong\n" in said
    assert "plan: #action=playsong title=None\ndoes: playsong\n" in said
    assert said.count("robot: ") == 3


@with_generator
def test_kotlin_has_the_turn_with_its_names_and_nulls(tmp_path: Path) -> None:
    sources = generate("kotlin", tmp_path) / "src/main/kotlin/org/openapitools/client"
    calls = (sources / "apis/HubApi.kt").read_text()
    assert re.search(r"fun hubCreate\(turn: Turn\b.*\) : Reply ", calls)
    assert re.search(r"fun hubList\(.*\) : Start ", calls)
    action = (sources / "models/Action.kt").read_text()
    assert "Map<kotlin.String, kotlin.String?>" in action
    turn = (sources / "models/Turn.kt").read_text()
    assert "val dialogueState: kotlin.String? = null" in turn


@pytest.mark.parametrize("path", ["hub", "topics", "actions", "intents", "hub/options"])
def test_the_schema_tells_what_a_get_answers(server: Server, path: str) -> None:
    told = yaml.safe_load(SCHEMA.read_text(encoding="utf-8"))["paths"][f"/api/v1/{path}/"]
    answer = server.ask("GET", f"/api/v1/{path}/")
    told_body = told["get"]["responses"][str(answer.status)]["content"]["application/json"]
    told_a_list = told_body["schema"].get("type") == "array"
    assert told_a_list == answer.body.startswith(b"[")


@pytest.mark.parametrize("path", ["hub", "plan", "dialogue", "dialogue/explain"])
def test_the_schema_tells_the_status_of_a_post(server: Server, path: str) -> None:
    told = yaml.safe_load(SCHEMA.read_text(encoding="utf-8"))["paths"][f"/api/v1/{path}/"]
    answer = server.ask("POST", f"/api/v1/{path}/", b'{"client_sentence": "Hello"}')
    good = [status for status in told["post"]["responses"] if status.startswith("2")]
    assert good == [str(answer.status)]
