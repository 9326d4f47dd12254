"""A small world with tea, music, people and grief in three languages; Mrs Smith likes tea."""

import msgspec

from dialogue.engine.concepts import ROOT, Culture, Frame, Knowledge, Topic, usual_likeliness
from dialogue.engine.content import Content, build_content
from dialogue.engine.slots import missing_slots
from plans.engine.intents import Intent, Library, PlanSentence, Slot
from plans.engine.plan_text import parse_plan
from tests.engine.dialogue.world_pools import LANGUAGE_CODES, rows

CULTURES = ("EN", "IT", "JP")
NUMBERS = {
    key: number
    for number, key in enumerate(
        [
            "FoodAndDrink",
            "Drinks",
            "Tea",
            "GreenTea",
            "Milk",
            "Coffee",
            "Music",
            "Piano",
            "Singing",
            "Traditions",
            "TeaCeremony",
            "Festivals",
            "Life",
            "Grief",
            "Funerals",
            "OnYourMind",
            "Gardening",
            "People",
            "Husband",
        ],
        1,
    )
}

_GENERAL = {
    "q1": ("Do you like $hasName?", "Ti {piace|piacciono} $hasName?", "$hasNameはお好きですか？"),
    "q2": ("Are you fond of $hasName?", "Apprezzi $hasName?", "$hasNameに興味がありますか？"),
    "p1": ("Good, $hasName!", "Bene, $hasName!", "いいですね、$hasName。"),
    "p2": ("Lovely, $hasName.", "Che bello, $hasName.", "$hasName、すてきです。"),
    "n1": ("No $hasName for you.", "Niente $hasName.", "$hasNameは苦手ですね。"),
    "n2": ("$hasName can wait.", "Per ora niente $hasName.", "$hasNameはまた今度。"),
    "w1": (
        "What is special about $hasName?",
        "Che cos'ha di bello $hasName?",
        "$hasNameのよさは？",
    ),
    "w2": ("When was $hasName best?", "Quando era meglio $hasName?", "$hasNameの思い出は？"),
    "w3": ("Who told you about $hasName?", "Chi ti parlava $hasName.di?", "$hasNameは誰から？"),
    "c1": ("Much is said about $hasName.", "Si parla molto $hasName.di.", "$hasNameは話題です。"),
    "c2": ("I learn about $hasName.", "Imparo $hasName.da.", "$hasNameを学んでいます。"),
    "c3": ("$hasName has a story.", "C'è una storia: $hasName.", "$hasNameには物語があります。"),
}
_GENTLE = {
    "c1": ("I am with you.", "Sono con te.", "おそばにいます。"),
    "c2": ("I have time for you.", "Ho tempo per te.", "時間はあります。"),
    "w1": ("How is that for you?", "E per te com'è?", "いかがお感じですか？"),
    "w2": ("What helps you then?", "Che cosa ti aiuta?", "何が支えになりますか？"),
}
_LISTENING = {
    "c1": ("I am all ears.", "Sono tutto orecchi.", "よく聞いています。"),
    "c2": ("There is no hurry.", "Non c'è fretta.", "急ぎませんよ。"),
    "w1": ("What would you like to tell me?", "Che cosa vuoi dirmi?", "何をお話しになりますか？"),
    "w2": ("What matters most in it?", "Che cosa conta di più?", "何が一番大切ですか？"),
}
_TRANSITION = {
    "t1": (
        "$hasName brings me to $toName.",
        "$hasName.da vengo $toName.a.",
        "$hasNameといえば$toName。",
    )
}


def frames(owner: str, *tables: dict[str, tuple[str, str, str]]) -> tuple[Frame, ...]:
    """Return frames such as `Tea.c1`, still without numbers."""
    return tuple(
        Frame(
            key=f"{owner}.{name}", type=name[0], texts=dict(zip(LANGUAGE_CODES, texts, strict=True))
        )
        for table in tables
        for name, texts in table.items()
    )


def topic(key: str, is_a: str, names: str, **more: object) -> Topic:
    """Return a topic; `names` are English, Italian with its gender, Japanese: "tea/m tè/お茶"."""
    english, italian, japanese = names.split("/")
    gender, _, italian = italian.partition(" ")
    fields: dict[str, object] = {
        "names": {
            "en": {"name": english},
            "it": {"name": italian, "g": gender},
            "ja": {"name": japanese},
        },
        "keywords": {
            code: ((word,), ("*",))
            for code, word in zip(LANGUAGE_CODES, (english, italian, japanese), strict=True)
        },
        "likeliness": usual_likeliness("", CULTURES),
    }
    return msgspec.convert(
        {"key": key, "is_a": is_a, "number": NUMBERS[key], **fields, **more}, Topic
    )


_GREEN_TEA_KEYWORDS = {
    "en": (("green",), ("tea",)),
    "it": (("verde",), ("tè",)),
    "ja": (("緑茶",), ("*",)),
}
_OFFERS = (
    Frame(
        key="Music.g1",
        type="g",
        texts={
            "en": "Shall I play some $hasName?",
            "it": "Metto un po' $hasName.di?",
            "ja": "$hasNameをかけましょうか？",
        },
        do="playsong title=$hasName.bare",
    ),
    Frame(
        key="Music.g2",
        type="g",
        texts={"en": "Shall I wave?", "it": "Ti saluto con la mano?", "ja": "手を振りましょうか？"},
        do="wave",
    ),
)
_ONLY_IN_JAPAN = Frame(
    key="Tea.c4",
    type="c",
    only=("JP",),
    texts={
        "en": "In Japan, visitors are served tea.",
        "it": "In Giappone agli ospiti si offre il tè.",
        "ja": "お客様にはお茶をお出しします。",
    },
)
_TEA_OWN = {"c1": ("Tea warms the hands.", "Il tè scalda le mani.", "お茶は手を温めます。")}
_GENTLE_WORDS = {"gentle": True, "stop": "qpnwcg", "pattern": ("c w c",)}

TOPICS = (
    topic(
        "FoodAndDrink",
        ROOT,
        "food and drink/m cibo/食べ物",
        pattern=("q r w c",),
        frames=frames("FoodAndDrink", _GENERAL, _TRANSITION),
    ),
    topic("Drinks", "FoodAndDrink", "drinks/f bevanda/飲み物"),
    topic(
        "Tea",
        "Drinks",
        "tea/m tè/お茶",
        likeliness={"EN": 0.8, "IT": 0.3, "JP": 0.7},
        see=("Milk", "TeaCeremony"),
        frames=(*frames("Tea", _TEA_OWN), _ONLY_IN_JAPAN),
    ),
    topic("GreenTea", "Tea", "green tea/m tè verde/緑茶", keywords=_GREEN_TEA_KEYWORDS),
    topic("Milk", "Drinks", "milk/m latte/牛乳"),
    topic(
        "Coffee", "Drinks", "coffee/m caffè/コーヒー", likeliness={"EN": 0.4, "IT": 0.9, "JP": 0.5}
    ),
    topic(
        "Music",
        ROOT,
        "music/f musica/音楽",
        pattern=("q r w c g",),
        frames=(*frames("Music", _GENERAL), *_OFFERS),
    ),
    topic(
        "Piano",
        "Music",
        "the piano/m pianoforte/ピアノ",
        keywords={
            "en": (("piano",), ("*",)),
            "it": (("pianoforte",), ("*",)),
            "ja": (("ピアノ",), ("*",)),
        },
    ),
    topic("Singing", "Music", "singing/m canto/歌"),
    topic(
        "Traditions", ROOT, "traditions/f tradizione/伝統", frames=frames("Traditions", _GENERAL)
    ),
    topic(
        "TeaCeremony",
        "Traditions",
        "the tea ceremony/f cerimonia del tè/茶道",
        keywords={
            "en": (("ceremony",), ("tea",)),
            "it": (("cerimonia",), ("tè",)),
            "ja": (("茶道",), ("*",)),
        },
    ),
    topic("Festivals", "Traditions", "festivals/f sagra/お祭り"),
    topic("Life", ROOT, "life/f vita/人生", frames=frames("Life", _GENERAL)),
    topic(
        "Grief", "Life", "grief/m lutto/悲しみ", frames=frames("Grief", _GENTLE), **_GENTLE_WORDS
    ),
    topic("Funerals", "Grief", "funerals/m funerale/お葬式"),
    topic(
        "OnYourMind",
        "Life",
        "what is on your mind/m pensiero/お気持ち",
        keywords={},
        frames=frames("OnYourMind", _LISTENING),
        **_GENTLE_WORDS,
    ),
    topic("Gardening", "Life", "gardening/m giardinaggio/園芸"),
    topic("People", "Life", "the people around us/f gente/周りの人", keywords={}),
    topic(
        "Husband",
        "People",
        "husbands/m marito/夫",
        keywords={
            "en": (("husband",), ("*",)),
            "it": (("marito",), ("*",)),
            "ja": (("夫",), ("*",)),
        },
    ),
)

PLAYSONG = Intent(
    number=1,
    key="playsong",
    family="media",
    abilities={"en": "play a song", "it": "mettere una canzone", "ja": "音楽をかける"},
    slots=(Slot(name="title"),),
    triggers={"en": ("play {title}",)},
    plan_sentences={"en": (PlanSentence(text="I play {title}."),)},
    plan=parse_plan("#action=playsong title={title}"),
)
WAVE = Intent(
    number=2,
    key="wave",
    family="robot",
    abilities={"en": "wave", "it": "salutare con la mano", "ja": "手を振る"},
    triggers={"en": ("wave",)},
    plan_sentences={},
    plan=parse_plan("#action=attention"),
)
LIBRARY = Library(intents=(PLAYSONG, WAVE))


def numbered(knowledge: Knowledge) -> Knowledge:
    """Return the knowledge with a number for each frame, then a slot."""
    count = iter(range(1, 10_000))

    def with_numbers(some: tuple[Frame, ...]) -> tuple[Frame, ...]:
        return tuple(msgspec.structs.replace(one, number=next(count), slot=-1) for one in some)

    topics = tuple(
        msgspec.structs.replace(one, frames=with_numbers(one.frames)) for one in knowledge.topics
    )
    pools = {name: with_numbers(some) for name, some in knowledge.pools.items()}
    knowledge = msgspec.structs.replace(knowledge, topics=topics, pools=pools)
    slots = missing_slots(knowledge)

    def with_slots(one: Topic) -> Topic:
        some = (msgspec.structs.replace(frame, slot=slots[frame.number]) for frame in one.frames)
        return msgspec.structs.replace(one, frames=tuple(some))

    return msgspec.structs.replace(knowledge, topics=tuple(map(with_slots, topics)))


def _pools() -> dict[str, tuple[Frame, ...]]:
    pools: dict[str, tuple[Frame, ...]] = {}
    for pool, place, texts in rows():
        frame = Frame(key=f"{pool}.{place}", type=pool, texts=texts)
        pools[pool] = (*pools.get(pool, ()), frame)
    return pools


def _culture(code: str, language: str) -> Culture:
    return Culture(code=code, names={"en": code}, language=language)


KNOWLEDGE = numbered(
    Knowledge(
        cultures=(_culture("EN", "en"), _culture("IT", "it"), _culture("JP", "ja")),
        topics=TOPICS,
        pools=_pools(),
    )
)
WORLD = build_content(KNOWLEDGE, LIBRARY, 1)


def changed(topic_key: str, **fields: object) -> Knowledge:
    """Return the world's knowledge with one topic changed, frames numbered anew."""
    topics = tuple(
        msgspec.structs.replace(one, **fields) if one.key == topic_key else one
        for one in KNOWLEDGE.topics
    )
    return numbered(msgspec.structs.replace(KNOWLEDGE, topics=topics))


def without_topics(*keys: str) -> Content:
    """Return the world without these topics, all numbers kept."""
    topics = tuple(one for one in KNOWLEDGE.topics if one.key not in keys)
    return build_content(msgspec.structs.replace(KNOWLEDGE, topics=topics), LIBRARY, 2)


def with_pool(name: str, *keep: int) -> Content:
    """Return the world with only these sentences (by place) of a pool."""
    pools = {**KNOWLEDGE.pools, name: tuple(KNOWLEDGE.pools[name][place] for place in keep)}
    return build_content(msgspec.structs.replace(KNOWLEDGE, pools=pools), LIBRARY, 3)
