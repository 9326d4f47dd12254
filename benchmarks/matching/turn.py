"""What matching takes of a turn: intents and topics, on the shipped content."""

from collections.abc import Callable

from django.test import Client

from benchmarks import turn as whole_turn
from benchmarks.matching.measure import spread, table
from benchmarks.matching.robust import stored
from benchmarks.matching.targets import Figures
from benchmarks.tree import cover
from dialogue.engine.content import Content
from languages.known import LANGUAGES
from tests.engine.plans.chat import CHAT


def share(content: Content, figures: Figures) -> None:
    """Print the time of plan and topic matching, and their share of a whole turn."""
    rows: list[tuple[object, ...]] = []
    slowest = 0.0
    for code in LANGUAGES:
        chosen = {
            "ordinary talk": CHAT[code],
            "requests": [one.text for one in stored(content.library, code)][::3],
        }
        for name, sentences in chosen.items():
            times = [spread(work, sentences, 3) for work in _works(content, code)]
            slowest = max(slowest, times[-1].p95)
            rows.append((code, name, len(sentences), *times))
    figures["plan and topic match p95"] = slowest
    table(
        "Plan and topic match on the shipped content",
        f"{len(content.library.intents)} intents, {len(content.tree.nodes)} topics. "
        "CPU µs, p50 / p95. " + _of_a_turn(content),
        ("language", "what", "sentences", "plan", "topics", "both"),
        rows,
    )


def _of_a_turn(content: Content) -> str:
    whole_turn.serve(content)
    from dialogue.turns import write_state  # Django is set up only now

    state = write_state(cover(content, 10))
    turn = whole_turn.cost(Client(), state)
    matching = spread(_works(content, "en")[-1], CHAT["en"], 5)
    return (
        f"Of a whole turn in process ({turn:,.0f} µs in `benchmarks/turn.py`) ordinary talk in "
        f"English takes {matching.p50:,.0f} µs, {100 * matching.p50 / turn:.0f} %."
    )


def _works(content: Content, code: str) -> tuple[Callable[[str], object], ...]:
    """Return the plan match, the topic match, and both."""
    match, search = content.catalogue.match, content.keywords[code].search
    return (
        lambda text: match(text, code),
        search,
        lambda text: (match(text, code), search(text)),
    )
