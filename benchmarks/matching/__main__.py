"""python -m benchmarks.matching [--quick] [--only identical,noise] [--show 20] [--seed 1]."""

import argparse
from pathlib import Path

from benchmarks.matching import accepts, identical, robust, synthetic, turn
from benchmarks.matching.homeassistant import Templates
from benchmarks.matching.samples import Sample, samples
from benchmarks.matching.targets import Figures, report
from dialogue.engine.content import build_content
from languages.known import LANGUAGES
from ontology_io.files.folder import read_folder

SECTIONS = ("identical", "synthetic", "noise", "accepts", "chat", "turn")
MOST_QUICK = 120
EACH = {"en": 2, "it": 2, "ja": 10}


class Run:
    """One run: what was chosen, and the figures it gave."""

    def __init__(self, chosen: argparse.Namespace) -> None:
        self.chosen = chosen
        self.only = frozenset(chosen.only.split(","))
        self.figures: Figures = {}

    def all(self) -> None:
        """Print every section that was asked for, and the targets."""
        for code in LANGUAGES:
            self._templates(code)
        if "synthetic" in self.only:
            synthetic.compare(self.figures, quick=self.chosen.quick)
        self._own()
        report(self.figures)

    def _templates(self, code: str) -> None:
        if not self.only & {"identical", "noise", "accepts"}:
            return
        templates = Templates(code)
        made = self._chosen(list(samples(templates, EACH[code], self.chosen.seed)))
        if "identical" in self.only:
            identical.compare(templates, made, self.figures, show=self.chosen.show)
        fewer = made if code == "ja" else made[::3]
        if "noise" in self.only:
            robust.on_templates(templates, fewer, self.figures, self.chosen.seed)
        if "accepts" in self.only:
            accepts.templates_left_out(templates, fewer, every=8 if self.chosen.quick else 1)

    def _chosen(self, made: list[Sample]) -> list[Sample]:
        return made[:: -(-len(made) // MOST_QUICK)] if self.chosen.quick else made

    def _own(self) -> None:
        if not self.only & {"noise", "accepts", "chat", "turn"}:
            return
        chosen, figures = self.chosen, self.figures
        base = read_folder(Path("content")).base
        content = build_content(base.knowledge, base.library, 1)
        if "noise" in self.only:
            robust.own(base.library, content.catalogue, figures, chosen.seed)
        if "accepts" in self.only:
            accepts.leaving_one_out(
                base.library, figures, show=chosen.show, every=10 if chosen.quick else 1
            )
        if "chat" in self.only:
            accepts.chat(content.catalogue, figures, seed=chosen.seed, show=chosen.show)
        if "turn" in self.only:
            turn.share(content, figures)


if __name__ == "__main__":
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--quick", action="store_true", help="fewer sentences: a minute at most")
    arguments.add_argument("--only", default=",".join(SECTIONS), help="sections, comma between")
    arguments.add_argument("--show", type=int, default=0, help="print so many failures a section")
    arguments.add_argument("--seed", type=int, default=1)
    Run(arguments.parse_args()).all()
