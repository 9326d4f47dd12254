"""Find the topic a person means: by keywords in what they say, or by the name in a wish."""

from dialogue.engine.chance import draw
from dialogue.engine.keywords import KeywordMatch
from dialogue.engine.names import spelled
from dialogue.engine.tree import Node
from dialogue.engine.turn import Turn

LONGEST_HEARD = 2000
LONGEST_NAME = 120


def topic_of_sentence(turn: Turn, sentence: str) -> Node | None:
    """Return one of the topics whose keywords are in the sentence (Algorithm 1, lines 21-24).

    The best rank wins, hard subjects before others; then a draw by likeliness; a topic of
    likeliness 0 only where nothing else matched.
    """
    called = topic_called(turn, sentence)
    if called:
        return called
    index = turn.content.keywords[turn.state.language]
    matches = index.search(sentence[:LONGEST_HEARD])
    found = [(node, match) for match in matches if (node := turn.content.tree.node(match.topic))]
    if not found:
        return None
    found = _hard_subjects(found) or found
    best = max(match.rank for _, match in found)
    options = [(node, turn.likeliness(node)) for node, match in found if match.rank == best]
    chosen = draw(options, turn.chance) or options[0][0]
    words = next(match.words for node, match in found if node is chosen)
    turn.note("keywords", f"{', '.join(words)} → {chosen.key}", options)
    return chosen


def _hard_subjects(found: list[tuple[Node, KeywordMatch]]) -> list[tuple[Node, KeywordMatch]]:
    """Return the hard subjects, unless only another topic was named by two words.

    "My husband died, we had a dog" is about grief; "the doctor told me to drink green tea" is not
    about doctors.
    """
    gentle = [(node, match) for node, match in found if node.gentle]
    precise = any(not match.wildcard for node, match in found if not node.gentle)
    if precise and all(match.wildcard for _, match in gentle):
        return [(node, match) for node, match in found if not node.gentle]
    return gentle


def topic_called(turn: Turn, words: str) -> Node | None:
    """Return the topic whose name these words are, the likelier one where there are two."""
    language = turn.language
    numbers = turn.content.names[language.code].get(spelled(words[:LONGEST_NAME], language), ())
    named = [node for number in numbers if (node := turn.content.tree.node(number))]
    if not named:
        return None
    chosen = max(named, key=turn.likeliness)
    turn.note("name", f"{words.strip()} → {chosen.key}")
    return chosen


def named_topic(turn: Turn, words: str) -> Node | None:
    """Return the topic of a KBplan action: by its name in the ontology, else by keywords.

    The actions of one plan mean the same topic by the same words, also where it is drawn.
    """
    words = words.replace("_", " ").strip()
    if words and words not in turn.named:
        node = turn.content.tree.by_key.get("".join(words.split()))
        turn.named[words] = node or topic_of_sentence(turn, words)
    return turn.named.get(words)
