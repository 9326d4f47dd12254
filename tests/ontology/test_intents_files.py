"""intents.yaml: phrases, value lists and intents are read and written without loss."""

from pathlib import Path

import msgspec
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ontology_io.files.folder import folder_texts, read_folder, write_folder
from ontology_io.files.intents_files import read_library, write_library
from ontology_io.files.nodes import ContentError, Problems
from plans.engine.intents import (
    ActionItem,
    Intent,
    IntentTest,
    Library,
    Phrase,
    PlanSentence,
    Slot,
    ValueList,
)
from tests.ontology.small_content import INTENTS, write_files


def read(text: str) -> Library:
    problems = Problems("intents.yaml")
    library = read_library(text, problems)
    assert problems.found == []
    return library


def test_intents_are_written_as_they_were_read() -> None:
    assert write_library(read(INTENTS)) == INTENTS


def test_an_intent_is_read_with_all_that_it_says() -> None:
    (play,) = read(INTENTS).intents
    asked = {"en": "Which song?", "it": "Quale canzone?", "ja": "どの曲ですか？"}
    assert play.slots == (Slot(name="title", required=True, questions=asked),)
    assert play.plan == (ActionItem(action="playsong", parameters=(("title", "{title}"),)),)
    assert play.plan_sentences["en"][1] == PlanSentence(text="Here comes your song.", only=("EN",))
    assert play.tests["en"] == (
        IntentTest(sentence="Play Hey Brother", parameters={"title": "Hey Brother"}),
        IntentTest(sentence="I like tea"),
    )


def test_a_list_is_read_with_its_words() -> None:
    (volume,) = read(INTENTS).values
    assert volume.values["it"] == {"louder": ("più forte",), "quieter": ("più piano",)}


text = st.text(
    st.characters(exclude_categories=["C", "Z"], include_characters=" {}<>()|,:", max_codepoint=999)
).map(lambda found: found.strip() or "tea")
said = text.filter(lambda found: "->" not in found and "|" not in found)
name = st.from_regex(r"\A[a-z][a-z0-9_]{0,5}\Z")
tests = st.builds(
    IntentTest,
    sentence=said,
    parameters=st.none() | st.dictionaries(name, said, max_size=2),
)
lines = st.lists(text, min_size=1, max_size=2).map(tuple)
sentences = st.builds(PlanSentence, text=text, only=st.sampled_from([(), ("EN", "JP")]))


@st.composite
def libraries(draw: st.DrawFn) -> Library:
    slots = st.builds(Slot, name=name, required=st.booleans(), questions=st.just({"en": "Which?"}))
    speech = draw(lines)
    intent = Intent(
        number=0,
        key=draw(name),
        priority=draw(st.integers(0, 100)),
        slots=tuple(draw(st.lists(slots, max_size=2, unique_by=lambda slot: slot.name))),
        triggers={"en": speech},
        plan_sentences={"en": tuple(draw(st.lists(sentences, min_size=1, max_size=2)))},
        tests={"en": tuple(draw(st.lists(tests, min_size=1, max_size=2)))},
        note=draw(st.just("") | text),
    )
    synonyms = st.lists(said, max_size=2).map(tuple)
    values = draw(st.dictionaries(text, synonyms, max_size=2))
    return Library(
        phrases=(Phrase(key="please", texts={"en": draw(text)}),),
        values=(ValueList(key="colour", values={"en": values}),),
        intents=(intent,),
    )


@settings(max_examples=50)
@given(libraries())
def test_any_library_reads_as_it_was_written(library: Library) -> None:
    assert read(write_library(library)) == library


def test_each_family_has_a_file_of_its_own(tmp_path: Path) -> None:
    media = INTENTS.partition("intents:\n")[2]
    talk = media.replace("id: playsong", "id: stop")
    write_files(tmp_path, intents_media=f"intents:\n{media}", intents_talk=f"intents:\n{talk}")
    write_files(tmp_path, intents=INTENTS.partition("intents:\n")[0])
    folder = read_folder(tmp_path)
    families = [(intent.family, intent.key) for intent in folder.base.library.intents]
    assert families == [("media", "playsong"), ("talk", "stop")]
    texts = folder_texts(folder.base, folder.last)
    assert texts["intents_talk.yaml"] == f"intents:\n{talk}"


def test_the_file_of_a_family_that_is_gone_goes(tmp_path: Path) -> None:
    media = INTENTS.partition("intents:\n")[2]
    write_files(tmp_path, intents_media=f"intents:\n{media}", intents="intents: []\n")
    folder = read_folder(tmp_path)
    none = msgspec.structs.replace(folder.base, library=Library())
    assert "intents_media.yaml" in write_folder(tmp_path, none, folder.last)
    assert not (tmp_path / "intents_media.yaml").exists()


def test_phrases_in_the_file_of_a_family_are_refused(tmp_path: Path) -> None:
    write_files(tmp_path, intents_media=INTENTS.replace("playsong", "playfilm"))
    with pytest.raises(ContentError, match="Phrases and values stand in intents"):
        read_folder(tmp_path)
