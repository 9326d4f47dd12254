"""Writing is canonical: what was read comes back byte by byte, what was written reads the same."""

import string

import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from dialogue.engine.concepts import Frame, Topic, usual_likeliness
from ontology_io.files.emit import flow_list, flow_map, flow_scalar, scalar
from ontology_io.files.nodes import Problems
from ontology_io.files.topics_reader import read_topics
from ontology_io.files.topics_writer import short_number, write_topics
from tests.ontology.small_content import DRINK, FLOWER

CULTURES = ("EN", "JP")
LANGUAGE_CODES = ("en", "it", "ja")
any_text = st.text(st.characters(exclude_categories=["Cs"]), min_size=0, max_size=40)
printable = st.text(st.characters(exclude_categories=["C", "Z"], include_characters=" "))
signs = st.text("-?:,[]{}#&*!|>'\"%@`\\ ~=$a茶\u3000", max_size=12)
texts = any_text | printable | signs


def read_yaml(text: str) -> object:
    return yaml.load(text, Loader=yaml.BaseLoader)  # noqa: S506 - the loader of plain texts


@given(texts)
def test_any_text_survives_as_a_block_scalar(text: str) -> None:
    assert read_yaml(f"- en: {scalar(text)}\n  it: x\n- {scalar(text)}") == [
        {"en": text, "it": "x"},
        text,
    ]


@given(texts, texts)
def test_any_text_survives_in_a_flow_map_and_a_flow_list(key: str, text: str) -> None:
    assert read_yaml(f"- {flow_map({key: text, 'end': text})}") == [{key: text, "end": text}]
    assert read_yaml(f"- {flow_list([text, key])}") == [[text, key]]


@given(printable)
def test_printable_text_is_written_on_one_line_as_it_is_seen(text: str) -> None:
    assert scalar(text).isprintable()
    assert flow_scalar(text).replace("\\", "").strip('"') == text.replace("\\", "").strip('"')


def test_only_what_yaml_would_misread_is_quoted() -> None:
    assert scalar("Do you like $hasName?") == "Do you like $hasName?"
    assert scalar("{is|are} you well?") == '"{is|are} you well?"'
    assert scalar("Listen: birds!") == '"Listen: birds!"'
    assert flow_scalar("tea, milk") == '"tea, milk"'
    assert scalar("") == '""'
    assert scalar("お茶\u2028です\u3000か") == '"お茶\\U00002028です\u3000か"'


def read(text: str) -> tuple[Topic, ...]:
    problems = Problems("drink.yaml")
    topics, _ = read_topics(text, problems, CULTURES)
    assert problems.found == []
    return topics


def write(topics: tuple[Topic, ...]) -> str:
    classes = frozenset(topic.is_a for topic in topics)
    return write_topics(topics, classes, CULTURES)


def test_a_branch_file_is_written_as_it_was_read() -> None:
    assert write(read(DRINK)) == DRINK
    assert write(read(FLOWER)) == FLOWER


def test_a_branch_with_nothing_below_it_can_be_read_again() -> None:
    rose = Topic(key="Rose", is_a="Topic", likeliness=usual_likeliness("", CULTURES))
    assert write((rose,)) == "leaves:\n- {id: Rose, is_a: Topic}\n"
    assert read(write((rose,))) == (rose,)


def test_likeliness_is_written_only_where_it_is_not_the_usual() -> None:
    (rose,) = read("leaves:\n- {id: Rose, is_a: Topic, of: EN, like: EN .7 JP .25}\n")
    assert rose.likeliness == {"EN": 0.7, "JP": 0.25}
    assert "like: JP .25" in write((rose,))
    assert [short_number(value) for value in (0, 1, 0.5, 0.125)] == ["0", "1", ".5", ".125"]


plain = printable.map(lambda text: text.strip() or "tea")
word = st.text(string.ascii_letters + " '-お茶").map(lambda text: text.strip() or "tea")
words = st.lists(word, max_size=3).map(tuple)


def spoken(values: st.SearchStrategy[object]) -> st.SearchStrategy[dict[str, object]]:
    """Return dictionaries by language, in the order of the languages."""
    found = st.dictionaries(st.sampled_from(LANGUAGE_CODES), values)
    return found.map(lambda texts: {code: texts[code] for code in sorted(texts)})


@st.composite
def frames(draw: st.DrawFn, topic: str) -> tuple[Frame, ...]:
    ids = draw(st.lists(st.from_regex(r"\A[qpnwcgte][1-9]\Z"), unique=True, max_size=3))
    return tuple(
        Frame(
            key=f"{topic}.{local}",
            type=local[0],
            texts=draw(spoken(plain)),
            only=draw(st.sampled_from([(), ("EN",), ("JP", "EN")])),
            scope=draw(st.sampled_from(["", "self", "below"])),
            do=draw(st.just("") | plain),
        )
        for local in ids
    )


@st.composite
def topics(draw: st.DrawFn) -> tuple[Topic, ...]:
    keys = draw(st.lists(st.sampled_from(["Rose", "Tulip", "Oak", "Elm"]), unique=True, min_size=1))
    made: list[Topic] = []
    for key in keys:
        home = draw(st.sampled_from(["", *CULTURES]))
        unusual = draw(st.dictionaries(st.sampled_from(CULTURES), st.integers(0, 1000)))
        values = {code: value / 1000 for code, value in unusual.items()}
        made.append(
            Topic(
                key=key,
                is_a=draw(st.sampled_from(["Topic", *keys])),
                of=home,
                gentle=draw(st.booleans()),
                stop=draw(st.sampled_from(["", "q", "qg"])),
                pattern=draw(st.sampled_from([(), ("q r w c [g]",), ("q r", "c w")])),
                variables=draw(spoken(st.dictionaries(st.just("unit"), plain, min_size=1))),
                names=draw(spoken(st.dictionaries(st.sampled_from(["name", "n"]), plain))),
                keywords=draw(spoken(st.tuples(words, words))),
                likeliness=usual_likeliness(home, CULTURES) | values,
                see=tuple(draw(st.lists(st.sampled_from(keys), unique=True))),
                note=draw(st.just("") | plain),
                frames=draw(frames(key)),
            )
        )
    return tuple(made)


@settings(max_examples=40)
@given(topics())
def test_what_is_written_reads_the_same(these: tuple[Topic, ...]) -> None:
    classes = {topic.is_a for topic in these}
    in_order = tuple(sorted(these, key=lambda topic: topic.key not in classes))
    assert read(write(in_order)) == in_order
    assert write(read(write(in_order))) == write(in_order)
