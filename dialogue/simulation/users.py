"""The people of simulated talks: what each says to the agent's last words, one row a kind."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from random import Random
from types import MappingProxyType

from dialogue.engine.content import Content
from dialogue.engine.manager import Reply
from dialogue.engine.tree import Node

Words = Mapping[str, tuple[str, ...]]

YES: Words = MappingProxyType(
    {
        "en": ("Yes.", "Yes, I do.", "Of course.", "Oh yes, very much.", "Yes, please.", "I do."),
        "it": ("Sì.", "Certo.", "Sì, molto.", "Eh sì.", "Sì, volentieri.", "Come no."),
        "ja": ("はい。", "ええ、好きです。", "そうですね、はい。", "もちろんです。", "うん。"),
    }
)
NO: Words = MappingProxyType(
    {
        "en": ("No.", "No, not really.", "I don't.", "No, thank you.", "Not at all.", "Never."),
        "it": ("No.", "No, per niente.", "Non molto.", "No, grazie.", "Mai.", "Direi di no."),
        "ja": (
            "いいえ。",
            "いや、別に。",
            "あまり好きじゃないです。",
            "いえ、結構です。",
            "全然。",
        ),
    }
)
SHORT: Words = MappingProxyType(
    {
        "en": ("Hm.", "I see.", "Well.", "Maybe.", "Oh.", "Who knows.", "It depends.", "Mm-hm."),
        "it": ("Mah.", "Ah.", "Boh.", "Forse.", "Eh già.", "Chissà.", "Dipende.", "Mm."),
        "ja": (
            "へえ。",
            "そうですか。",
            "さあ。",
            "まあ。",
            "ふうん。",
            "どうでしょう。",
            "ああ。",
        ),
    }
)
STORY: Words = MappingProxyType(
    {
        "en": (
            "It was a long time ago, but I still think of it.",
            "There were four of us and we always laughed a lot.",
            "That is a long story, and it makes me smile.",
            "I could not tell you exactly.",
            "It was mostly the company that made it nice.",
        ),
        "it": (
            "È passato tanto tempo, però ci penso ancora.",
            "Eravamo in quattro e si rideva sempre.",
            "È una storia lunga, ma mi fa sorridere.",
            "Non te lo saprei dire di preciso.",
            "Era soprattutto la compagnia a renderlo bello.",
        ),
        "ja": (
            "ずいぶん前のことですが、今でも思い出します。",
            "四人でいつも笑ってばかりいました。",
            "話せば長くなりますが、懐かしいです。",
            "はっきりとは言えませんね。",
            "一緒にいた人たちがよかったんですよ。",
        ),
    }
)
ABOUT: Words = MappingProxyType(
    {
        "en": ("Let us talk about {0}.", "I would like to talk about {0}.", "Tell me about {0}."),
        "it": ("Parliamo di {0}.", "Vorrei parlare di {0}.", "Raccontami qualcosa di {0}."),
        "ja": ("{0}の話をしましょう。", "{0}について話したいです。", "{0}の話を聞かせてください。"),
    }
)
AVOID: Words = MappingProxyType(
    {
        "en": ("I do not want to talk about {0}.", "Please stop talking about {0}."),
        "it": ("Non voglio parlare di {0}.", "Smettila di parlare di {0}."),
        "ja": ("{0}の話はしたくありません。", "{0}の話はやめてください。"),
    }
)
OTHERWISE: Words = MappingProxyType(
    {
        "en": ("Let us change the subject.", "Tell me more.", "What do you think?"),
        "it": ("Cambiamo argomento.", "Dimmi di più.", "E tu che ne pensi?"),
        "ja": ("話題を変えましょう。", "もっと聞かせてください。", "どう思いますか。"),
    }
)


@dataclass(frozen=True, slots=True)
class Said:
    """What a user says; `topical` where it names something one can talk about.

    `avoided` is the topic the user does not want to hear about.
    """

    text: str
    topical: bool = False
    avoided: Node | None = None


@dataclass(frozen=True, slots=True)
class Hearing:
    """What a user answers to: the agent's reply, with all that the user may draw from."""

    reply: Reply
    content: Content
    chance: Random
    topical: Sequence[str]
    chat: Sequence[str]

    def one(self, words: Words) -> str:
        """Return one of these in the language of the talk."""
        return self.chance.choice(words[self.reply.state.language])


User = Callable[[Hearing], Said]


def _passive(hearing: Hearing) -> Said:
    return Said(hearing.one(SHORT))


def _answering(words: Words) -> User:
    def say(hearing: Hearing) -> Said:
        asked = hearing.reply.sentence_type in ("q", "g")
        return Said(hearing.one(words) if asked else hearing.one(SHORT))

    return say


def _talkative(hearing: Hearing) -> Said:
    """Answer questions, tell stories, and say what nobody tuned the agent to."""
    draw = hearing.chance.random()
    if hearing.reply.sentence_type in ("q", "g") and draw < 0.6:
        return Said(hearing.one(YES if hearing.chance.random() < 0.65 else NO))
    if hearing.topical and draw < 0.75:
        return Said(hearing.chance.choice(hearing.topical), topical=True)
    if hearing.chat and draw < 0.85:
        return Said(hearing.chance.choice(hearing.chat))
    return Said(hearing.one(STORY))


def _wilful(hearing: Hearing) -> Said:
    """Ask for topics, send topics away, change the subject; else answer."""
    draw = hearing.chance.random()
    language = hearing.reply.state.language
    here = hearing.content.tree.node(hearing.reply.state.topic)
    if draw < 0.12:
        node = hearing.chance.choice(list(hearing.content.tree.nodes.values()))
        return Said(hearing.one(ABOUT).format(node.names[language].forms[""]), topical=True)
    if draw < 0.2 and here:
        text = hearing.one(AVOID).format(here.names[language].forms[""])
        return Said(text, avoided=here)
    if draw < 0.27:
        return Said(hearing.one(OTHERWISE))
    return _answering(YES if draw < 0.7 else NO)(hearing)


USERS: Mapping[str, User] = MappingProxyType(
    {
        "passive": _passive,
        "yes": _answering(YES),
        "no": _answering(NO),
        "talkative": _talkative,
        "wilful": _wilful,
    }
)
