"""What a chat looks like: in colours and tables with rich, or line by line for pipes."""

from __future__ import print_function

import contextlib
import io
import sys

LABELS = {"agent": "agent:", "you": "you:", "plan": "plan:", "robot": "robot:", "note": ""}
PROMPT = "you:   "
GOODBYE = "Goodbye, and thank you for the talk."


def utf8_streams():
    """Let the standard streams be UTF-8, whatever the locale says; strange bytes do no harm."""
    for name in ("stdin", "stdout", "stderr"):
        stream = getattr(sys, name)
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(encoding="utf-8", errors="replace")
        elif hasattr(stream, "buffer"):  # Python 3.6
            wrapped = io.TextIOWrapper(
                stream.buffer, encoding="utf-8", errors="replace", line_buffering=True
            )
            setattr(sys, name, wrapped)


class PlainScreen:
    """Lines of text, one thing each; what comes through a pipe is shown as if it were typed."""

    def __init__(self):
        self._typed = sys.stdin.isatty()

    def read(self):
        """Return the next line of the person. Raises EOFError at the end."""
        if self._typed:
            return input(PROMPT)
        line = sys.stdin.readline()
        if not line:
            raise EOFError
        line = line.rstrip("\r\n")
        if line.strip():
            self.show("you", line)
        return line

    def show(self, who, text):
        """Show a line: who is a key of LABELS."""
        print("%-6s %s" % (LABELS[who], text) if LABELS[who] else text, flush=True)

    def plan(self, rows):
        """Show a plan: (action, its parameters, what a robot does) for each."""
        for action, parameters, _ in rows:
            self.show("plan", " ".join(part for part in (action, parameters) if part))

    def table(self, title, _, rows):
        """Show a table."""
        if title:
            print(title)
        width = max([len(row[0]) for row in rows] or [0])
        for row in rows:
            cells = ["", row[0].ljust(width)] + list(row[1:])
            print("  ".join(cells).rstrip(), flush=True)

    def waiting(self):
        """Show, as long as the context lasts, that the server is working."""
        return _Nothing()

    def end(self):
        """Take leave of whoever typed."""
        if self._typed:
            print("\n" + GOODBYE)


class _Nothing:
    def __enter__(self):
        return self

    def __exit__(self, *_):
        return None


STYLES = {"agent": "bold cyan", "you": "bold green", "robot": "magenta", "note": "dim", "plan": ""}


class RichScreen:
    """Colours, tables and a spinner. Texts are shown as they are: `[x]` is no markup."""

    def __init__(self):
        from rich.console import Console

        with contextlib.suppress(ImportError):
            import readline  # noqa: F401 - input() then knows arrows and earlier lines
        self._console = Console(highlight=False)

    def read(self):
        """Return the next line of the person. Raises EOFError at the end."""
        return input(PROMPT)

    def show(self, who, text):
        """Show a text; its lines stand below each other."""
        from rich.table import Table

        grid = Table.grid(padding=(0, 1))
        if LABELS[who]:
            grid.add_column(width=6)
            grid.add_column(overflow="fold")
            grid.add_row(self._text(LABELS[who], who), self._text(text, who, label=False))
        else:
            grid.add_column(overflow="fold")
            grid.add_row(self._text(text, who))
        self._console.print(grid)

    def plan(self, rows):
        """Show a plan: (action, its parameters, what a robot does) for each."""
        self.table("", ("action", "parameters", "what a robot does"), rows)

    def table(self, title, names, rows):
        """Show a table, as wide as the terminal at most."""
        from rich import box
        from rich.table import Table

        table = Table(box=box.ROUNDED, title=self._text(title, "note") if title else None)
        table.title_justify = "left"
        for name in names:
            table.add_column(self._text(name, "note"), overflow="fold")
        for row in rows:
            table.add_row(*[self._text(cell, "plan") for cell in row])
        self._console.print(table)

    def waiting(self):
        """Show, as long as the context lasts, that the server is working."""
        return self._console.status("", spinner="dots")

    def end(self):
        """Take leave."""
        self._console.print()
        self.show("note", GOODBYE)

    def _text(self, text, who, label=True):
        from rich.text import Text

        return Text(text, style=STYLES[who] if label or who in ("robot", "note") else "")


def screen(plain):
    """Return the screen that fits: rich where it is installed and somebody is looking."""
    if plain or not (sys.stdin.isatty() and sys.stdout.isatty()):
        return PlainScreen()
    try:
        return RichScreen()
    except ImportError:
        print("(For colours and tables: pip install 'cair-client[cli]')")
        return PlainScreen()
