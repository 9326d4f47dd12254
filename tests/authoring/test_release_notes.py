"""What changes between releases, told in plain words."""

import msgspec

from authoring.releases import release_notes
from authoring.releases.release_notes import Notes, notes
from authoring.releases.release_rows import KINDS, Change
from authoring.releases.release_words import GROUPS, WORDS, groups, headlines, tell
from authoring.word_marks import Piece, word_marks
from dialogue.engine.concepts import Culture, Frame, Knowledge, Topic
from dialogue.snapshot import Snapshot
from plans.engine.intents import Intent, IntentTest, Library, Phrase, PlanSentence, Slot, ValueList

TEA = Topic(
    key="Tea",
    is_a="Topic",
    number=1,
    names={"en": {"name": "tea", "count": "no"}},
    keywords={"en": (("tea", "cuppa"), ("*",))},
    likeliness={"EN": 0.6, "IN": 0.6},
    see=("Milk",),
    frames=(Frame(key="Tea.q1", type="q", number=1, texts={"en": "Do you like $hasName?"}),),
)
MILK = Topic(key="Milk", is_a="Topic", number=2, names={"en": {"name": "milk"}})
PLAY = Intent(
    number=1,
    key="playsong",
    slots=(Slot(name="title"),),
    triggers={"en": ("play {title}", "put on {title}")},
    plan_sentences={"en": (PlanSentence(text="Here it comes."),)},
    tests={"en": (IntentTest(sentence="Play Yesterday", parameters={"title": "Yesterday"}),)},
)
INDIAN = Culture(code="IN", names={"en": "Indian", "it": "indiana"}, language="en")
replace = msgspec.structs.replace


def world(*topics: Topic, intents: tuple[Intent, ...] = (PLAY,), **more: object) -> Snapshot:
    knowledge = Knowledge(cultures=(INDIAN,), topics=topics or (TEA, MILK))
    return Snapshot(knowledge=knowledge, library=Library(intents=intents, **more))  # type: ignore[arg-type]


OLD = world()


def told(new: Snapshot, old: Snapshot = OLD) -> list[str]:
    changes = release_notes.release_notes(old, new)
    return [tell(change, {"IN": "Indian"}).words for change in changes]


def test_the_same_release_changes_nothing() -> None:
    assert release_notes.release_notes(OLD, world()) == []


def test_likeliness_is_told_with_the_name_of_the_culture() -> None:
    tea = replace(TEA, likeliness={"EN": 0.6, "IN": 0.8})
    assert told(world(tea, MILK)) == ["Tea: likeliness for Indian people 0.6 → 0.8."]


def test_a_sentence_is_told_with_its_language_and_both_texts() -> None:
    frame = replace(TEA.frames[0], texts={"en": "Do you love $hasName?"})
    (change,) = release_notes.release_notes(OLD, world(replace(TEA, frames=(frame,)), MILK))
    assert change == Change(
        "sentences",
        "Tea.q1",
        "text",
        "Do you like $hasName?",
        "Do you love $hasName?",
        "en",
        1,
    )
    shown = tell(change, {})
    assert shown.words == "Tea.q1 says in English now:"
    assert [one for one in shown.pieces if one.kind != "same"] == [
        Piece("gone", "like"),
        Piece("come", "love"),
    ]


def test_slots_and_numbers_of_new_rows_are_no_changes() -> None:
    frame = replace(TEA.frames[0], slot=7)
    assert told(world(replace(TEA, frames=(frame,)), MILK)) == []


def test_a_renamed_topic_is_not_a_new_one() -> None:
    frame = replace(TEA.frames[0], key="Chai.q1")
    chai = replace(TEA, key="Chai", frames=(frame,))
    below = replace(MILK, is_a="Chai")
    before = world(TEA, replace(MILK, is_a="Tea"))
    assert told(world(chai, below), before) == ["The topic Tea is called Chai now."]


def test_the_sentences_of_a_new_topic_are_counted_not_listed() -> None:
    cocoa = replace(TEA, key="Cocoa", number=3, frames=(replace(TEA.frames[0], number=9),))
    assert told(world(TEA, MILK, cocoa)) == [
        "New topic Cocoa below the root; sentences of its own: 1."
    ]
    assert told(OLD, world(TEA, MILK, cocoa)) == [
        "The topic Cocoa is gone; sentences of its own: 1."
    ]


def test_a_sentence_moved_to_another_topic_is_told_as_moved() -> None:
    frame = replace(TEA.frames[0], key="Milk.q1")
    new = world(replace(TEA, frames=()), replace(MILK, frames=(frame,)))
    assert told(new) == ["The sentence Milk.q1 belongs to Milk now, before to Tea."]


def test_place_links_and_order_are_told() -> None:
    moved = world(replace(TEA, see=()), replace(MILK, is_a="Tea"))
    assert told(moved) == [
        "Tea no longer leads to Milk.",
        "Milk stands below Tea now, before it stood below the root.",
    ]
    assert told(world(MILK, TEA)) == ["The topics below the root come in another order."]


def test_triggers_are_told_one_by_one() -> None:
    more = replace(PLAY, triggers={"en": ("play {title}", "put on {title}", "sing {title}")})
    assert told(world(intents=(more,))) == ["playsong: trigger added in English."]
    other = replace(PLAY, triggers={"en": ("play {title}", "put {title} on")})
    assert told(world(intents=(other,))) == ["playsong: trigger changed in English."]
    turned = replace(PLAY, triggers={"en": ("put on {title}", "play {title}")})
    assert told(world(intents=(turned,))) == ["playsong: the triggers in English in another order."]


def every_kind_of_change() -> list[Change]:
    """Return changes from each place of a knowledge base to about the opposite."""
    frame = Frame(key="Tea.q1", type="w", number=1, texts={"it": "Tè?"}, only=("IN",), scope="self")
    pool = Frame(key="start.1", type="start", number=5, texts={"en": "Hello."})
    tea = Topic(
        key="Chai",
        is_a="Milk",
        number=1,
        also=("Milk",),
        of="IN",
        gentle=True,
        stop="q",
        pattern=("q", "w"),
        variables={"en": {"unit": "a cup of"}},
        note="new",
        frames=(
            replace(frame, do="playsong title=$hasName"),
            replace(frame, number=8, key="Chai.q2"),
        ),
    )
    play = Intent(
        number=1,
        key="sing",
        family="media",
        priority=60,
        note="x",
        abilities={"en": "sing"},
        triggers={"it": ("canta",)},
        plan_sentences={"it": (PlanSentence(text="Canto."),)},
        tests={"it": (IntentTest(sentence="Canta"), IntentTest(sentence="No"))},
    )
    library = Library(
        intents=(play, replace(PLAY, number=4, key="rest")),
        phrases=(Phrase(key="please", texts={"en": "please"}),),
        values=(ValueList(key="level", values={"en": {"up": ("up",)}}),),
    )
    knowledge = Knowledge(
        cultures=(Culture(code="EN", names={"en": "English"}, language="en"),),
        topics=(replace(MILK, names={"en": {"name": "cow milk", "n": "p"}}), tea),
        pools={"start": (pool,)},
    )
    new = Snapshot(knowledge=knowledge, library=library)
    return [
        *release_notes.release_notes(None, new),
        *release_notes.release_notes(OLD, new),
        *release_notes.release_notes(new, OLD),
    ]


def test_every_change_can_be_told_and_has_a_group() -> None:
    changes = every_kind_of_change()
    assert len({(one.kind, one.what) for one in changes}) > 40
    for change in changes:
        assert "%(" not in tell(change, {}).words
    assert {one.kind for one in changes} <= set(KINDS) == set(GROUPS)


def test_all_words_can_be_filled() -> None:
    for name in WORDS:
        kind, _, what = name.partition(".")
        assert tell(Change(kind, "Tea", what, "a", "b", "en"), {}).words


def many(number: int) -> Notes:
    tea = replace(TEA, frames=())
    more = [replace(TEA, key=f"T{one}", number=one + 10, see=()) for one in range(number)]
    return notes(world(tea), world(tea, *more))


def test_many_changes_are_counted_and_some_are_shown() -> None:
    found = many(900)
    (group,) = groups(found, (), 200)
    assert (group.count, len(group.told), group.hidden, found.total) == (900, 200, 700, 900)
    assert headlines(found)[0].startswith("900 topics added: T0, T1")


def test_a_large_group_leaves_room_for_small_ones() -> None:
    shown = many(900).shown
    small = (Change("intents", "playsong", "removed"),)
    both = Notes((*shown, *small), {"topics": 900, "intents": 1}, {})
    assert [(one.kind, len(one.told)) for one in groups(both, (), 50)] == [
        ("topics", 49),
        ("intents", 1),
    ]


def test_marks_give_both_texts_back() -> None:
    for old, new in [
        ("Do you like tea?", "Do you like green tea?"),
        ("緑茶はお好きですか？", "紅茶はお好きですか？"),
        ("", "new"),
        ("old", ""),
        ("abc", "xyz"),
    ]:
        pieces = word_marks(old, new)
        assert "".join(one.text for one in pieces if one.kind != "come") == old
        assert "".join(one.text for one in pieces if one.kind != "gone") == new


def test_japanese_is_marked_letter_by_letter() -> None:
    changed = [one.text for one in word_marks("緑茶はお好きですか？", "紅茶はお好きですか？")]
    assert changed == ["緑", "紅", "茶はお好きですか？"]
