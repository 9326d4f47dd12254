"""What is asked of the matcher, and whether this run met it."""

from typing import NamedTuple

from benchmarks.matching.measure import table

Figures = dict[str, float]


class Target(NamedTuple):
    """A figure that must be at most or at least so much."""

    name: str
    limit: float
    unit: str
    at_least: bool = False

    def met(self, figure: float) -> bool:
        """Say whether a figure meets it."""
        return figure >= self.limit if self.at_least else figure <= self.limit


def _all() -> tuple[Target, ...]:
    found = []
    for code, right, ratio, typo in (
        ("en", 99.5, 100, 92),
        ("it", 99.6, 100, 92),
        ("ja", 100, 20, 60),
    ):
        found += [
            Target(f"accuracy {code}", right, "%", at_least=True),
            Target(f"p50 {code}", 30, "µs"),
            Target(f"p95 {code}", 100, "µs"),
            Target(f"ratio {code}", ratio, "×", at_least=True),
            Target(f"1,000 × 20 hit {code}", 60, "µs"),
            Target(f"1,000 × 20 miss {code}", 120, "µs"),
            Target(f"1,000 × 20 first hit {code}", 1_000, "µs"),
        ]
        for where in ("own", "HA"):
            found += [
                Target(f"listed filler, {where} {code}", 98, "%", at_least=True),
                Target(f"unlisted filler, {where} {code}", 90, "%", at_least=True),
                Target(f"typo, {where} {code}", typo, "%", at_least=True),
                Target(f"accents, {where} {code}", 95, "%", at_least=True),
            ]
    return (
        *found,
        Target("1,000 × 20 load, three languages", 5, "s"),
        Target("1,000 × 20 memory, three languages", 250, "MB"),
        Target("false accepts", 0.5, "%"),
        Target("chat sentences acted on", 0, ""),
        Target("plan and topic match p95", 200, "µs"),
    )


TARGETS = _all()


def report(figures: Figures) -> None:
    """Print each target with the figure of this run; what was not measured is left out."""
    rows = [
        (
            target.name,
            f"{'≥' if target.at_least else '≤'} {target.limit:,g} {target.unit}",
            f"{figures[target.name]:,.1f} {target.unit}",
            "met" if target.met(figures[target.name]) else "**not met**",
        )
        for target in TARGETS
        if target.name in figures
    ]
    met = sum(row[3] == "met" for row in rows)
    table("Targets", f"{met} of {len(rows)} met.", ("what", "target", "this run", ""), rows)
