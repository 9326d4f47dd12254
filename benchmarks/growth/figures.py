"""One figure with a panel for each way of growing."""

from collections.abc import Sequence
from pathlib import Path

import matplotlib as mpl

mpl.use("Agg")

from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.ticker import FuncFormatter

from benchmarks.growth import rows
from benchmarks.growth.rows import Row, series

COLOURS = ("tab:blue", "tab:orange", "tab:green", "tab:red", "tab:purple")
#: Where states differ a thousandfold: on two logarithmic axes a straight line is in proportion.
SPANNING = frozenset((rows.TOPICS, rows.TALK))
LOGARITHMIC = frozenset((rows.TOPICS, rows.INTENTS, rows.TALK))


def draw(folder: Path, measured: Sequence[Row]) -> list[Path]:
    """Write growth.svg and growth.png; return them."""
    plt.rcParams["svg.hashsalt"] = "cair"
    figure, panels = plt.subplots(4, 3, figsize=(15, 16), layout="constrained")
    for line, section in zip(panels, rows.SECTIONS, strict=True):
        _turn(line[0], section, measured)
        _state(line[1], section, measured)
        _content(line[2], section, measured)
    files = [folder / f"growth.{kind}" for kind in ("svg", "png")]
    for file in files:
        metadata = {"Date": None} if file.suffix == ".svg" else None
        figure.savefig(file, metadata=metadata, dpi=110)
    plt.close(figure)
    return files


def _turn(panel: Axes, section: str, measured: Sequence[Row]) -> None:
    _lines(panel, section, rows.TURN, measured)
    _finish(panel, section, f"CPU of a turn against {section}", "µs")


def _state(panel: Axes, section: str, measured: Sequence[Row]) -> None:
    _lines(panel, section, rows.STATE, measured)
    _finish(panel, section, f"size of the state against {section}", "characters")
    if section in SPANNING:
        panel.set_yscale("log")
        panel.set_ylim(10, 2_000_000)


def _content(panel: Axes, section: str, measured: Sequence[Row]) -> None:
    if not series(measured, section, rows.MEMORY):
        panel.set_axis_off()
        return
    for what, colour in ((rows.PUBLISH, COLOURS[0]), (rows.LOAD, COLOURS[1])):
        for points in series(measured, section, what).values():
            panel.plot(*zip(*points, strict=True), marker="o", color=colour, label=f"{what} (s)")
    right = panel.twinx()
    for points in series(measured, section, rows.MEMORY).values():
        xs, ys = zip(*points, strict=True)
        right.plot(xs, ys, marker="s", color=COLOURS[2], linestyle="--", label="memory (MB)")
    right.set(ylabel="MB", ylim=(0, None))
    lines = [*panel.get_lines(), *right.get_lines()]
    _finish(panel, section, f"content against {section}", "s, CPU")
    panel.legend(lines, [str(line.get_label()) for line in lines], loc="upper left")


def _lines(panel: Axes, section: str, what: str, measured: Sequence[Row]) -> None:
    cases = series(measured, section, what)
    for colour, (case, points) in zip(COLOURS, cases.items(), strict=False):
        panel.plot(*zip(*points, strict=True), marker="o", color=colour, label=case or None)


def _finish(panel: Axes, section: str, title: str, unit: str) -> None:
    panel.set(title=title, xlabel=section, ylabel=unit)
    if section in LOGARITHMIC and not title.startswith("content"):
        panel.set_xscale("log")
    panel.set_ylim(0, panel.get_ylim()[1] * 1.35)
    for axis in (panel.xaxis, panel.yaxis):
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,.10g}"))
    if any(not str(line.get_label()).startswith("_") for line in panel.get_lines()):
        panel.legend(loc="upper left")
