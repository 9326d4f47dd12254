"""The baseline's lists, made of our published content in English."""

import re
from itertools import cycle, islice

from benchmarks.baseline.data import Intent, Lists, Sentence, Topic
from dialogue.engine.content import Content, keyword_rows
from dialogue.engine.tree import Line, Node
from languages.language import NameForms
from plans.engine.intents import ActionItem
from plans.engine.intents import Intent as OurIntent

LANGUAGE, CULTURE = "en", "EN"
SENTENCES = 20_000
ORDER = "qpnwcg"
SLOT = re.compile(r"\\\{(\w+)\\\}")
LETTERS = re.compile(r"[a-z]{3}")
PHRASE = re.compile(r"<\w+>")


def lists(content: Content, sentences: int = SENTENCES) -> Lists:
    """Return topics and intents; so many sentences in all, dealt out to the topics in turn."""
    nodes = list(content.tree.nodes.values())
    places = {node.number: place for place, node in enumerate(nodes)}
    rows = keyword_rows(content.knowledge, LANGUAGE)
    words = {row.topic: (row.first, row.second) for row in rows}
    share = _shares([len(_lines(node)) for node in nodes], sentences)
    return Lists(
        topics=[
            _topic(node, words.get(node.number, ((), ())), places, count)
            for node, count in zip(nodes, share, strict=True)
        ],
        roots=[places[number] for number in content.tree.branches],
        intents=[_intent(one) for one in content.library.intents],
    )


def _shares(have: list[int], wanted: int) -> list[int]:
    """Deal `wanted` out, one each in turn, to no one more than they have."""
    shares, left = [0] * len(have), min(wanted, sum(have))
    while left:
        for place, most in enumerate(have):
            if shares[place] < most and left:
                shares[place] += 1
                left -= 1
    return shares


def _lines(node: Node) -> list[Line]:
    """Return what can be said in English, the types in turn, q p n w c g and again."""
    piles = {
        kind: [one for one in node.lines.get(kind, ()) if one.fits(LANGUAGE, CULTURE)]
        for kind in ORDER
    }
    total = sum(map(len, piles.values()))
    turns = (piles[kind].pop(0) if piles[kind] else None for kind in cycle(ORDER))
    steps = islice(turns, len(ORDER) * (total + 1))
    return [line for line in steps if line is not None]


def _topic(
    node: Node,
    words: tuple[tuple[str, ...], tuple[str, ...]],
    places: dict[int, int],
    count: int,
) -> Topic:
    names = {"hasName": node.names[LANGUAGE], "toName": node.names[LANGUAGE]}
    said = [
        Sentence(type=line.type, text=_filled(line, names, node)) for line in _lines(node)[:count]
    ]
    said = said or [Sentence(type="c", text="Well, I see.")]
    kinds = {one["type"] for one in said}
    return Topic(
        name=node.key,
        keywords=[[word.lower() for word in row] for row in words],
        likeliness=node.likeliness.get(CULTURE, 0.5),
        children=[places[number] for number in node.children],
        pattern="".join(kind for kind in "qpwcg" if kind in kinds) or said[0]["type"],
        sentences=said,
    )


def _filled(line: Line, names: dict[str, NameForms], node: Node) -> str:
    words = node.variables.get(LANGUAGE, {})
    return line.templates[LANGUAGE].fill(names, words)


def _intent(intent: OurIntent) -> Intent:
    return Intent(
        name=intent.key,
        triggers=[
            regular(text)
            for text in intent.triggers.get(LANGUAGE, ())
            if LETTERS.search(_words(text))
        ],
        sentences=[_dollars(one.text) for one in intent.plan_sentences.get(LANGUAGE, ())],
        plan=_plan(intent.plan),
        kbplan=_plan(intent.kbplan),
    )


def _plan(items: tuple[ActionItem, ...]) -> str:
    return "".join(_item(item) for item in items)


def _item(item: ActionItem) -> str:
    values = "".join(f" {name}={_dollars(value)}" for name, value in item.parameters)
    return f"#action={item.action}{values}"


def _words(trigger: str) -> str:
    """Return what a trigger cannot do without: no slots, nothing in brackets."""
    return re.sub(r"\{\w+\}|<\w+>|\[[^\[\]]*\]", "", trigger)


def _dollars(text: str) -> str:
    return re.sub(r"\{(\w+)\}", r"$\1", text)


def regular(trigger: str) -> str:
    """Return a trigger as a regular expression: `play [the] (song|tune) {title}`."""
    named: set[str] = set()

    def slot(found: re.Match[str]) -> str:
        name = found[1]
        if name in named:
            return ".+"
        named.add(name)
        return f"(?P<{name}>.+)"

    text = re.escape(trigger.lower()).replace(r"\ ", " ")
    text = SLOT.sub(slot, PHRASE.sub(r"\\w+", text))
    for sign, means in (("(", "(?:"), (")", ")"), ("|", "|"), ("[", "(?:"), ("]", ")?")):
        text = text.replace("\\" + sign, means)
    return text.replace(" ", " ?")
