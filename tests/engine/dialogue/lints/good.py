"""A small knowledge base without a remark: one branch, one group, one class, six hot drinks."""

import msgspec

from dialogue.engine.concepts import ROOT, Culture, Frame, Knowledge, Topic
from dialogue.engine.lints.corpus import Corpus, corpus_of

LANGUAGE_CODES = ("en", "it", "ja")
CULTURES = ("EN", "IT", "JP")

_BRANCH = {
    "q1": (
        "Is talking about $hasName fun?",
        "Parli volentieri $hasName.di?",
        "{}のお話はいかがですか？",
    ),
    "q2": ("Shall we speak of $hasName?", "Parliamo $hasName.di?", "{}の話をしますか？"),
    "p1": ("Then $hasName it is.", "Allora $hasName.", "では{}にしましょう。"),
    "p2": ("I am glad about $hasName.", "Sono felice, $hasName!", "{}ですね。"),
    "n1": ("No $hasName, then.", "Niente $hasName.", "{}はやめましょう。"),
    "n2": ("We leave $hasName alone.", "Lasciamo stare $hasName.", "{}はまた今度にしましょう。"),
    "w1": ("What about $hasName?", "E $hasName?", "{}はどうですか？"),
    "w2": ("What do you know of $hasName?", "Che cosa sai $hasName.di?", "{}をご存じですか？"),
    "c1": ("I learn about $hasName.", "Imparo qualcosa $hasName.su.", "{}を学んでいます。"),
    "c2": ("People tell me of $hasName.", "Mi raccontano $hasName.di.", "{}のことを聞きます。"),
}
_CLASS = {
    "q1": ("Do you drink $hasName?", "Bevi $hasName?", "{}を召し上がりますか？"),
    "q2": ("Is $hasName nice?", "Apprezzi $hasName?", "{}はおいしいですか？"),
    "q3": ("Do you make $hasName?", "Prepari $hasName?", "{}をいれますか？"),
    "p1": ("Good, $hasName!", "Bene, $hasName!", "{}はいいですね。"),
    "p2": ("A cup of $hasName, then.", "Una tazza, ecco $hasName.", "{}を一杯ですね。"),
    "n1": ("I see, no $hasName.", "Capisco, senza $hasName.", "{}は苦手ですね。"),
    "n2": ("We forget $hasName.", "Dimentichiamo $hasName.", "{}は忘れましょう。"),
    "w1": ("When do you have $hasName?", "Quando bevi $hasName?", "{}はいつですか？"),
    "w2": ("Who makes $hasName best?", "Chi prepara meglio $hasName?", "{}はどなたが上手ですか？"),
    "w3": ("How do you make $hasName?", "Come prepari $hasName?", "{}の作り方は何ですか？"),
    "c1": ("I cannot taste $hasName.", "Non posso assaggiare $hasName.", "{}の味は知りません。"),
    "c2": ("The smell of $hasName fills a room.", "Profumo $hasName.di.", "{}の香りです。"),
    "g1": ("Shall I look up $hasName?", "Cerco qualcosa $hasName.su?", "{}を調べますか？"),
    "g2": ("Shall I play $hasName music?", "Metto musica $hasName.per?", "{}の曲にしますか？"),
    "t1": (
        "From $hasName to $toName.",
        "Lasciamo $hasName, parliamo $toName.di.",
        "{}から$toNameです。",
    ),
}
#: English, Italian, Japanese, and how much EN, IT and JP like it.
_DRINKS = {
    "Tea": ("tea", "tè", "紅茶", (0.9, 0.5, 0.8)),
    "Milk": ("milk", "latte", "牛乳", (0.7, 0.6, 0.5)),
    "Coffee": ("coffee", "caffè", "コーヒー", (0.6, 0.9, 0.6)),
    "Cocoa": ("cocoa", "cacao", "ココア", (0.5, 0.4, 0.1)),
    "GreenTea": ("green tea", "tè verde", "緑茶", (0.3, 0.35, 0.9)),
    "Broth": ("broth", "brodo", "だし", (0.1, 0.3, 0.3)),
}


def frames(owner: str, table: dict[str, tuple[str, str, str]]) -> tuple[Frame, ...]:
    """Return frames with the name in place of {} and with what a proposal offers."""
    return tuple(
        Frame(
            key=f"{owner}.{name}",
            type=name[0],
            texts={
                code: text.replace("{}", "$hasName").replace("$hasName.per", "con $hasName")
                for code, text in zip(LANGUAGE_CODES, texts, strict=True)
            },
            do="wikisearch what=$hasName" if name[0] == "g" else "",
        )
        for name, texts in table.items()
    )


def topic(key: str, is_a: str, number: int, names: tuple[str, str, str], **more: object) -> Topic:
    """Return a topic whose names are uncounted and masculine, found by two words."""
    english, italian, japanese = names
    usual: dict[str, object] = {
        "names": {
            "en": {"name": english, "count": "no"},
            "it": {"name": italian, "g": "m"},
            "ja": {"name": japanese},
        },
        "keywords": {
            code: ((name,), ("drink", "bere", "飲み物"))
            for code, name in zip(LANGUAGE_CODES, names, strict=True)
        },
        "likeliness": dict.fromkeys(CULTURES, 0.5),
    }
    fields = {"key": key, "is_a": is_a, "number": number, **usual, **more}
    return msgspec.convert(fields, Topic)


_LEAVES = tuple(
    topic(
        key,
        "HotDrink",
        number,
        names[:3],
        likeliness=dict(zip(CULTURES, names[3], strict=True)),
        see=tuple(other for other in _DRINKS if other != key)[:2],
    )
    for number, (key, names) in enumerate(_DRINKS.items(), 4)
)
_OWN_LINES = tuple(
    Frame(
        key=f"Tea.{code}{place}",
        type="c",
        only=(code,),
        texts={
            "en": f"In {code}, tea has {place} stories.",
            "it": f"In {code} il tè ha {place} storie.",
            "ja": f"{code}では、お茶に{place}のお話があります。",
        },
    )
    for code in CULTURES
    for place in range(300)
)
KNOWLEDGE = Knowledge(
    cultures=tuple(
        Culture(code=code, names={"en": code}, language=language)
        for code, language in zip(CULTURES, LANGUAGE_CODES, strict=True)
    ),
    topics=(
        topic("Drink", ROOT, 1, ("drinking", "bere", "飲み物"), frames=frames("Drink", _BRANCH)),
        topic("Warm", "Drink", 2, ("warm things", "caldo", "温かいもの")),
        topic(
            "HotDrink",
            "Warm",
            3,
            ("hot drinks", "beveraggio", "ホットドリンク"),
            frames=frames("HotDrink", _CLASS),
        ),
        *_LEAVES,
    ),
)


def changed(key: str, knowledge: Knowledge = KNOWLEDGE, **fields: object) -> Knowledge:
    """Return the knowledge base with other fields in one topic."""
    replace = msgspec.structs.replace
    topics = tuple(replace(one, **fields) if one.key == key else one for one in knowledge.topics)
    return replace(knowledge, topics=topics)


def saying(key: str, type_: str, english: str, italian: str = "", japanese: str = "") -> Knowledge:
    """Return the knowledge base with one more sentence."""
    texts = dict(zip(LANGUAGE_CODES, (english, italian, japanese), strict=True))
    frame = Frame(key=f"{key}.{type_}9", type=type_, texts=texts)
    (own,) = (one.frames for one in KNOWLEDGE.topics if one.key == key)
    return changed(key, frames=(*own, frame))


def with_own_lines() -> Knowledge:
    """Return the knowledge base with 300 sentences for each culture."""
    return changed("Tea", frames=_OWN_LINES)


def found_by_one_word() -> Knowledge:
    """Return the knowledge base with each name as a keyword that is enough."""
    knowledge = KNOWLEDGE
    for one in KNOWLEDGE.topics:
        words = {code: ((names["name"],), ("*",)) for code, names in one.names.items()}
        knowledge = changed(one.key, knowledge, keywords=words)
    return knowledge


def corpus(knowledge: Knowledge = KNOWLEDGE) -> Corpus:
    """Return the knowledge base as the lints read it."""
    return corpus_of(knowledge)
