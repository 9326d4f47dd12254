"""Draws docs/pictures/ontology-layers.svg: `python -m tests.ontology.ontology_picture`."""

from pathlib import Path
from typing import NamedTuple
from xml.sax.saxutils import escape

PICTURE = Path(__file__).resolve().parents[2] / "docs/pictures/ontology-layers.svg"

STYLE = """\
svg { font-family: system-ui, sans-serif; font-size: 14px; }
.paper { fill: #ffffff; }
.band { fill: #f2f4f7; stroke: #c3c9d2; }
.tree { fill: #eef6f0; stroke: #b4cbb9; }
text { fill: #1c2430; }
.title { font-weight: 600; font-size: 15px; }
.small { font-size: 12px; fill: #46505e; }
.box { fill: #ffffff; stroke: #5a6675; stroke-width: 1.5; }
.person { stroke: #a3470c; stroke-width: 2; }
.line { stroke: #5a6675; stroke-width: 1.5; fill: none; }
.dashed { stroke-dasharray: 5 4; }
.link { stroke: #1a6b8f; }
.own { stroke: #a3470c; }
.head { fill: #5a6675; }
.link-head { fill: #1a6b8f; }
.own-head { fill: #a3470c; }
@media (prefers-color-scheme: dark) {
  .paper { fill: #12161c; }
  .band { fill: #1b212a; stroke: #3a4452; }
  .tree { fill: #18251d; stroke: #35503d; }
  text { fill: #e6eaf0; }
  .small { fill: #b4bdca; }
  .box { fill: #262e39; stroke: #9aa6b5; }
  .person { stroke: #f0a36b; }
  .line { stroke: #9aa6b5; }
  .link { stroke: #6fc1e4; }
  .own { stroke: #f0a36b; }
  .head { fill: #9aa6b5; }
  .link-head { fill: #6fc1e4; }
  .own-head { fill: #f0a36b; }
}
"""

WORDS = (
    "The three layers of the ontology and the Dialogue Tree. TBox: Drink has the subclasses Tea, "
    "Coffee and Milk, Tea has GreenTea. CS-ABox: EN_TEA, EN_COFFEE, EN_MILK and EN_GREENTEA are "
    "individuals of these classes with a likeliness; EN_TEA hasTopic EN_MILK. PS-ABox: EN_TEA "
    "hasSpecific DS_TEA with likeliness 0.9. In the tree Tea, with 0.9, lies below Drink, "
    "GreenTea below Tea, and a link leads from Tea to Milk."
)


class Box(NamedTuple):
    """A box around its centre, with its lines of text; classes have round ends."""

    x: int
    y: int
    lines: tuple[str, ...]
    width: int = 124
    kind: str = "box"
    round: int = 6

    def drawn(self) -> str:
        height = 14 + 18 * len(self.lines)
        left, top = self.x - self.width // 2, self.y - height // 2
        shape = (
            f'<rect class="{self.kind}" x="{left}" y="{top}" width="{self.width}" '
            f'height="{height}" rx="{self.round}"/>'
        )
        first = self.y - 9 * (len(self.lines) - 1) + 5
        return shape + "".join(
            text(self.x, first + 18 * place, line, "small" if place else "", "middle")
            for place, line in enumerate(self.lines)
        )


def text(x: int, y: int, words: str, kind: str = "small", anchor: str = "start") -> str:
    """Return a line of text."""
    named = f' class="{kind}"' if kind else ""
    return f'<text{named} x="{x}" y="{y}" text-anchor="{anchor}">{escape(words)}</text>'


def arrow(path: str, kind: str = "line", head: str = "head") -> str:
    """Return an arrow along a path."""
    return f'<path class="{kind}" d="{path}" marker-end="url(#{head})"/>'


def _band(y: int, height: int, title: str, words: str, down: int = 24) -> str:
    return (
        f'<rect class="band" x="16" y="{y}" width="644" height="{height}" rx="8"/>'
        + text(30, y + down, title, "title")
        + text(30, y + down + 18, words)
    )


def _marker(name: str) -> str:
    return (
        f'<marker id="{name}" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="8" '
        f'markerHeight="8" orient="auto"><path class="{name}" d="M0 1 10 5 0 9z"/></marker>'
    )


def _classes() -> list[str]:
    return [
        _band(16, 300, "TBox", "what exists, for all cultures"),
        Box(325, 52, ("Topic",), round=16).drawn(),
        Box(325, 124, ("Drink",), round=16).drawn(),
        Box(250, 206, ("Tea",), round=16).drawn(),
        Box(400, 206, ("Coffee",), round=16).drawn(),
        Box(550, 206, ("Milk",), round=16).drawn(),
        Box(110, 276, ("GreenTea",), round=16).drawn(),
        arrow("M325 108 V70"),
        arrow("M250 190 L308 142"),
        arrow("M400 190 L342 142"),
        arrow("M550 190 L390 130"),
        arrow("M110 260 L190 216"),
        text(398, 94, "hasQuestion"),
        text(398, 112, "“Do you like $hasName?”"),
        text(118, 236, "subClassOf", "small", "end"),
    ]


def _cultures() -> list[str]:
    individuals = (
        (110, "EN_GREENTEA", "0.5"),
        (250, "EN_TEA", "0.7"),
        (400, "EN_COFFEE", "0.5"),
        (550, "EN_MILK", "0.5"),
    )
    boxes = [
        Box(x, 386, (name, f"hasLikeliness {value}"), width=128).drawn()
        for x, name, value in individuals
    ]
    return [
        _band(328, 160, "CS-ABox", "one individual a culture", down=126),
        *boxes,
        arrow("M110 361 V294", "line dashed"),
        *(arrow(f"M{x} 361 V224", "line dashed") for x in (250, 400, 550)),
        text(118, 346, "rdf:type"),
        arrow("M290 411 C330 452 490 452 530 413", "line link", "link-head"),
        text(410, 462, "hasTopic", "small", "middle"),
    ]


def _person() -> list[str]:
    return [
        _band(500, 116, "PS-ABox", "Mrs Dorothy Smith"),
        Box(250, 574, ("DS_TEA", "hasLikeliness 0.9"), 128, "box person").drawn(),
        arrow("M250 411 V547", "line own", "own-head"),
        text(258, 520, "hasSpecific"),
        text(334, 562, "in the dialogue state, with the client;"),
        text(334, 580, "the server keeps none of it"),
    ]


def _tree() -> list[str]:
    return [
        '<rect class="tree" x="676" y="16" width="328" height="600" rx="8"/>',
        text(690, 40, "Dialogue Tree", "title"),
        text(690, 58, "for Mrs Smith, in English"),
        Box(840, 124, ("drinks", "0.5 · EN_DRINK"), 112).drawn(),
        Box(742, 250, ("tea", "0.9 · DS_TEA"), 100, "box person").drawn(),
        Box(846, 250, ("coffee", "0.5"), 80).drawn(),
        Box(944, 250, ("milk", "0.5"), 80).drawn(),
        Box(742, 390, ("green tea", "0.5"), 100).drawn(),
        arrow("M820 149 L752 223"),
        arrow("M840 149 L845 223"),
        arrow("M862 149 L936 223"),
        arrow("M742 275 V363"),
        arrow("M778 275 C820 326 890 326 932 277", "line link", "link-head"),
        text(854, 332, "leads to"),
        text(752, 330, "child"),
        text(690, 462, "“Do you like tea?”", ""),
        text(690, 484, "“Do you like green tea?”", ""),
        text(690, 512, "One sentence at the class Drink,"),
        text(690, 530, "said of all that lies below it."),
        text(690, 560, "A class and its individual make a topic;"),
        text(690, 578, "subclasses become children,"),
        text(690, 596, "hasTopic becomes a link."),
    ]


def picture() -> str:
    """Return the picture as SVG, readable on light and dark pages."""
    parts = [
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1020 632" role="img">',
        "<title>Three layers and the Dialogue Tree</title>",
        f"<desc>{escape(WORDS)}</desc>",
        f"<style>\n{STYLE}</style>",
        f"<defs>{''.join(map(_marker, ('head', 'link-head', 'own-head')))}</defs>",
        '<rect class="paper" width="1020" height="632"/>',
        *_classes(),
        *_cultures(),
        *_person(),
        *_tree(),
        "</svg>",
    ]
    return "\n".join(parts) + "\n"


if __name__ == "__main__":
    PICTURE.write_text(picture(), encoding="utf-8")
