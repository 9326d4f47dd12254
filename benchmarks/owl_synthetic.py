"""A made-up knowledge base of any size, the same each time, without a database.

It is what experts could have written: numbered, every sentence in three languages, links, class
variables, sentences kept for one culture, intents with slots, plans and tests.
"""

from random import Random

from dialogue.engine.concepts import ROOT, Culture, Frame, Knowledge, Topic
from dialogue.engine.pools import POOLS
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

TOPICS, ROWS, INTENTS = 3000, 24_000, 300
LANGUAGES = ("en", "it", "ja")
CULTURES = (
    Culture(code="EN", names={"en": "English", "it": "inglese", "ja": "イギリス"}, language="en"),
    Culture(code="IT", names={"en": "Italian", "it": "italiana", "ja": "イタリア"}, language="it"),
    Culture(code="JP", names={"en": "Japanese", "it": "giapponese", "ja": "日本"}, language="ja"),
    Culture(code="IN", names={"en": "Indian", "it": "indiana", "ja": "インド"}, language="en"),
)
WIDTH = 12
_SAID = {
    "q": (
        "Do you enjoy $hasName {n} when the day is long?",
        "Ti piace $hasName {n} quando la giornata è lunga?",
        "一日が長いとき、$hasName{n}はお好きですか？",
    ),
    "c": (
        "Many people tell each other stories about $hasName {n} & laugh.",
        "Molti si raccontano storie su $hasName {n} e ridono.",
        "$hasName{n}の話をして笑い合う人が多いですね。",
    ),
    "w": (
        "What comes to your mind when you think of $hasName {n}?",
        "Che cosa ti viene in mente quando pensi a $hasName {n}?",
        "$hasName{n}と聞いて、何を思い出しますか？",
    ),
    "g": (
        "Shall I play a song about $hasName {n}?",
        "Vuoi sentire una canzone su $hasName {n}?",
        "$hasName{n}の歌をおかけしましょうか？",
    ),
    "p": (
        "I see why you like $hasName {n}, it is a good choice.",
        "Capisco perché ti piace $hasName {n}, è una bella scelta.",
        "$hasName{n}がお好きなのは、よくわかります。",
    ),
}


def synthetic(topics: int = TOPICS, rows: int = ROWS, intents: int = INTENTS) -> KnowledgeBase:
    """Return a knowledge base with so many topics, texts of topics, and intents."""
    random = Random(7)
    frames = rows // len(LANGUAGES)
    made: list[Topic] = []
    for place in range(topics):
        parent = made[(place - WIDTH) // WIDTH] if place >= WIDTH else None
        # As many for each topic as can be: the numbers of its frames.
        numbers = range(place * frames // topics + 1, (place + 1) * frames // topics + 1)
        made.append(_topic(place, parent, numbers, random))
    return KnowledgeBase(
        knowledge=Knowledge(cultures=CULTURES, topics=_in_tree(made), pools=_pools(frames)),
        library=_library(intents),
    )


def highest(base: KnowledgeBase) -> dict[str, int]:
    """Return the highest number of each kind."""
    frames = [frame for topic in base.knowledge.topics for frame in topic.frames]
    for pool in base.knowledge.pools.values():
        frames += pool
    return {
        "topic": max(topic.number for topic in base.knowledge.topics),
        "frame": max(frame.number for frame in frames),
        "intent": max((one.number for one in base.library.intents), default=0),
    }


def _topic(place: int, parent: Topic | None, numbers: range, random: Random) -> Topic:
    key = f"Thing{place + 1}"
    of = random.choices(("", "IT", "JP"), weights=(8, 1, 1))[0]
    codes = tuple(culture.code for culture in CULTURES)
    return Topic(
        key=key,
        is_a=parent.key if parent else ROOT,
        number=place + 1,
        of=of,
        gentle=random.random() < 0.01,
        pattern=("q r w c [g]", "c q r w") if parent is None else (),
        variables={"en": {"unit": "a cup of"}, "it": {"unit": "una tazza di"}}
        if place % 20 == 0
        else {},
        names={
            "en": {"name": f"thing {place + 1}"},
            "it": {"name": f"cosa {place + 1}", "g": "f"},
            "ja": {"name": f"物{place + 1}", "kana": "もの"},
        },
        keywords={
            "en": ((f"thing {place + 1}", f"item {place + 1}"), ("*",)),
            "it": ((f"cosa {place + 1}", f"oggetto {place + 1}"), ("*",)),
            "ja": ((f"物{place + 1}",), ("*",)),
        },
        likeliness={code: random.randrange(0, 1001, 5) / 1000 for code in codes},
        see=(parent.key,) if parent and random.random() < 0.5 else (),
        note="Checked by the nurses." if place % 50 == 0 else "",
        frames=_said(key, parent, numbers, random),
    )


def _said(key: str, parent: Topic | None, numbers: range, random: Random) -> tuple[Frame, ...]:
    first = max((frame.slot for frame in parent.frames), default=-1) + 1 if parent else 0
    types = list(_SAID)
    frames = []
    for place, number in enumerate(numbers):
        letter = types[number % len(types)]
        frames.append(
            Frame(
                key=f"{key}.{letter}{place + 1}",
                type=letter,
                texts={
                    code: text.replace("{n}", str(place + 1))
                    for code, text in zip(LANGUAGES, _SAID[letter], strict=True)
                },
                number=number,
                slot=first + place,
                only=("JP",) if random.random() < 0.1 else (),
                do="intent_1 title=$hasName" if letter == "g" else "",
            )
        )
    return tuple(frames)


def _in_tree(topics: list[Topic]) -> tuple[Topic, ...]:
    """Return the topics with each one before those below it, branch by branch."""
    below: dict[str, list[Topic]] = {}
    for topic in topics:
        below.setdefault(topic.is_a, []).append(topic)
    ordered: list[Topic] = []
    waiting = below.get(ROOT, [])[::-1]
    while waiting:
        ordered.append(waiting.pop())
        waiting += below.get(ordered[-1].key, [])[::-1]
    return tuple(ordered)


def _pools(first: int) -> dict[str, tuple[Frame, ...]]:
    pools = {}
    for place, pool in enumerate(POOLS.values(), start=1):
        names = "".join(f" ${name}" for name in sorted(pool.variables))
        texts = {"en": f"Well{names}.", "it": f"Bene{names}.", "ja": f"さて{names}。"}
        frame = Frame(key=f"{pool.name}.1", type=pool.name, texts=texts, number=first + place)
        pools[pool.name] = (frame,)
    return pools


def _library(count: int) -> Library:
    return Library(
        intents=tuple(_intent(number) for number in range(1, count + 1)),
        values=(
            ValueList(
                key="volume_level",
                values={
                    "en": {"louder": ("louder", "up"), "quieter": ("quieter", "down")},
                    "it": {"louder": ("più forte",), "quieter": ("più piano",)},
                    "ja": {"louder": ("大きく",), "quieter": ("小さく",)},
                },
            ),
        ),
        phrases=(Phrase(key="kindly", texts={"en": "please|kindly", "it": "per favore"}),),
    )


def _intent(number: int) -> Intent:
    words = {
        "en": f"play number {number}",
        "it": f"suona il numero {number}",
        "ja": f"{number}番を",
    }
    return Intent(
        number=number,
        key=f"intent_{number}",
        family="media",
        slots=(
            Slot(name="title", required=True, questions={"en": "Which one?", "it": "Quale?"}),
            Slot(name="level", kind="value:volume_level"),
        ),
        abilities={"en": f"play number {number}"},
        triggers={
            code: (f"{text} {{title}}", f"{text} {{title}} {{level}}")
            for code, text in words.items()
        },
        plan_sentences={
            code: (PlanSentence(text=f"{text}!"), PlanSentence(text=f"{text}.", only=("EN",)))
            for code, text in words.items()
        },
        plan=(ActionItem(action="playsong", parameters=(("title", "{title}"), ("to", "all"))),),
        kbplan=(ActionItem(action="jump", parameters=(("topic", "Thing1"),)),)
        if number % 3 == 0
        else (),
        tests={
            "en": (
                IntentTest(sentence=f"{words['en']} Volare", parameters={"title": "Volare"}),
                IntentTest(sentence=f"Nothing about {number}"),
            )
        },
        note="Made up.",
    )
