"""The published sample: brought in, published, talked to, and out again with the same facts."""

from functools import cache
from pathlib import Path

import msgspec
import pytest
from rdflib import Graph, Namespace

from dialogue import publishing
from dialogue.engine.concepts import Knowledge, Topic
from dialogue.turns import first_turn, take_turn
from ontology_io.files.folder import read_folder
from ontology_io.importing import Preview, preview
from ontology_io.records import KnowledgeBase
from ontology_io.store import read_base, write_base
from tests.ontology.owl_edits import brought, exported
from tests.site_fixtures import CONTENT

SAMPLE = Path(__file__).with_name("sample.owl")
THEIRS = Namespace("https://example.org/cair/vocab#")
OURS = Namespace("urn:cair:vocab#")


@cache
def _shipped() -> KnowledgeBase:
    return read_folder(CONTENT).base


@pytest.fixture
def sample(empty_draft: None) -> Preview:
    """Bring the sample into a draft that holds cultures, pools and phrases only."""
    shipped = _shipped()
    knowledge: Knowledge = msgspec.structs.replace(shipped.knowledge, topics=())
    library = msgspec.structs.replace(shipped.library, intents=())
    write_base(KnowledgeBase(knowledge=knowledge, library=library))
    return brought(SAMPLE.read_bytes())


def topics() -> dict[str, Topic]:
    return {topic.key: topic for topic in read_base().knowledge.topics}


def test_the_sample_says_what_it_says(sample: Preview) -> None:
    found = topics()
    assert sorted(found) == ["Coffee", "Drink", "Espresso", "GreenTea", "Milk", "Tea"]
    assert found["Espresso"].is_a == "Coffee"
    assert found["Tea"].likeliness == {"EN": 0.9, "IT": 0.4}
    assert found["Tea"].see == ("Milk",)
    assert found["Drink"].pattern == ("q r w g",)
    assert [one.key for one in read_base().library.intents] == ["appreciation", "music"]


def test_italian_names_get_their_article_and_gender(sample: Preview) -> None:
    found = topics()
    assert found["Tea"].names["it"] == {"name": "tè", "g": "m"}
    assert found["Drink"].names["it"] == {"name": "bevanda", "g": "f", "il": "bere qualcosa"}
    told = [str(one) for one in sample.problems]
    assert any("'bevanda' has no gender; 'f' is taken from its ending" in one for one in told)


def test_italian_sentences_are_said_with_our_articles(sample: Preview) -> None:
    frames = {frame.key: frame for topic in topics().values() for frame in topic.frames}
    texts = {text for frame in frames.values() for text in frame.texts.values()}
    assert "Ti piace $hasName?" in texts
    assert "Il profumo di $hasName.bare mette tutt* di buonumore, amicə mie!" in texts


def test_what_is_said_in_one_culture_stays_there(sample: Preview) -> None:
    said = {
        text: (frame.only, frame.scope, frame.do)
        for topic in topics().values()
        for frame in topic.frames
        for text in frame.texts.values()
    }
    assert said["In Italy it is taken standing at the bar."] == (("IT",), "", "")
    assert said["Shall I play some calm music for tea time?"] == (("EN",), "self", "music")


def test_what_is_not_ours_is_kept(sample: Preview) -> None:
    assert sample.unknown
    assert b"Metto un po' di musica?" in exported()


def test_the_sample_is_published_and_talked_to(sample: Preview) -> None:
    assert [one for one in sample.findings if one.error] == []
    publishing.publish(note="sample")
    content = publishing.load()
    said = first_turn(content, "en", "EN", 7)
    assert said.sentence
    taken = take_turn(content, said.state, "Let us talk about green tea")
    assert taken.reply.sentence
    taken = take_turn(content, taken.reply.state, "play the song Volare")
    assert "playsong" in taken.plan.plan


def test_the_sample_again_changes_nothing(sample: Preview) -> None:
    assert not preview(SAMPLE.read_bytes())
    assert not preview(exported())


def test_the_same_facts_come_out(sample: Preview) -> None:
    old, new = Graph(), Graph()
    old.parse(SAMPLE, format="xml")
    new.parse(data=exported(), format="xml")
    for term in ("hasLikeliness", "hasTrigger", "hasPlanSentence", "hasActionName", "hasPriority"):
        before = sorted(str(value) for value in old.objects(None, THEIRS[term]))
        assert sorted(str(value) for value in new.objects(None, OURS[term])) == before, term
