"""Small libraries for the tests: a robot that plays songs and talks about tea."""

from plans.engine.catalogue import Catalogue, compile_catalogue
from plans.engine.intents import (
    Intent,
    Library,
    Phrase,
    PlanSentence,
    Slot,
    ValueList,
)
from plans.engine.plan_text import parse_plan

PLAYSONG = Intent(
    number=1,
    key="playsong",
    slots=(Slot(name="title", required=True, questions={"en": "Which song?"}),),
    triggers={
        "en": ("(play|put on) [the song] {title}", "play some music"),
        "it": ("(metti|suona) {title}",),
        "ja": ("{title} を かけて",),
    },
    plan_sentences={
        "en": (
            PlanSentence(text="Let us listen to {title}."),
            PlanSentence(text="Namaste, music!", only=("IN",)),
        )
    },
    plan=parse_plan("#action=playsong title={title}"),
)
LIKES = Intent(
    number=2,
    key="likes",
    priority=40,
    slots=(Slot(name="topic", kind="topic"),),
    triggers={
        "en": ("I (love|like) {topic}",),
        "it": ("mi (piace|piacciono) {topic}", "{topic} è perché vivo"),
        "ja": ("{topic} が 好き [です]",),
    },
    plan_sentences={"en": (PlanSentence(text="So you like {topic}."),)},
    kbplan=parse_plan(
        "#action=setlikeliness topic={topic} value=1.0#action=jump topic={topic} startsentence=p"
    ),
)
VOLUME = Intent(
    number=3,
    key="volume",
    slots=(Slot(name="level", kind="value:volume_level"), Slot(name="times", kind="number")),
    triggers={
        "en": ("(talk|speak) {level} [{times} times]", "volume {times}"),
        "it": ("parla {level}",),
        "ja": ("音 を {level} して",),
    },
    plan_sentences={},
    plan=parse_plan("#action=volume level={level}"),
)
CHARGE = Intent(
    number=4,
    key="charge",
    abilities={"en": "charge my battery"},
    triggers={"en": ("go [and] charge",)},
    plan_sentences={"en": (PlanSentence(text="I go to my dock."),)},
    plan=parse_plan("#action=goto where=docking station#action=rest"),
)
ALARM = Intent(
    number=5,
    key="alarm",
    priority=100,
    triggers={"en": ("help me",)},
    plan_sentences={"en": (PlanSentence(text="Help is coming."),)},
    plan=parse_plan("#action=alert"),
)
LEVELS = ValueList(
    key="volume_level",
    values={
        "en": {"louder": ("louder", "up", "more loudly"), "quieter": ("quieter", "down")},
        "it": {"louder": ("più forte",), "quieter": ("più piano",)},
        "ja": {"louder": ("大きく",), "quieter": ("小さく",)},
    },
)
PHRASES = (
    Phrase(key="skip_start", texts={"en": "please|could you|hey robot", "it": "per favore"}),
    Phrase(key="skip_end", texts={"en": "please|thank you", "ja": "ください"}),
    Phrase(key="topic_edges", texts={"en": "the|a|very much", "it": "la|il|l'|molto"}),
    Phrase(key="not_a_topic", texts={"en": "it|you", "it": "te", "ja": "それ"}),
    Phrase(key="not_in_topic", texts={"en": "because|who", "it": "che"}),
    Phrase(key="cannot_do", texts={"en": "I am sorry, I cannot do that."}),
    Phrase(key="cannot", texts={"en": "This robot cannot {can}."}),
    Phrase(key="cannot_all", texts={"en": "Only a part of that."}),
    Phrase(key="did_you_mean", texts={"en": "Shall I {can}?"}),
    Phrase(key="cannot_alert", texts={"en": "Please call the staff."}),
)
LIBRARY = Library(
    intents=(PLAYSONG, LIKES, VOLUME, CHARGE, ALARM), values=(LEVELS,), phrases=PHRASES
)


def robot() -> Catalogue:
    return compile_catalogue(LIBRARY)
