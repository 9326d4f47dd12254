"""The paper's three figures, redrawn: its design re-created on the left, ours on the right."""

from collections.abc import Sequence
from pathlib import Path

import matplotlib as mpl

mpl.use("Agg")

from matplotlib import pyplot as plt
from matplotlib.axes import Axes

from benchmarks.paper.experiments import BASELINE, BURST, SPREAD, THRESHOLD, Row
from benchmarks.paper.report import chosen

BLUE, ORANGE = "tab:blue", "tab:orange"
#: What the paper's text says: (x, ms) of the response time and of server processing.
PAPER = {
    BASELINE: ([(18_166, 189.0)], [(18_166, 107.4)]),
    BURST: ([(20, THRESHOLD)], [(50, THRESHOLD)]),
    SPREAD: ([(250, THRESHOLD)], [(250, 450.0)]),
}
XLABELS = {
    BASELINE: "payload of a request (bytes)",
    BURST: "N simultaneous requests",
    SPREAD: "N requests over 10 seconds",
}
TITLES = {"baseline": "the paper's design, re-created", "cair": "ours"}


def draw(folder: Path, rows: Sequence[Row]) -> list[Path]:
    """Write each figure as SVG and PNG; return the files."""
    folder.mkdir(parents=True, exist_ok=True)
    plt.rcParams["svg.hashsalt"] = "cair"
    files: list[Path] = []
    for experiment in (BASELINE, BURST, SPREAD):
        figure, panels = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
        for panel, system in zip(panels, TITLES, strict=True):
            _panel(panel, experiment, system, chosen(rows, experiment, system))
        for kind in ("svg", "png"):
            files.append(folder / f"{experiment.replace(' ', '-')}.{kind}")
            metadata = {"Date": None} if kind == "svg" else None
            figure.savefig(files[-1], metadata=metadata, dpi=120)
        plt.close(figure)
    return files


def _panel(panel: Axes, experiment: str, system: str, rows: list[Row]) -> None:
    at = [row.payload if experiment == BASELINE else row.n for row in rows]
    responses = ([row.mean for row in rows], [row.sd for row in rows])
    server = ([row.server_mean for row in rows], [row.server_sd for row in rows])
    for (means, deviations), colour, label in (
        (responses, BLUE, "response time"),
        (server, ORANGE, "server processing time"),
    ):
        panel.errorbar(at, means, deviations, color=colour, marker="o", capsize=3, label=label)
    if system == "baseline":
        _paper(panel, experiment)
    if experiment != BASELINE:
        panel.axhline(THRESHOLD, color="grey", linestyle=":")
    panel.set(title=TITLES[system], xlabel=XLABELS[experiment], ylabel="ms")
    panel.set_xlim(left=0)
    panel.set_ylim(bottom=0)
    panel.legend()


def _paper(panel: Axes, experiment: str) -> None:
    for points, colour, label in zip(
        PAPER[experiment], (BLUE, ORANGE), ("response", "server"), strict=True
    ):
        x, y = zip(*points, strict=True)
        panel.plot(x, y, "*", color=colour, markersize=14, label=f"the paper, {label}")
