"""The Dockerfile keeps its promises, as far as reading it can tell."""

import json
import re

from tests.deploy.files import ROOT, USER, stages
from tests.deploy.image import context

BUILD, FINAL = stages()
SECRETS = re.compile(r"secret|password|token|\bkey", re.IGNORECASE)


def _texts(stage: list[tuple[str, str]], name: str) -> list[str]:
    return [text for step, text in stage if step == name]


def test_both_stages_stand_on_the_same_base_that_can_be_given() -> None:
    assert _texts(BUILD, "FROM") == ["${BASE} AS build"]
    assert _texts(FINAL, "FROM") == ["${BASE}"]


def test_the_image_runs_as_a_user_with_a_fixed_number() -> None:
    assert _texts(FINAL, "USER") == [f"{USER}:{USER}"]
    last = [step for step, _text in FINAL].index("USER")
    assert "RUN" not in [step for step, _text in FINAL[last:]]


def test_no_compiler_comes_into_the_image() -> None:
    for text in _texts(BUILD, "RUN") + _texts(FINAL, "RUN"):
        assert not re.search(r"\b(apt|apt-get|apk|gcc|build-essential|curl|wget)\b", text)


def test_no_secret_is_set_in_the_image() -> None:
    for stage in (BUILD, FINAL):
        for text in _texts(stage, "ENV") + _texts(stage, "ARG"):
            assert not SECRETS.search(text)


def test_packages_of_tests_stay_out() -> None:
    whole = (ROOT / "requirements.txt").read_text()
    assert "sed '/^# To run the tests/,$d' requirements.txt" in _texts(BUILD, "RUN")[0]
    before, _line, after = whole.partition("\n# To run the tests")
    assert after
    assert "pytest" not in before
    assert {"Django", "gunicorn"} <= set(re.findall(r"^([\w.-]+)(?:\[.*\])?==", before, re.M))


def test_health_and_start_are_commands_without_a_shell() -> None:
    (health,) = _texts(FINAL, "HEALTHCHECK")
    words = json.loads(health.partition("CMD ")[2])
    assert words[0] == "python"
    assert (ROOT / words[1]).is_file()
    (start,) = _texts(FINAL, "CMD")
    words = json.loads(start)
    assert words[:3] == ["gunicorn", "--config", "cair_site/gunicorn_conf.py"]
    assert (ROOT / words[2]).is_file()


def test_only_the_service_gets_into_the_image() -> None:
    tops = {file.relative_to(ROOT).parts[0] for file in context()}
    assert not tops & {"tests", "benchmarks", "var", ".venv", ".git", "docs", "clients"}
    below = {file.relative_to(ROOT).parts[1] for file in context() if "deploy" in file.parts}
    assert below == {"docker"}
    importable = {path.parent.name for path in ROOT.glob("*/apps.py")}
    assert importable <= tops
    assert {"content", "static", "templates", "locale", "languages"} <= tops


def test_nothing_compiled_elsewhere_gets_into_the_image() -> None:
    assert not [file for file in context() if "__pycache__" in file.parts or file.suffix == ".pyc"]
