"""What the tools of ontologists say of an export: OWLAPI's OWL 2 DL profile, HermiT.

Both come with owlready2; they need a Java development kit.
"""

import shutil
import subprocess
from pathlib import Path

import owlready2
import pytest

from ontology_io.owl.names import individual_names
from tests.ontology.owl_bases import LAST, RICH
from tests.ontology.owl_export_expected import expected_rows
from tests.ontology.owl_readers import exported, read_graph, rows_of_graph

JARS = Path(owlready2.__file__).parent
PROGRAM = Path(__file__).with_name("DlProfile.java")
SECONDS = 120

pytestmark = pytest.mark.skipif(
    not shutil.which("java") or not shutil.which("javac"),
    reason="needs a Java development kit: apt-get install default-jdk-headless",
)


def java(*arguments: object) -> subprocess.CompletedProcess[str]:
    command = ["java", "-Xmx500M", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False)


def owlapi(*files: Path) -> list[str]:
    done = java("-cp", ":".join(map(str, (JARS / "pellet").glob("*.jar"))), PROGRAM, *files)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


def hermit(file: Path) -> subprocess.CompletedProcess[str]:
    jars = f"{JARS / 'hermit'}:{JARS / 'hermit' / 'HermiT.jar'}"
    return java("-cp", jars, "org.semanticweb.HermiT.cli.CommandLine", "-k", file.as_uri())


@pytest.fixture
def export(tmp_path: Path) -> Path:
    file = tmp_path / "rich.owl"
    file.write_bytes(exported(RICH, highest=LAST))
    return file


def test_an_export_is_owl_2_dl_and_owlapi_keeps_every_annotation(
    export: Path, tmp_path: Path
) -> None:
    saved = tmp_path / "saved.owl"
    lines = owlapi(export, saved)
    assert lines[0] == "format RDF/XML"
    assert [line for line in lines if line.startswith("violation")] == []
    expected = expected_rows(RICH, individual_names(RICH.knowledge))
    assert rows_of_graph(read_graph(saved.read_bytes())) == expected


def test_the_profile_notices_what_is_not_dl(export: Path, tmp_path: Path) -> None:
    broken = tmp_path / "broken.owl"
    broken.write_bytes(export.read_bytes().replace(b">0.125</", b">much</"))
    assert any(line.startswith("violation") for line in owlapi(broken))


def test_a_reasoner_finds_an_export_consistent(export: Path) -> None:
    done = hermit(export)
    assert done.returncode == 0, done.stderr
    assert "is satisfiable" in done.stdout


def test_a_reasoner_finds_a_likeliness_above_1(export: Path, tmp_path: Path) -> None:
    broken = tmp_path / "broken.owl"
    broken.write_bytes(export.read_bytes().replace(b">0.125</", b">1.7</"))
    assert "InconsistentOntologyException" in hermit(broken).stderr
