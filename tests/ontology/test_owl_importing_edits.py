"""Each edit an expert makes in Protégé appears as exactly that edit, and is in the draft then."""

import pytest
from rdflib import OWL, RDF, RDFS, Literal

from dialogue import models
from dialogue.engine.concepts import Frame, Topic
from ontology_io.importing import preview
from ontology_io.store import read_base
from tests.ontology.owl_edits import CAIR, KB, XSD_DECIMAL, Edited, brought, exported, integer, told

pytestmark = pytest.mark.usefixtures("small_draft")

DO_YOU_LIKE = Literal("Do you like $hasName?", lang="en")


def topic(key: str) -> Topic:
    return next(one for one in read_base().knowledge.topics if one.key == key)


def frame(key: str) -> Frame:
    return next(one for one in topic(key.partition(".")[0]).frames if one.key == key)


def settled(edit: Edited) -> list[tuple[str, str, str, tuple[str, ...]]]:
    """Bring an edit in; return what it changed. Twice is once, and its export changes nothing."""
    data = edit.data()
    changed = told(brought(data))
    assert not preview(data)
    assert not preview(exported())
    return changed


def test_a_changed_text() -> None:
    edit = Edited()
    number = frame("Drink.q1").number
    edit.replace(DO_YOU_LIKE, Literal("Do you enjoy $hasName?", lang="en"))
    assert settled(edit) == [
        (
            "sentences",
            "changed",
            "Drink.q1",
            ("texts en: Do you like $hasName? → Do you enjoy $hasName?",),
        )
    ]
    assert frame("Drink.q1").number == number


def test_a_changed_likeliness() -> None:
    edit = Edited()
    edit.set(KB.JP_GREENTEA, CAIR.hasLikeliness, Literal("0.95", datatype=XSD_DECIMAL))
    assert settled(edit) == [("topics", "changed", "GreenTea", ("likeliness JP: 0.7 → 0.95",))]
    assert topic("GreenTea").likeliness == {"EN": 0.4, "JP": 0.95}


def test_likeliness_is_rounded_and_told() -> None:
    edit = Edited()
    edit.set(KB.JP_GREENTEA, CAIR.hasLikeliness, Literal("0.12345", datatype=XSD_DECIMAL))
    found = brought(edit.data())
    assert [str(one) for one in found.problems] == [
        "JP_GREENTEA: Its likeliness 0.12345 is rounded to 0.123."
    ]
    assert topic("GreenTea").likeliness["JP"] == 0.123


def test_a_renamed_class_keeps_its_number_and_its_sentences() -> None:
    before, said = topic("GreenTea"), frame("GreenTea.c1")
    edit = Edited()
    edit.rename("GreenTea", "Matcha")
    assert settled(edit) == [
        ("topics", "renamed", "Matcha", ("name: GreenTea → Matcha",)),
        (
            "topics",
            "changed",
            "Matcha",
            ("individuals EN: – → EN_GREENTEA", "individuals JP: – → JP_GREENTEA"),
        ),
    ]
    assert topic("Matcha").number == before.number
    assert frame("Matcha.c1").number == said.number
    assert not models.Topic.objects.filter(key="GreenTea").exists()


def test_a_renamed_class_with_its_individuals_is_one_change() -> None:
    edit = Edited()
    for old, new in (("GreenTea", "Matcha"), ("EN_GREENTEA", "EN_MATCHA")):
        edit.rename(old, new)
    edit.rename("JP_GREENTEA", "JP_MATCHA")
    assert [one[:3] for one in settled(edit)] == [("topics", "renamed", "Matcha")]


def test_a_renamed_class_with_links_to_it() -> None:
    edit = Edited()
    edit.rename("Tea", "HotTea")
    edit.rename("EN_TEA", "EN_HOTTEA")
    edit.rename("JP_TEA", "JP_HOTTEA")
    assert [one[:3] for one in settled(edit)] == [("topics", "renamed", "HotTea")]
    assert topic("Milk").see == ("HotTea",)
    assert topic("GreenTea").is_a == "HotTea"


def test_a_renamed_individual() -> None:
    edit = Edited()
    edit.rename("EN_MILK", "EN_COW_MILK")
    assert settled(edit) == [("topics", "changed", "Milk", ("individuals EN: – → EN_COW_MILK",))]
    assert b'#EN_COW_MILK"' in exported()


def test_a_new_sentence_in_one_language() -> None:
    edit = Edited()
    edit.say("Tea", "hasPositiveSentence", Literal("Tea warms the hands.", lang="en"))
    assert settled(edit) == [
        (
            "sentences",
            "added",
            "Tea.p1",
            ("topic: Tea", "type: p", "texts en: Tea warms the hands."),
        )
    ]
    assert frame("Tea.p1").slot == -1


def test_a_new_sentence_in_three_languages_is_one_frame() -> None:
    edit = Edited()
    texts = {
        "en": "Tea warms the hands.",
        "it": "Il tè scalda le mani.",
        "ja": "お茶は温かいです。",
    }
    for code, text in texts.items():
        edit.say("Tea", "hasPositiveSentence", Literal(text, lang=code), frame=Literal("warm"))
    changed = settled(edit)
    assert [one[:3] for one in changed] == [("sentences", "added", "Tea.p1")]
    assert frame("Tea.p1").texts == texts


def test_a_new_sentence_takes_the_next_key_and_the_place_it_asks_for() -> None:
    edit = Edited()
    text = Literal("What do you like about $hasName?", lang="en")
    edit.say("Drink", "hasQuestion", text, order=integer(1))
    settled(edit)
    assert [one.key for one in topic("Drink").frames][:2] == ["Drink.q2", "Drink.q1"]


def test_a_new_sentence_on_one_individual_is_for_that_culture() -> None:
    edit = Edited()
    edit.tell("JP_MILK", "hasPositiveSentence", Literal("Milk is fine.", lang="en"))
    settled(edit)
    assert (frame("Milk.p1").only, frame("Milk.p1").scope) == (("JP",), "")


def test_on_an_individual_above_others_it_is_for_this_topic_alone() -> None:
    edit = Edited()
    for name in ("EN_TEA", "JP_TEA"):
        edit.tell(name, "hasPositiveSentence", Literal("Tea is fine.", lang="en"))
    settled(edit)
    assert (frame("Tea.p1").only, frame("Tea.p1").scope) == (("EN", "JP"), "self")


def test_a_removed_language_of_a_sentence() -> None:
    edit = Edited()
    edit.forget(DO_YOU_LIKE)
    assert settled(edit) == [
        ("sentences", "changed", "Drink.q1", ("texts en: Do you like $hasName? → –",))
    ]


def test_a_removed_sentence() -> None:
    edit = Edited()
    said = frame("Drink.q1")
    for code, text in said.texts.items():
        edit.forget(Literal(text, lang=code))
    assert [one[:3] for one in settled(edit)] == [("sentences", "removed", "Drink.q1")]
    assert not models.Frame.objects.filter(pk=said.number).exists()


def test_a_key_that_was_removed_is_not_given_to_a_new_sentence_at_once() -> None:
    edit = Edited()
    for code, text in frame("Drink.q1").texts.items():
        edit.forget(Literal(text, lang=code))
    edit.say("Drink", "hasQuestion", Literal("Are you thirsty?", lang="en"))
    assert [one[1:3] for one in settled(edit)] == [("added", "Drink.q2"), ("removed", "Drink.q1")]


def test_a_sentence_of_another_type_keeps_its_number() -> None:
    number = frame("GreenTea.c1").number
    edit = Edited()
    for text in frame("GreenTea.c1").texts.items():
        value = Literal(text[1], lang=text[0])
        edit.graph.remove((KB.JP_GREENTEA, CAIR.hasQuestionContextual, value))
        edit.add(KB.JP_GREENTEA, CAIR.hasPositiveSentence, value)
        for axiom in edit.axioms(value):
            edit.set(axiom, OWL.annotatedProperty, CAIR.hasPositiveSentence)
    assert settled(edit) == [("sentences", "changed", "GreenTea.p1", ("type: c → p",))]
    assert frame("GreenTea.p1").number == number


def test_a_sentence_moved_to_another_topic_keeps_its_number() -> None:
    said = frame("Drink.q1")
    edit = Edited()
    for code, text in said.texts.items():
        node = edit.graph.value(None, OWL.hasValue, Literal(text, lang=code))
        edit.graph.remove((KB.Drink, RDFS.subClassOf, node))
        edit.add(KB.Tea, RDFS.subClassOf, node)
        edit.set(edit.axioms(Literal(text, lang=code))[0], OWL.annotatedSource, KB.Tea)
    assert settled(edit) == [("sentences", "changed", "Tea.q1", ("topic: Drink → Tea",))]
    assert frame("Tea.q1").number == said.number


def test_an_id_that_was_copied_along_is_told_and_left_out() -> None:
    edit = Edited()
    axiom = edit.axioms(DO_YOU_LIKE)[0]
    notes = {name: edit.value(axiom, CAIR[name]) for name in ("id", "frame")}
    edit.say("Drink", "hasQuestion", Literal("Are you thirsty?", lang="en"), **notes)
    found = brought(edit.data())
    assert [one[:3] for one in told(found)] == [("sentences", "added", "Drink.q2")]
    assert any("taken as new" in one.text or "twice" in one.text for one in found.problems)
    assert frame("Drink.q1").texts["en"] == str(DO_YOU_LIKE)


def test_a_translation_joins_the_frame_it_names() -> None:
    edit = Edited()
    edit.say("Tea", "hasPositiveSentence", Literal("Tea is fine.", lang="en"))
    brought(edit.data())
    edit = Edited()
    text = Literal("Il tè va bene.", lang="it")
    edit.say("Tea", "hasPositiveSentence", text, frame=Literal("Tea.p1"))
    assert settled(edit) == [("sentences", "changed", "Tea.p1", ("texts it: – → Il tè va bene.",))]


def test_an_annotation_changed_in_one_language_is_taken_and_told() -> None:
    edit = Edited()
    text = frame("Drink.p1").texts["it"]
    edit.set(edit.axioms(Literal(text, lang="it"))[0], CAIR.scope, Literal("self"))
    found = brought(edit.data())
    assert told(found) == [("sentences", "changed", "Drink.p1", ("scope: below → self",))]
    assert "annotated differently" in found.problems[0].text


def test_the_cultures_of_a_sentence() -> None:
    edit = Edited()
    for code, text in frame("Drink.q1").texts.items():
        edit.add(edit.axioms(Literal(text, lang=code))[0], CAIR.onlyCulture, KB.CULTURE_JP)
    assert settled(edit) == [("sentences", "changed", "Drink.q1", ("only: – → JP",))]


def test_a_new_class_with_individuals() -> None:
    edit = Edited()
    edit.new_class("Cocoa", "Drink", en="cocoa", it="cacao", ja="ココア")
    edit.add(KB.Cocoa, CAIR.nameGender, Literal("m", lang="it"))
    edit.new_individual("EN_COCOA", "Cocoa", "EN", "0.8")
    edit.new_individual("JP_COCOA", "Cocoa", "JP", "0.6")
    edit.add(KB.EN_COCOA, CAIR.hasTopic, KB.EN_MILK)
    edit.add(KB.JP_COCOA, CAIR.hasTopic, KB.JP_MILK)
    changed = settled(edit)
    assert [one[:3] for one in changed] == [("topics", "added", "Cocoa")]
    cocoa = topic("Cocoa")
    assert (cocoa.likeliness, cocoa.see) == ({"EN": 0.8, "JP": 0.6}, ("Milk",))
    assert cocoa.number == 1 + max(
        one.number for one in read_base().knowledge.topics if one != cocoa
    )


def test_a_new_class_without_individuals_has_the_usual_likeliness() -> None:
    edit = Edited()
    edit.new_class("Cocoa", "Drink", en="cocoa", it="cacao", ja="ココア")
    found = brought(edit.data())
    assert topic("Cocoa").likeliness == {"EN": 0.5, "JP": 0.5}
    assert topic("Cocoa").names["it"] == {"name": "cacao", "g": "m"}
    assert any("has no gender" in one.text for one in found.problems)


def test_a_removed_individual_goes_back_to_the_usual_likeliness() -> None:
    edit = Edited()
    edit.delete("EN_GREENTEA")
    found = preview(edit.data())
    assert told(found) == [("topics", "changed", "GreenTea", ("likeliness EN: 0.4 → 0.3",))]
    assert any("goes back from 0.4 to the usual 0.3" in one.text for one in found.problems)


def test_a_removed_class() -> None:
    edit = Edited()
    for name in ("EN_FLOWER", "JP_FLOWER", "Flower"):
        edit.delete(name)
    assert [one[:3] for one in settled(edit)] == [("topics", "removed", "Flower")]
    assert not models.Topic.objects.filter(key="Flower").exists()


def test_a_moved_class_is_one_move() -> None:
    edit = Edited()
    edit.graph.remove((KB.GreenTea, RDFS.subClassOf, KB.Tea))
    edit.add(KB.GreenTea, RDFS.subClassOf, KB.Drink)
    assert settled(edit) == [("topics", "changed", "GreenTea", ("is_a: Tea → Drink",))]


def test_a_second_superclass_lends_its_sentences() -> None:
    edit = Edited()
    edit.add(KB.Milk, RDFS.subClassOf, KB.Flower)
    edit.add(KB.Milk, CAIR.treeParent, KB.Drink)
    assert settled(edit) == [("topics", "changed", "Milk", ("also: – → Flower",))]


def test_tree_parent_says_which_superclass_is_above() -> None:
    edit = Edited()
    edit.add(KB.Milk, RDFS.subClassOf, KB.Flower)
    edit.add(KB.Milk, CAIR.treeParent, KB.Flower)
    settled(edit)
    assert (topic("Milk").is_a, topic("Milk").also) == ("Flower", ("Drink",))


def test_another_order_of_siblings_moves_only_them() -> None:
    edit = Edited()
    edit.new_class("Cocoa", "Drink", en="cocoa", it="cacao", ja="ココア")
    edit.add(KB.Cocoa, CAIR.nameGender, Literal("m", lang="it"))
    brought(edit.data())
    edit = Edited()
    edit.set(KB.Cocoa, CAIR.order, integer(2))
    edit.set(KB.Milk, CAIR.order, integer(3))
    assert settled(edit) == [
        ("other", "changed", "topics below Drink", ("order: Tea Milk Cocoa → Tea Cocoa Milk",))
    ]


def test_a_link_taken_away_in_all_cultures_is_gone() -> None:
    edit = Edited()
    for code in ("EN", "JP"):
        edit.graph.remove((KB[f"{code}_GREENTEA"], CAIR.hasTopic, None))
    assert settled(edit) == [("topics", "changed", "GreenTea", ("see: Milk → –",))]


def test_a_link_taken_away_in_one_culture_stays_and_is_told() -> None:
    edit = Edited()
    edit.graph.remove((KB.EN_GREENTEA, CAIR.hasTopic, None))
    found = preview(edit.data())
    assert not found
    assert "Its link to Milk is gone in some cultures only, so it stays" in found.problems[0].text


def test_a_link_in_one_culture_is_taken_for_all() -> None:
    edit = Edited()
    edit.add(KB.EN_GREENTEA, CAIR.hasTopic, KB.EN_FLOWER)
    found = brought(edit.data())
    assert topic("GreenTea").see == ("Milk", "Flower")
    assert "it is taken for all of them" in found.problems[0].text


def test_names_keywords_notes_and_flags() -> None:
    edit = Edited()
    edit.set(KB.GreenTea, RDFS.comment, Literal("Checked twice."))
    edit.replace(Literal("green tea", lang="en"), Literal("green teas", lang="en"))
    edit.replace(Literal("verde", lang="it"), Literal("verde|sencha", lang="it"))
    edit.graph.remove((KB.GreenTea, CAIR.homeCulture, None))
    assert settled(edit) == [
        (
            "topics",
            "changed",
            "GreenTea",
            (
                "names en name: green tea → green teas",
                "keywords it: verde / ^ → verde|sencha / ^",
                "note: Checked: by Aiko → Checked twice.",
                "of: JP → –",
            ),
        )
    ]


def test_a_renamed_intent_keeps_its_number_and_its_proposals() -> None:
    number = read_base().library.intents[0].number
    edit = Edited()
    edit.rename("INTENT_playsong", "INTENT_playmusic")
    changed = settled(edit)
    assert [one[:3] for one in changed] == [
        ("intents", "renamed", "playmusic"),
        ("sentences", "changed", "Drink.g1"),
    ]
    assert read_base().library.intents[0].number == number
    assert frame("Drink.g1").do == "playmusic title=$hasName.bare"


def test_a_changed_trigger() -> None:
    edit = Edited()
    edit.replace(
        Literal("metti la canzone {title}", lang="it"), Literal("suona {title}", lang="it")
    )
    assert settled(edit) == [
        (
            "intents",
            "changed",
            "playsong",
            ("triggers it: − metti la canzone {title}", "triggers it: + suona {title}"),
        )
    ]


def test_a_removed_intent() -> None:
    edit = Edited()
    for text in frame("Drink.g1").texts.items():
        edit.forget(Literal(text[1], lang=text[0]))
    for name in {str(one)[len(KB) :] for one in edit.graph.subjects() if "INTENT_" in str(one)}:
        edit.delete(name)
    assert [one[:3] for one in settled(edit)] == [
        ("sentences", "removed", "Drink.g1"),
        ("intents", "removed", "playsong"),
    ]


def test_a_deleted_line_of_a_pool() -> None:
    edit = Edited()
    line = read_base().knowledge.pools["start"][0]
    for code, text in line.texts.items():
        for axiom in edit.axioms(Literal(text, lang=code)):
            if edit.value(axiom, OWL.annotatedSource) == KB.POOL_START:
                edit.graph.remove((axiom, None, None))
        edit.graph.remove((KB.POOL_START, CAIR.hasLine, Literal(text, lang=code)))
    assert [one[:3] for one in settled(edit)] == [("sentences", "removed", line.key)]


def test_value_lists_and_phrases() -> None:
    edit = Edited()
    edit.replace(Literal("louder|up", lang="en"), Literal("louder|up|higher", lang="en"))
    assert [one[:3] for one in settled(edit)] == [("other", "changed", "volume_level")]


def test_what_only_the_draft_has_stays_where_that_is_asked_for() -> None:
    whole = read_base()
    edit = Edited()
    for name in ("EN_FLOWER", "JP_FLOWER", "Flower", "INTENT_playsong", "POOL_START"):
        edit.delete(name)
    edit.forget(Literal(frame("Drink.p1").texts["it"], lang="it"))
    edit.set(KB.EN_MILK, CAIR.hasLikeliness, Literal("0.9", datatype=XSD_DECIMAL))
    found = brought(edit.data(), keep=True)
    assert told(found) == [("topics", "changed", "Milk", ("likeliness EN: 0.5 → 0.9",))]
    assert read_base().library == whole.library


def test_a_punned_copy_of_a_class_is_new() -> None:
    edit = Edited()
    for _, term, value in list(edit.graph.triples((KB.Milk, None, None))):
        edit.add(KB.OatMilk, term, value)
    edit.add(KB.OatMilk, RDF.type, OWL.Class)
    found = preview(edit.data())
    assert [one[:3] for one in told(found)] == [("topics", "added", "OatMilk")]


def test_an_individual_that_lost_its_class_is_told_and_leaves_nothing_behind() -> None:
    edit = Edited()
    edit.graph.remove((KB.EN_GREENTEA, RDF.type, KB.GreenTea))
    found = brought(edit.data())
    assert any(one.where == "EN_GREENTEA" for one in found.problems)
    assert topic("GreenTea").likeliness["EN"] == 0.3
    assert not preview(exported()).problems
    assert not preview(exported())
