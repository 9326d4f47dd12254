"""Knowledge bases that hold everything an ontology can say, as records."""

from msgspec.structs import replace

from dialogue.engine.concepts import Culture, Frame, Knowledge, Topic
from ontology_io.records import KnowledgeBase
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

CULTURES = (
    Culture(code="IT", names={"en": "Italian", "it": "italiana"}, language="it"),
    Culture(code="EN", names={"en": "English", "it": "inglese", "ja": "イギリス"}, language="en"),
)
LIKED = {"EN": 0.45, "IT": 1.0}


def frame(key: str, number: int, **more: object) -> Frame:
    """Return a frame in two languages."""
    kind = key.rpartition(".")[2].rstrip("0123456789") or key.partition(".")[0]
    texts = {"en": f"Said by {key} & <more>.", "it": f"Detto da {key}: così è."}
    return Frame(**{"key": key, "type": kind, "texts": texts, "number": number, **more})


def topic(key: str, is_a: str, number: int, **more: object) -> Topic:
    """Return a topic with its English name."""
    names = {"en": {"name": key.lower()}}
    return Topic(
        **{"key": key, "is_a": is_a, "number": number, "names": names, "likeliness": LIKED, **more}
    )


TOPICS = (
    topic(
        "Drink",
        "Topic",
        7,
        pattern=("q r w c [g]", "c q r"),
        stop="qg",
        variables={"en": {"unit": "a cup of", "act": "drinking"}, "it": {"unit": "una tazza di"}},
        names={"en": {"name": "drinks", "n": "p", "bare": "drink"}, "ja": {"name": "飲み物"}},
        keywords={"en": (("drink", "a beverage"), ("*",)), "ja": (("飲み物",), ("*", "何か"))},
        see=("GreenTea", "Milk"),
        note='Checked by "nurses" & others.\nTwice.',
        frames=(
            frame("Drink.q1", 20, slot=0),
            frame("Drink.p1", 21, scope="below"),
            frame("Drink.c1", 22, only=("IT",)),
            frame("Drink.c2", 23, only=("IT", "EN"), scope="self", slot=5),
            frame("Drink.g1", 24, do="playsong title=$hasName.bare"),
            frame("Drink.g2", 25, do="unheard_of what=$hasName"),
        ),
    ),
    topic("Milk", "Drink", 3, likeliness={"EN": 0.125}, individuals={"EN": "EN_WHITE"}),
    topic(
        "GreenTea",
        "Drink",
        9,
        also=("Milk", "Gift"),
        of="IT",
        see=("Milk",),
        frames=(
            frame("GreenTea.c1", 30, only=("EN",)),
            frame("GreenTea.c2", 31, only=("EN",), texts={"en": "The same words."}),
            frame("GreenTea.c3", 32, only=("EN",), texts={"en": "The same words."}),
            frame("GreenTea.w1", 33, texts={"en": "Same?"}),
            frame("GreenTea.w2", 34, texts={"en": "Same?"}, slot=1),
        ),
    ),
    topic("Greentea", "Drink", 10, individuals={"IT": "Drink"}),
    topic("Gift", "Topic", 11, gentle=True),
)
INTENTS = (
    Intent(
        number=4,
        key="playsong",
        family="media",
        priority=60,
        slots=(
            Slot(name="title", required=True, questions={"en": "Which song?", "it": "Quale?"}),
            Slot(name="level", kind="value:volume_level"),
        ),
        abilities={"en": "play a song"},
        triggers={"en": ("play {title}", "put on {title}"), "it": ("metti {title}",)},
        plan_sentences={
            "en": (
                PlanSentence(text="Here it is."),
                PlanSentence(text="Here it is.", only=("IT", "EN")),
            )
        },
        plan=(
            ActionItem(action="playsong", parameters=(("title", "{title}"), ("to", "all"))),
            ActionItem(action="wait"),
        ),
        kbplan=(ActionItem(action="jump", parameters=(("topic", "Drink"),)),),
        tests={
            "en": (
                IntentTest(sentence="play Volare", parameters={"title": "Volare", "level": "up"}),
                IntentTest(sentence="stop", parameters={}),
                IntentTest(sentence='I like "tea"'),
            )
        },
        note="The song of Mrs Smith.",
    ),
    Intent(number=2, key="empty", triggers={}, plan_sentences={}),
)
RICH = KnowledgeBase(
    knowledge=Knowledge(
        cultures=CULTURES,
        topics=TOPICS,
        pools={
            "start": (frame("start.3", 40), frame("start.1", 41, only=("EN",), slot=2)),
            "stay_or_go": (),
        },
    ),
    library=Library(
        intents=INTENTS,
        values=(
            ValueList(
                key="volume",
                values={
                    "en": {"louder": ("louder", "up"), "quieter": ("down",)},
                    "it": {"quieter": ("più piano",), "off": ("zitto",), "louder": ("su",)},
                },
            ),
            ValueList(key="volume_1", values={"en": {"one": ("one",)}}),
        ),
        phrases=(Phrase(key="kindly", texts={"en": "please|kindly", "ja": "どうか"}),),
    ),
)
LAST = {"topic": 12, "frame": 50, "intent": 4}


def with_text(text: str) -> KnowledgeBase:
    """Return the knowledge base with this text as a sentence, a name, a note and a trigger."""
    first, *rest = RICH.knowledge.topics
    said = replace(first.frames[0], texts={"en": text})
    names = {"en": {"name": text}}
    first = replace(first, note=text, names=names, frames=(said, *first.frames[1:]))
    intent = replace(INTENTS[0], triggers={"en": (text,)})
    return KnowledgeBase(
        knowledge=replace(RICH.knowledge, topics=(first, *rest)),
        library=replace(RICH.library, intents=(intent, INTENTS[1])),
    )
