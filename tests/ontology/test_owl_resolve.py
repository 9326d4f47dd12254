"""What a file says, compared with a draft: ids first, then names; all of it told."""

from typing import Any

import msgspec

from dialogue.engine.concepts import Culture, Frame, Knowledge, Topic
from ontology_io.owl.file_records import Individual, OwlCulture, OwlFile, OwlIntent, OwlTopic, Said
from ontology_io.owl.resolve import Resolved, resolve
from ontology_io.records import KnowledgeBase
from plans.engine.intents import Intent, Library, Phrase

CULTURES = (
    Culture(code="EN", names={"en": "English"}, language="en"),
    Culture(code="IT", names={"en": "Italian"}, language="it"),
)
OWL_CULTURES = tuple(
    OwlCulture(code=one.code, names=one.names, language=one.language, order=place)
    for place, one in enumerate(CULTURES, 1)
)
EQUAL = {"EN": 0.5, "IT": 0.5}


def topic(key: str, number: int, is_a: str = "Topic", **more: Any) -> Topic:
    names = {"en": {"name": key.lower()}}
    return Topic(
        **{"key": key, "is_a": is_a, "number": number, "names": names}
        | {"likeliness": EQUAL}
        | more
    )


def frame(key: str, number: int, text: str, **more: Any) -> Frame:
    letter = key.partition(".")[2][0]
    return Frame(key=key, type=letter, texts={"en": text}, number=number, slot=number, **more)


def draft(*topics: Topic, **more: Any) -> KnowledgeBase:
    return KnowledgeBase(knowledge=Knowledge(cultures=CULTURES, topics=topics, **more))


def individuals(key: str, **links: tuple[str, ...]) -> tuple[Individual, ...]:
    return tuple(
        Individual(
            name=f"{code}_{key.upper()}", culture=code, likeliness=0.5, links=links.get(code, ())
        )
        for code in EQUAL
    )


def owl(key: str, *parents: str, id: str = "", **more: Any) -> OwlTopic:
    values: dict[str, Any] = {
        "names": {"en": {"name": key.lower()}},
        "individuals": individuals(key),
        **more,
    }
    return OwlTopic(key=key, parents=parents or ("Topic",), id=id, **values)


def said(text: str, **more: Any) -> Said:
    return Said(**{"type": "p", "language": "en", "text": text} | more)


def file(*topics: OwlTopic, **more: Any) -> OwlFile:
    return OwlFile(**{"iri": "urn:x", "topics": topics, "cultures": OWL_CULTURES} | more)


def topics_of(found: Resolved) -> dict[str, Topic]:
    return {one.key: one for one in found.base.knowledge.topics}


def texts(found: Resolved) -> list[str]:
    return [one.text for one in found.problems]


TEA = topic("Tea", 1, frames=(frame("Tea.p1", 1, "Tea warms."), frame("Tea.p2", 2, "Tea cools.")))


def test_another_name_with_the_same_id_is_a_renaming_only_where_something_is_shared() -> None:
    renamed = owl("Matcha", id="t1", names={"en": {"name": "tea"}}, individuals=())
    assert topics_of(resolve(file(renamed), draft(TEA)))["Matcha"].number == 1
    other = owl("Stone", id="t1")
    found = resolve(file(other), draft(TEA))
    assert topics_of(found)["Stone"].number == 0
    assert found.renamed == ()


def test_a_class_that_is_still_there_keeps_its_id_against_a_copy() -> None:
    copy = owl("Tea2", id="t1", names={"en": {"name": "tea"}})
    found = resolve(file(copy, owl("Tea", id="t1")), draft(TEA))
    assert {key: one.number for key, one in topics_of(found).items()} == {"Tea": 1, "Tea2": 0}
    assert "Its id 1 belongs to another topic, so it is new." in texts(found)


def test_numbers_come_from_ids_where_the_draft_has_no_use_for_them() -> None:
    row = owl("Milk", id="t9", said=(said("Milk.", id="f7.en", frame="Milk.p4", slot=3),))
    milk = topics_of(resolve(file(row), draft(TEA)))["Milk"]
    assert (milk.number, milk.frames[0].number, milk.frames[0].key) == (9, 7, "Milk.p4")
    assert milk.frames[0].slot == 3


def test_numbers_out_of_reach_are_not_taken() -> None:
    row = owl("Milk", id="t99999999", said=(said("Milk.", id="f999999999.en", slot=3),))
    found = resolve(file(row, highest={"topic": 10**9, "frame": 5}), draft(TEA))
    milk = topics_of(found)["Milk"]
    assert (milk.number, milk.frames[0].number, milk.frames[0].slot) == (0, 0, -1)
    assert found.last == {"frame": 5, "topic": 0}


def test_one_id_at_two_topics_stays_where_the_draft_has_it() -> None:
    tea = owl("Tea", id="t1", said=(said("Tea warms.", id="f1.en"),))
    milk = owl("Milk", said=(said("Milk warms.", id="f1.en"),))
    found = topics_of(resolve(file(milk, tea), draft(TEA)))
    assert [one.number for one in found["Tea"].frames] == [1]
    assert [one.number for one in found["Milk"].frames] == [0]


def test_what_says_different_things_in_two_cultures_becomes_two_sentences() -> None:
    kept = frame("Tea.p1", 1, "Tea warms.", only=("EN", "IT"))
    row = owl(
        "Tea",
        id="t1",
        said=(
            said("Tea warms.", id="f1.en", culture="EN"),
            said("Tea cools.", id="f1.en", culture="IT"),
        ),
    )
    found = topics_of(resolve(file(row), draft(topic("Tea", 1, frames=(kept,)))))["Tea"]
    assert [(one.number, one.only, one.texts["en"]) for one in found.frames] == [
        (1, ("EN",), "Tea warms."),
        (0, ("IT",), "Tea cools."),
    ]
    assert found.frames[1].key == "Tea.p2"


def test_sentences_without_ids_are_found_word_for_word() -> None:
    row = owl("Tea", said=(said("Tea cools."), said("Tea warms.")))
    found = topics_of(resolve(file(row), draft(TEA)))["Tea"]
    assert found.frames == TEA.frames


def test_equal_numbers_keep_the_order_of_the_draft() -> None:
    row = owl("Tea", said=(said("Tea cools.", order=1), said("Tea warms.", order=1)))
    assert topics_of(resolve(file(row), draft(TEA)))["Tea"].frames == TEA.frames


def test_a_class_dragged_elsewhere_forgets_its_old_tree_parent() -> None:
    base = draft(topic("Drink", 2), topic("Gift", 3), topic("Hot", 4))
    base = draft(*base.knowledge.topics, topic("Tea", 1, "Drink", also=("Gift",)))
    rows = (owl("Drink"), owl("Gift"), owl("Hot"))
    tea = owl("Tea", "Gift", "Hot", tree_parent="Drink")
    found = topics_of(resolve(file(*rows, tea), base))["Tea"]
    assert (found.is_a, found.also) == ("Hot", ("Gift",))


def test_of_several_superclasses_the_one_above_in_the_draft_stays_above() -> None:
    base = draft(topic("Drink", 2), topic("Gift", 3), topic("Tea", 1, "Drink"))
    rows = (owl("Drink"), owl("Gift"), owl("Tea", "Drink", "Gift"))
    found = topics_of(resolve(file(*rows), base))["Tea"]
    assert (found.is_a, found.also) == ("Drink", ("Gift",))


def test_a_new_class_with_several_superclasses_takes_the_first_and_tells() -> None:
    found = resolve(file(owl("Drink"), owl("Gift"), owl("Tea", "Drink", "Gift")), draft())
    assert topics_of(found)["Tea"].is_a == "Drink"
    assert any("several superclasses" in text for text in texts(found))


def test_keywords_of_individuals_are_joined_where_the_class_has_none() -> None:
    own = [
        msgspec.structs.replace(one, keywords={"en": ((f"tea{place}",), ())})
        for place, one in enumerate(individuals("Tea"))
    ]
    found = resolve(file(owl("Tea", individuals=tuple(own))), draft())
    assert topics_of(found)["Tea"].keywords == {"en": (("tea0", "tea1"), ("*",))}
    assert "Its keywords in en come from its individuals." in texts(found)


def test_links_follow_the_order_that_is_told_and_the_rest_comes_after() -> None:
    links = dict.fromkeys(EQUAL, ("Water", "Milk", "Sugar"))
    rows = [owl("Milk", id="t5"), owl("Sugar", id="t6"), owl("Water", id="t7")]
    tea = owl("Tea", individuals=individuals("Tea", **links), link_order=("t6", "t5"))
    found = topics_of(resolve(file(tea, *rows), draft()))["Tea"]
    assert found.see == ("Sugar", "Milk", "Water")


def test_the_lines_of_a_culture_that_is_gone_go_too() -> None:
    lines = (
        Frame(key="start.1", type="start", texts={"en": "Hello."}, number=8),
        Frame(key="start.2", type="start", texts={"en": "Ciao."}, number=9, only=("IT",)),
    )
    found = resolve(file(cultures=OWL_CULTURES[:1]), draft(pools={"start": lines}))
    assert found.base.knowledge.pools == {"start": lines[:1]}
    assert {"The file has no pools; those of the draft stay."} <= {*texts(found)}


def test_a_file_without_lists_keeps_those_of_the_draft() -> None:
    library = Library(phrases=(Phrase(key="please", texts={"en": "please"}),))
    base = KnowledgeBase(knowledge=Knowledge(cultures=CULTURES), library=library)
    assert resolve(file(), base).base.library == library
    assert resolve(file(has_lists=True), base).base.library == Library()


def test_what_the_file_lacks_is_removed_or_kept() -> None:
    base = draft(TEA, topic("Milk", 2, see=("Tea",)))
    row = owl("Matcha", id="t1", names={"en": {"name": "tea"}}, said=(said("New.", order=1),))
    assert [*topics_of(resolve(file(row), base))] == ["Matcha"]
    kept = topics_of(resolve(file(row), base, keep=True))
    assert kept["Milk"].see == ("Matcha",)
    assert [one.key for one in kept["Matcha"].frames] == ["Matcha.p3", "Matcha.p1", "Matcha.p2"]


def test_an_activity_follows_its_renamed_intent() -> None:
    intent = Intent(number=3, key="song", triggers={"en": ("sing",)}, plan_sentences={})
    proposal = frame("Tea.g1", 4, "A song?", do="song title=x y")
    base = KnowledgeBase(
        knowledge=Knowledge(cultures=CULTURES, topics=(topic("Tea", 1, frames=(proposal,)),)),
        library=Library(intents=(intent,)),
    )
    new = msgspec.structs.replace(intent, number=0, key="music")
    row = said("A song?", type="g", id="f4.en", activity="song title=x y", goal="music")
    found = resolve(file(owl("Tea", said=(row,)), intents=(OwlIntent(intent=new, id="i3"),)), base)
    assert topics_of(found)["Tea"].frames[0].do == "music title=x y"
    assert found.base.library.intents[0].number == 3
    changed = msgspec.structs.replace(row, activity="dance", goal="song")
    both = (
        OwlIntent(intent=intent),
        OwlIntent(intent=msgspec.structs.replace(intent, key="dance")),
    )
    found = resolve(file(owl("Tea", said=(changed,)), intents=both), base)
    assert topics_of(found)["Tea"].frames[0].do == "dance"


def test_what_no_row_could_hold_is_an_error() -> None:
    rows = (
        owl("Green_Tea"),
        owl("Tea", note="x" * 2001, said=(said("y" * 401),)),
    )
    found = resolve(
        file(*rows, pools={"nowhere": (said("z", type="nowhere"),)}, has_pools=True), draft()
    )
    assert {one.where for one in found.problems if one.error} == {
        "Green_Tea",
        "Tea",
        "Tea.p1",
        "nowhere",
    }


def test_a_name_with_article_is_kept_where_ours_would_say_something_else() -> None:
    def named(key: str, name: str, article: str) -> OwlTopic:
        own = Individual(
            name=f"IT_{key.upper()}", culture="IT", names={"hasNameWithArticle": {"it": article}}
        )
        return owl(key, names={"it": {"name": name}}, individuals=(own,))

    rows = (named("Gnocchi", "gnocchi", "gli gnocchi"), named("Gods", "dei", "i dei"))
    found = topics_of(resolve(file(*rows), draft()))
    assert found["Gnocchi"].names["it"] == {"name": "gnocchi", "g": "m", "n": "p"}
    assert found["Gods"].names["it"] == {"name": "dei", "g": "m", "n": "p", "il": "i dei"}


def test_a_name_that_only_other_things_have_is_not_given_to_an_individual() -> None:
    odd = Individual(name="INTENT_tea", culture="EN", likeliness=0.5)
    found = resolve(file(owl("Tea", individuals=(odd,))), draft())
    assert topics_of(found)["Tea"].individuals == {}
    assert texts(found) == ["An individual cannot be called so; it is called EN_TEA now."]
    kept = msgspec.structs.replace(odd, name="EN_CUPPA")
    found = resolve(file(owl("Tea", individuals=(kept,))), draft())
    assert topics_of(found)["Tea"].individuals == {"EN": "EN_CUPPA"}


def test_a_copied_id_gives_a_new_sentence_once() -> None:
    row = owl("Tea", said=(said("Tea warms.", id="f1.en"), said("Tea glows.", id="f1.en")))
    first = topics_of(resolve(file(row), draft(topic("Tea", 1, frames=TEA.frames[:1]))))["Tea"]
    assert [(one.number, one.key) for one in first.frames] == [(1, "Tea.p1"), (0, "Tea.p2")]
    glows = msgspec.structs.replace(first.frames[1], number=5)
    base = draft(topic("Tea", 1, frames=(first.frames[0], glows)))
    again = topics_of(resolve(file(row), base))["Tea"]
    assert [(one.number, one.key) for one in again.frames] == [(1, "Tea.p1"), (5, "Tea.p2")]
