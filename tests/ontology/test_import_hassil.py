"""import_hassil, as it is typed."""

from io import StringIO
from pathlib import Path

import pytest
from django.core.management import CommandError, call_command

from ontology_io.files.intents_files import read_library
from ontology_io.files.nodes import Problems

LIGHTS = """\
language: en
intents:
  HassTurnOn:
    data:
      - sentences:
          - "<turn> on [the] light[s] [in [the] {area}]"
          - "(light|lamp)[s] on"
        slots:
          domain: light
        requires_context:
          area: {slot: true}
  HassSetVolume:
    data:
      - sentences: ["set volume to {volume}", "make it {step:change}"]
expansion_rules:
  turn: "(turn|switch)"
lists:
  volume:
    range: {from: 0, to: 100}
  step:
    values:
      - in: "loud[er]"
        out: up
      - quieter
skip_words: [please]
"""


def imported(folder: Path, *texts: str) -> tuple[str, str]:
    files = []
    for number, text in enumerate(texts):
        files.append(folder / f"file{number}.yaml")
        files[-1].write_text(text, "utf-8")
    output, errors = StringIO(), StringIO()
    call_command(
        "import_hassil", *map(str, files), "--language", "en", stdout=output, stderr=errors
    )
    return output.getvalue(), errors.getvalue()


def test_intents_are_printed_as_content_files_write_them(tmp_path: Path) -> None:
    output, errors = imported(tmp_path, LIGHTS)
    assert errors == ""
    problems = Problems("printed")
    library = read_library(output, problems)
    assert problems.found == []
    first, second = library.intents
    assert first.key == "hass_turn_on"
    assert first.triggers["en"] == (
        "<turn> on [the] (light|lights) [in [the] {area}]",
        "(light|lights|lamp|lamps) on",
    )
    assert "domain=light" in first.note
    assert "context" in first.note
    assert [(slot.name, slot.kind) for slot in second.slots] == [
        ("volume", "number"),
        ("change", "value:step"),
    ]
    assert library.values[0].values["en"] == {"up": ("loud", "louder"), "quieter": ("quieter",)}
    assert {phrase.key: phrase.texts["en"] for phrase in library.phrases} == {
        "skip_start": "please",
        "skip_end": "please",
        "turn": "turn|switch",
    }


def test_rules_may_stand_in_a_file_of_their_own(tmp_path: Path) -> None:
    begin = LIGHTS.index("expansion_rules:")
    output, errors = imported(tmp_path, LIGHTS[:begin], "language: en\n" + LIGHTS[begin:])
    assert errors == ""
    assert "<turn> on" in output


def test_a_template_with_an_error_is_told_with_its_file_line_and_position(tmp_path: Path) -> None:
    output, errors = imported(tmp_path, LIGHTS.replace('"(light|lamp)[s] on"', '"(light|lamp on"'))
    assert errors.startswith(
        "file0.yaml:7: HassTurnOn: Open '(' without ')' at position 0 of '(light|lamp on'"
    )
    assert "Left out: 1 templates" in errors
    assert "<turn> on" in output


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("intents: [", "file0.yaml:2: This is no YAML"),
        ("intents:\n  A:\n    sentences: [x]\n", "file0.yaml:2: Write the sentences"),
        ("language: de\nintents: {}\n", "file0.yaml:1: This file is in 'de'."),
        ("intents: &a {A: *a}\n", "file0.yaml:1: &a and *a cannot be used"),
        ("intents: {}\nlists:\n  x: {from: 1}\n", "file0.yaml:3: A list has `values`"),
        ("language: en\n", "No intents stand in"),
        ("words: {}\n", "file0.yaml:1: 'words' is not known here"),
    ],
)
def test_what_is_no_file_of_hassil_is_refused(tmp_path: Path, text: str, expected: str) -> None:
    with pytest.raises(CommandError) as caught:
        imported(tmp_path, text)
    assert expected in str(caught.value)


def test_a_file_that_is_not_there_is_told(tmp_path: Path) -> None:
    with pytest.raises(CommandError, match=r"nothing.yaml:1: It cannot be read"):
        call_command("import_hassil", str(tmp_path / "nothing.yaml"), "--language", "en")
