"""Files that are wrong or want to do harm: one clear sentence each, nothing touched, no waiting."""

import os
import sys
import threading
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path

import pytest

from ontology_io.owl import sandbox
from ontology_io.owl.file_records import Problem
from ontology_io.owl.limits import Limits, OwlError
from ontology_io.owl.reading import answered, read_owl
from ontology_io.owl.runner import run
from tests.ontology import hostile_owl as hostile

TYPED = "http://www.w3.org/2001/XMLSchema#"


class Listener(HTTPServer):
    calls = 0


class _Count(BaseHTTPRequestHandler):
    def do_GET(self) -> None:
        self.server.calls += 1  # type: ignore[attr-defined]
        self.send_error(404)

    def log_message(self, *_: object) -> None:
        pass


@pytest.fixture
def listener() -> Iterator[Listener]:
    server = Listener(("127.0.0.1", 0), _Count)
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    yield server
    server.shutdown()
    server.server_close()
    thread.join()


def refused(data: bytes) -> tuple[Problem, ...]:
    with pytest.raises(OwlError) as caught:
        read_owl(data)
    return caught.value.problems


def told(data: bytes) -> list[str]:
    """Return the errors that were found in the content."""
    return [str(problem) for problem in read_owl(data).problems if problem.error]


def test_no_file_makes_the_server_call_anyone(listener: Listener, tmp_path: Path) -> None:
    url = f"http://127.0.0.1:{listener.server_port}/x.owl"
    canary = tmp_path / "canary.owl"
    canary.write_bytes(hostile.document().bytes())
    os.utime(canary, (1, 1))
    before = canary.stat().st_atime_ns
    for place in (url, canary.as_uri()):
        for data in (
            hostile.changed(ontology=f'<owl:imports rdf:resource="{place}"/>'),
            hostile.with_doctype(f'[<!ENTITY a SYSTEM "{place}">]', "&a;"),
            hostile.with_doctype(f'[<!ENTITY % a SYSTEM "{place}"> %a;]'),
            hostile.with_doctype(f'SYSTEM "{place}"'),
            hostile.OWL_XML.replace("<Prefix", f"<Import>{place}</Import><Prefix", 1).encode(),
        ):
            assert len(refused(data)) == 1
        assert read_owl(hostile.changed(tea=f'<rdfs:isDefinedBy rdf:resource="{place}"/>'))
    assert listener.calls == 0
    assert canary.stat().st_atime_ns == before


def test_another_ontology_is_told_as_such() -> None:
    (problem,) = refused(hostile.PIZZA)
    assert "another ontology" in problem.text


def test_one_line_that_ends_in_a_full_stop_is_read_whole() -> None:
    data = hostile.one_line()
    assert data[:1000].split(b"\n", 1)[0].endswith(b".")
    found = read_owl(data)
    assert found.topics == read_owl(hostile.document().bytes()).topics


@pytest.mark.parametrize(
    ("added", "words"),
    [
        ({"drink": '<rdfs:subClassOf rdf:resource="urn:cair:kb#Tea"/>'}, "below itself"),
        ({"tea": '<rdfs:subClassOf rdf:resource="urn:cair:kb#Tea"/>'}, "below itself"),
        ({"tea": '<rdfs:subClassOf rdf:resource="urn:cair:kb#Gone"/>'}, "'Gone' is not in"),
        ({"tea": '<rdf:type rdf:resource="urn:cair:kb#Drink"/>'}, "class and an individual"),
        ({"tea": '<rdf:type rdf:resource="http://www.w3.org/2002/07/owl#NamedIndividual"/>'},
         "class and an individual"),
        ({"tea": "<rdfs:label xml:lang='fr'>thé</rdfs:label>"}, "unknown language 'fr'"),
        ({"tea": "<rdfs:label>tea</rdfs:label>"}, "no language tag"),
        ({"tea": "<rdfs:label xml:lang='en'>chai</rdfs:label>"}, "two values"),
        ({"tea": "<cair:order>first</cair:order>"}, "not one whole number"),
        ({"tea": '<cair:homeCulture rdf:resource="urn:cair:kb#CULTURE_XX"/>'}, "homeCulture"),
        ({"about": "<cair:scope>everywhere</cair:scope>"}, "scope 'everywhere'"),
        ({"about": '<cair:goalIntent rdf:resource="urn:cair:kb#INTENT_gone"/>'}, "goalIntent"),
        ({"about": '<cair:onlyCulture rdf:resource="urn:cair:kb#CULTURE_XX"/>'}, "onlyCulture"),
        ({"en_tea": '<cair:hasTopic rdf:resource="urn:cair:kb#EN_GONE"/>'}, "'EN_GONE'"),
        ({"en_tea": '<cair:hasCulture rdf:resource="urn:cair:kb#CULTURE_XX"/>'}, "more than one"),
        ({"en_tea": '<rdf:type rdf:resource="urn:cair:kb#Drink"/>'}, "two topics"),
        ({"en_tea": f'<cair:hasLikeliness rdf:datatype="{TYPED}decimal">0.1</cair:hasLikeliness>'},
         "more than one hasLikeliness"),
        ({"en_tea": f"<cair:hasQuestion xml:lang='en'>{'x' * 401}</cair:hasQuestion>"}, "longer"),
        ({"en_tea": "<cair:hasQuestion xml:lang='en'> </cair:hasQuestion>"}, "empty"),
        ({"en_tea": "<cair:hasQuestion xml:lang='en'>a&#x85;b</cair:hasQuestion>"}, "control"),
        ({"en_tea": "<cair:hasQuestion>Tea?</cair:hasQuestion>"}, "no language tag"),
        ({"intent": '<cair:hasPlan rdf:resource="urn:cair:kb#GONE"/>'}, "no Plan of the file"),
        ({"intent": "<cair:hasPriority>high</cair:hasPriority>"}, "not one whole number"),
        ({"ontology": "<cair:formatVersion>2</cair:formatVersion>"}, "version '2'"),
        ({"end": """<owl:NamedIndividual rdf:about="urn:cair:kb#POOL_X">
           <rdf:type rdf:resource="urn:cair:vocab#Pool"/></owl:NamedIndividual>"""},
         "pool 'x' is unknown"),
        ({"end": """<owl:Class rdf:about="urn:cair:kb#Lost"><cair:id>t7</cair:id></owl:Class>"""},
         "does not lie below Topic"),
        ({"end": """<owl:Class rdf:about="urn:cair:kb#A_B">
           <rdfs:subClassOf rdf:resource="urn:cair:vocab#Topic"/></owl:Class>"""},
         "cannot be used"),
        ({"end": """<owl:Class rdf:about="urn:other#Tea">
           <rdfs:subClassOf rdf:resource="urn:cair:vocab#Topic"/></owl:Class>"""},
         "two classes of this name"),
        ({"end": """<owl:NamedIndividual rdf:about="urn:cair:kb#EN_TEA2">
           <rdf:type rdf:resource="urn:cair:kb#Tea"/>
           <cair:hasCulture rdf:resource="urn:cair:kb#CULTURE_EN"/></owl:NamedIndividual>"""},
         "same topic and culture"),
        ({"end": """<owl:NamedIndividual rdf:about="urn:cair:kb#XX_TEA">
           <rdf:type rdf:resource="urn:cair:kb#Tea"/></owl:NamedIndividual>"""}, "no hasCulture"),
        ({"intent": """<cair:hasSlot><owl:NamedIndividual rdf:about="urn:cair:kb#S">
           <rdf:type rdf:resource="urn:cair:vocab#Slot"/></owl:NamedIndividual></cair:hasSlot>"""},
         "no hasSlotName"),
    ],
)  # fmt: skip
def test_what_is_wrong_in_the_content_is_told_at_its_place(
    added: dict[str, str], words: str
) -> None:
    errors = told(hostile.changed(**added))
    assert [error for error in errors if words in error], errors
    assert all(": " in error for error in errors)


@pytest.mark.parametrize(
    ("value", "kind", "error"),
    [
        ("1.7", "decimal", True),
        ("-0.1", "decimal", True),
        ("lots", "string", True),
        ("0.7", "string", False),
        ("0.5", "double", False),
        (" 0.7 ", "decimal", False),
        (".5", "decimal", False),
        ("1", "integer", False),
    ],
)
def test_a_likeliness_is_a_number_from_0_to_1(value: str, kind: str, *, error: bool) -> None:
    old = f'rdf:datatype="{hostile.DECIMAL}">0.9<'
    found = read_owl(hostile.replaced(old, f'rdf:datatype="{TYPED}{kind}">{value}<'))
    errors = [problem for problem in found.problems if problem.error]
    assert bool(errors) is error
    if not error:
        assert found.topics[1].individuals[0].likeliness == float(value)
        assert bool(found.problems) is (kind in ("string", "double"))


def test_several_superclasses_need_a_parent_in_the_tree() -> None:
    other = """<owl:Class rdf:about="urn:cair:kb#Plant">
      <rdfs:subClassOf rdf:resource="urn:cair:vocab#Topic"/></owl:Class>"""
    above = '<rdfs:subClassOf rdf:resource="urn:cair:kb#Plant"/>'
    assert "several superclasses" in told(hostile.changed(tea=above, end=other))[0]
    named = above + '<cair:treeParent rdf:resource="urn:cair:kb#Plant"/>'
    found = read_owl(hostile.changed(tea=named, end=other))
    tea = next(topic for topic in found.topics if topic.key == "Tea")
    assert (tea.parents, tea.tree_parent) == (("Drink", "Plant"), "Plant")
    assert not found.problems


def test_a_tree_parent_left_behind_by_a_move_is_told_and_left_out() -> None:
    stale = '<cair:treeParent rdf:resource="urn:cair:kb#Gone"/>'
    found = read_owl(hostile.changed(tea=stale))
    tea = next(topic for topic in found.topics if topic.key == "Tea")
    assert (tea.parents, tea.tree_parent) == (("Drink",), "")
    (told_,) = found.problems
    assert "treeParent" in told_.text
    assert not told_.error


def test_a_very_long_chain_of_classes_is_told_and_harms_nobody() -> None:
    links = "".join(
        f'<owl:Class rdf:about="urn:cair:kb#C{n}"><rdfs:subClassOf '
        f'rdf:resource="urn:cair:kb#{f"C{n - 1}" if n else "Tea"}"/></owl:Class>'
        for n in range(3000)
    )
    assert any("classes below Topic" in error for error in told(hostile.changed(end=links)))


def run_python(code: str, limits: Limits, *, seconds: float = 20) -> str:
    """Run code in place of the reader; return what is told."""
    program = (
        "import sys; sys.path.append(sys.argv.pop());"
        "from ontology_io.owl.limits import Limits; from ontology_io.owl import sandbox;"
        f"sandbox.confine(Limits(memory={limits.memory}, cpu={limits.cpu})); {code}"
    )
    root = str(Path(sandbox.__file__).parents[2])
    outcome = run(
        [sys.executable, "-I", "-c", program, root],
        b"x" * 1_000_000,
        seconds=seconds,
        most=limits.answer,
    )
    with pytest.raises(OwlError) as caught:
        answered(outcome, limits)
    return str(caught.value)


def test_a_reader_that_hangs_is_ended() -> None:
    assert "longer than" in run_python("import time; time.sleep(60)", Limits(), seconds=0.5)


def test_a_reader_that_waits_with_a_child_is_ended_with_it() -> None:
    code = "import os, time; os.fork(); time.sleep(60)"
    assert "longer than" in run_python(code, Limits(), seconds=1)


def test_a_reader_that_eats_memory_is_ended() -> None:
    text = run_python("x = bytearray(1 << 30)", Limits(memory=300 * 1024 * 1024))
    assert "memory" in text


def test_a_reader_that_eats_time_is_ended() -> None:
    assert "time" in run_python("exec('while True: pass')", Limits(cpu=1))


def test_a_reader_that_says_too_much_is_ended() -> None:
    code = "exec('while True: sys.stdout.write(chr(120) * 100000)')"
    assert "too much" in run_python(code, Limits(answer=1_000_000))


@pytest.mark.parametrize(
    "code",
    [
        "open('/etc/passwd')",
        "open('/tmp/x', 'w')",
        "import socket",
        "import os; os.system('true')",
        "import os; os.fork()",
        "import os; os.listdir('/')",
        "import subprocess",
        "import antigravity",
        "eval('1')",
        "import _ctypes",
    ],
)
def test_a_locked_reader_touches_nothing(code: str) -> None:
    ready = "import os, sys, json; sandbox.lock();"
    text = f"{ready}\ntry:\n    {code}\nexcept sandbox.RefusedError:\n    sys.exit(7)"
    program = (
        "import sys; sys.path.append(sys.argv.pop()); from ontology_io.owl import sandbox;"
        f"exec({text!r})"
    )
    root = str(Path(sandbox.__file__).parents[2])
    outcome = run([sys.executable, "-I", "-c", program, root], b"", seconds=20, most=1000)
    assert outcome.code == 7, outcome.errors


def test_a_file_too_large_for_its_memory_is_told() -> None:
    data = hostile.changed(
        end="".join(f'<owl:Class rdf:about="urn:cair:kb#N{n}"/>' for n in range(300_000))
    )
    with pytest.raises(OwlError) as caught:
        read_owl(data, Limits(memory=150 * 1024 * 1024))
    assert "memory" in str(caught.value)
