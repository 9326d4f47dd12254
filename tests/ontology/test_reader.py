"""What is wrong in a content file is said with its file and line, all problems at once."""

import time
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ontology_io.files.folder import LARGEST_FILE, read_folder
from ontology_io.files.nodes import ContentError, Problems, parse
from ontology_io.files.topics_reader import read_topics
from tests.ontology.small_content import DRINK, FLOWER, INTENTS, write_files


def problems(path: Path, **changed: str) -> list[str]:
    """Return the problems of the small folder, without the folder's name."""
    with pytest.raises(ContentError) as caught:
        read_folder(write_files(path, **changed))
    return [str(problem).partition("/")[2] for problem in caught.value.problems]


def of_flower(text: str) -> list[str]:
    """Return the problems of one file `flower.yaml`."""
    found = Problems("flower.yaml")
    read_topics(text, found, ("EN", "JP"))
    return list(map(str, found.found))


def test_the_small_content_has_no_problem(tmp_path: Path) -> None:
    assert len(read_folder(write_files(tmp_path)).base.knowledge.topics) == 5


LEAF = "leaves:\n- {id: Rose, is_a: Topic"
LINE = LEAF + "}\nlines:\n- "


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            LEAF + ", colour: red}",
            "flower.yaml:2: 'colour' is not known here; use also, en, gentle",
        ),
        (LEAF + ", of: EN, of: JP}", "flower.yaml:2: 'of' stands here twice."),
        (LEAF + "}\n- {id: Rose}", "flower.yaml:3: The topic Rose stands in this file twice."),
        ("leaves:\n\n- {is_a: Topic}", "flower.yaml:3: The id '' must be one word of letters"),
        ("leaves:\n- {id: Tea rose}", "flower.yaml:2: The id 'Tea rose' must be one word"),
        (
            "plants:\n  - {}",
            "flower.yaml:1: 'plants' is not known here; use classes, leaves, lines.",
        ),
        ("leaves: {id: Rose}", "flower.yaml:1: Write a list here, e.g. [Tea, Milk]."),
        ("leaves:\n- Rose", "flower.yaml:2: Write a mapping here, e.g. {name: tea}."),
        (LEAF + ", en: rose}", "flower.yaml:2: Write a mapping here"),
        (LEAF + ", note: [a]}", "flower.yaml:2: Write a text here, not a list or a mapping."),
        (LEAF + ", see: Tea}", "flower.yaml:2: Write a list here"),
        (LEAF + ", gentle: maybe}", "flower.yaml:2: 'maybe' must be yes or no."),
    ],
)
def test_a_wrong_shape_is_said_with_its_line(text: str, expected: str) -> None:
    assert expected in of_flower(text)[0]


@pytest.mark.parametrize(
    ("entry", "expected"),
    [
        ("like: EN 1.5", "'EN 1.5' must be cultures, each once, with values 0 to 1, e.g. IT .9"),
        ("like: EN -.5", "'EN -.5' must be cultures"),
        ("like: FR .5", "(cultures: EN JP)."),
        ("individuals: {FR: FR_ROSE}", "'FR' is not known here; use EN, JP"),
        ("individuals: {EN: 1 rose}", "'1 rose' is no name of an individual, e.g. EN_TEA."),
        ("like: EN .5 EN .7", "each once"),
        ('like: "EN .5, JP .7"', "must be cultures"),
        ("like: EN", "must be cultures"),
        ("kw: {en: rose}", "'rose' needs two sets, e.g. green / tea|chai."),
        ("kw: {en: rose / red / *}", "needs two sets"),
        ("kw: {fr: rose / *}", "'fr' is not known here; use en, it, ja."),
        ("vars: {unit: a cup}", "'unit' must be a language and a name, e.g. en.unit."),
        ("vars: {fr.unit: a cup}", "'fr.unit' must be a language and a name"),
        ("vars: {en.Unit 2: a cup}", "'en.Unit 2' must be a language and a name"),
        (f"note: {'rose ' * 401}", "This text has 2004 characters; 2000 at most."),
        (r'note: "a\x07b"', "Remove the invisible control characters of this text."),
    ],
)
def test_a_wrong_entry_of_a_topic_is_said_with_its_line(entry: str, expected: str) -> None:
    found = of_flower(f"{LEAF},\n  {entry}}}")
    assert found[0].startswith("flower.yaml:3: ")
    assert expected in found[0]


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("{at: Tulip, id: c1}", "The line is at 'Tulip', but this file has no such topic."),
        ("{at: Rose, id: Q1}", "'Q1' must be a type and a number, e.g. q1."),
        ("{at: Rose, id: q}", "'q' must be a type and a number"),
        ("{at: Rose, id: q12345}", "'q12345' must be a type and a number"),
        ("{at: Rose, id: c1, scope: above}", "'above' must be self or below."),
        ("{at: Rose, id: c1, like: EN .5}", "'like' is not known here; use at, do, en, id, it, ja"),
        ("{at: Rose, id: c1, only: EN}", "Write a list here, e.g. [Tea, Milk]."),
        (f"{{at: Rose, id: c1, en: {'a' * 401}}}", "This text has 401 characters; 400 at most."),
    ],
)
def test_a_wrong_line_is_said_with_its_line(line: str, expected: str) -> None:
    assert f"flower.yaml:4: {expected}" in of_flower(LINE + line)[0]


def test_two_lines_with_one_id_are_refused() -> None:
    twice = LINE + "{at: Rose, id: c1}\n- {at: Rose, id: c1}"
    assert of_flower(twice) == ["flower.yaml:5: The sentence Rose.c1 stands in this file twice."]


def test_a_sentence_stands_at_the_line_of_its_key() -> None:
    red = "\n      en: Red?"
    text = f"classes:\n- id: Rose\n  is_a: Topic\n  s:\n    q1:{red}\n    Q2:{red}"
    assert of_flower(text) == ["flower.yaml:7: 'Q2' must be a type and a number, e.g. q1."]


def test_a_topic_in_two_files_is_told_in_the_second(tmp_path: Path) -> None:
    assert problems(tmp_path, zoo=FLOWER) == [
        f"zoo.yaml:2: Flower stands in {tmp_path.name}/flower.yaml:2 too."
    ]


@pytest.mark.parametrize(
    ("text", "line"),
    [("leaves: [", 2), ("leaves:\n- {id: Rose", 3), ("leaves:\n\t- id: Rose", 2), ("a: b: c", 1)],
)
def test_what_is_no_yaml_is_one_problem(text: str, line: int) -> None:
    (found,) = of_flower(text + "\n")
    assert found.startswith(f"flower.yaml:{line}: This is no YAML: ")


def test_a_control_character_is_found_behind_japanese_text() -> None:
    (found,) = of_flower("leaves:\n# 花が好きです\n- {id: \x07}")
    assert found.startswith("flower.yaml:3: This is no YAML: an invisible control character")


def test_a_second_document_is_refused() -> None:
    assert of_flower("leaves: []\n---\nleaves: []") == [
        "flower.yaml:3: Write one document in a file, without --- lines."
    ]


def test_a_list_as_a_key_is_refused() -> None:
    assert of_flower("? [leaves]\n: []")[0].startswith("flower.yaml:1: Write a text here")


def test_an_empty_file_and_an_empty_section_are_no_topics() -> None:
    assert of_flower("") == of_flower("# later\n") == of_flower("leaves:\nlines:\n") == []


BILLION = "a: &a [x,x,x,x,x,x,x,x,x]\n" + "".join(
    f"{new}: &{new} [{','.join([f'*{old}'] * 9)}]\n"
    for old, new in zip("abcdefgh", "bcdefghi", strict=True)
)


@pytest.mark.parametrize(
    "text",
    [BILLION, "leaves: &x [*x]", "leaves: *x", "leaves: &x []", "leaves:\n- &x {id: Rose}\n- *x"],
)
def test_anchors_and_aliases_are_refused(text: str) -> None:
    (found,) = of_flower(text)
    assert "cannot be used; write the text out." in found


@pytest.mark.parametrize("deep", ["[" * 500_000, "{a: " * 500_000, "- " * 100_000])
def test_a_deep_file_is_refused_at_once(deep: str) -> None:
    begun = time.monotonic()
    (found,) = of_flower(f"leaves:\n {deep}")
    assert found == "flower.yaml:2: Lists and mappings stand more than 20 deep here."
    assert time.monotonic() - begun < 2


def test_a_file_of_ten_megabytes_is_refused_unread(tmp_path: Path) -> None:
    begun = time.monotonic()
    assert problems(tmp_path, flower="- a\n" * 2_500_000) == [
        f"flower.yaml:1: This file cannot be read: it is larger than {LARGEST_FILE} bytes."
    ]
    assert time.monotonic() - begun < 2


def test_a_binary_file_a_folder_and_a_missing_file_are_problems(tmp_path: Path) -> None:
    write_files(tmp_path)
    (tmp_path / "cultures.yaml").unlink()
    (tmp_path / "flower.yaml").write_bytes(b"\xff\x00\xfe")
    (tmp_path / "zoo.yaml").mkdir()
    with pytest.raises(ContentError) as caught:
        read_folder(tmp_path)
    missing, binary, folder = map(str, caught.value.problems)
    assert missing.endswith("/cultures.yaml:1: This file is missing.")
    assert "/flower.yaml:1: This file cannot be read: 'utf-8' codec" in binary
    assert "/zoo.yaml:1: This file cannot be read: " in folder


def test_no_folder_at_all_is_a_problem(tmp_path: Path) -> None:
    with pytest.raises(ContentError, match=r"nowhere/cultures\.yaml:1: This file is missing"):
        read_folder(tmp_path / "nowhere")


def test_a_file_from_windows_is_read(tmp_path: Path) -> None:
    write_files(tmp_path)
    (tmp_path / "drink.yaml").write_bytes(b"\xef\xbb\xbf" + DRINK.replace("\n", "\r\n").encode())
    assert read_folder(tmp_path) == read_folder(write_files(tmp_path))


@pytest.mark.parametrize(
    ("name", "text", "expected"),
    [
        ("cultures", "cultures:\n- {code: EN}", "2: A culture needs code, language and names."),
        ("cultures", "culture: []", "1: 'culture' is not known here; use cultures."),
        ("pools", "pools:\n- {id: hello}", "2: 'hello' is no pool; use start, welcome_back"),
        (
            "pools",
            "pools:\n- id: start\n  s:\n    a:\n      en: Hello.",
            "4: 'a' must be a number.",
        ),
        ("pools", "pools:\n- {id: end}\n- {id: end}", "3: The pool end stands in this file twice."),
        ("pools", "pool: []", "1: 'pool' is not known here; use pools."),
        ("intents", "intent: []", "1: 'intent' is not known here; use intents, phrases, values."),
        ("intents", INTENTS.replace("50", "500"), "9: The priority '500' must be a number 0 to 1"),
        ("intents", INTENTS.replace('"#act', '"act'), "13: A plan begins with '#action='"),
        ("intents", INTENTS.replace("triggers", "trigger", 1), "17: 'trigger' is not known here"),
    ],
)
def test_the_other_files_say_their_problems_too(
    tmp_path: Path, name: str, text: str, expected: str
) -> None:
    assert f"{name}.yaml:{expected}" in "\n".join(problems(tmp_path, **{name: text}))


@given(st.text(st.characters(exclude_categories=["Cs"]), max_size=60))
def test_no_text_at_all_breaks_the_reader(text: str) -> None:
    parse(text, Problems("flower.yaml"), ("leaves",))


@given(st.text("-?:,[]{}#&*!|>'\"%@`\\ \n\tab", max_size=40))
def test_no_yaml_signs_break_the_reader(text: str) -> None:
    of_flower(text)
    of_flower(f"leaves:\n- {text}")
