"""Both engines on identical templates: how often they are right, and what a sentence costs."""

from collections import Counter
from collections.abc import Iterable, Sequence

from benchmarks.matching.homeassistant import Answer, Templates
from benchmarks.matching.measure import Spread, percent, table, together
from benchmarks.matching.samples import Sample
from benchmarks.matching.targets import Figures

RIGHT, SLOTS, OTHER, WRONG, NOTHING = "right", "slots", "other reading", "wrong", "nothing"


def judged(found: Answer | None, wanted: Answer, readings: Iterable[Answer]) -> str:
    """Say what an answer is: right, right but for slots, another reading, wrong or nothing.

    Another reading: the sentence fits another template word for word, with this answer.
    """
    if found is None:
        return NOTHING
    if found == wanted:
        return RIGHT
    if found in readings:
        return OTHER
    return SLOTS if found.intent == wanted.intent else WRONG


def compare(templates: Templates, made: Sequence[Sample], figures: Figures, *, show: int) -> None:
    """Print accuracy and speed of one language."""
    code = templates.code
    counts: dict[str, Counter[str]] = {"ours": Counter(), "hassil": Counter()}
    shown = 0
    for sample in made:
        readings = templates.readings(sample.text)
        for name, engine in (("ours", templates.ours), ("hassil", templates.theirs)):
            verdict = judged(engine(sample.text), sample.answer, readings)
            counts[name][verdict] += 1
            if name == "ours" and verdict not in (RIGHT, OTHER) and shown < show:
                shown += 1
                print(f"- {verdict}: {sample.text!r} {sample.answer} {templates.ours(sample.text)}")
    times = together(
        {"ours": lambda text: templates.catalogue.match(text, code), "hassil": templates.theirs},
        [sample.text for sample in made],
        {"ours": 3, "hassil": 1},
    )
    rows = []
    for name, count in counts.items():
        clear = len(made) - count[OTHER]
        rows.append(
            (
                name,
                len(made),
                count[OTHER],
                percent(count[RIGHT] + count[SLOTS], clear),
                percent(count[RIGHT], clear),
                count[WRONG],
                count[NOTHING],
                times[name],
                _ratio(times["hassil"], times[name]),
            )
        )
    left_out = len({problem.template for problem in templates.conversion.problems})
    table(
        f"Identical templates, {code}",
        f"{templates.count} templates of {len(templates.names)} intents, all loaded together; "
        f"{left_out} of them cannot be said in our grammar and are among the misses.",
        (
            "engine",
            "sentences",
            "read another valid way",
            "intent right",
            "and slots",
            "wrong",
            "nothing",
            "CPU µs, p50 / p95",
            "ratio to hassil",
        ),
        rows,
    )
    ours = counts["ours"]
    figures[f"accuracy {code}"] = 100 * ours[RIGHT] / (len(made) - ours[OTHER])
    figures[f"p50 {code}"] = times["ours"].p50
    figures[f"p95 {code}"] = times["ours"].p95
    figures[f"ratio {code}"] = times["hassil"].p50 / times["ours"].p50


def _ratio(theirs: Spread, ours: Spread) -> str:
    return f"{theirs.p50 / ours.p50:.1f} ×, {theirs.p95 / ours.p95:.1f} ×"
