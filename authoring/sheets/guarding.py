"""Cells that a spreadsheet program would take for a formula, made harmless and read back."""

import re

#: What begins a formula in Excel, LibreOffice or Google Sheets, wide letters included.
_STARTS = "=+\\-@\t\r\n＝＋－＠"
_HARMFUL = re.compile(rf"'*[{_STARTS}]")
_GUARDED = re.compile(rf"'+[{_STARTS}]")


def guarded(text: str) -> str:
    """Return the text as it goes out: with a leading apostrophe where it could be a formula."""
    return f"'{text}" if _HARMFUL.match(text) else text


def unguarded(text: str) -> str:
    """Return the text without the apostrophe that `guarded` has put there."""
    return text[1:] if _GUARDED.match(text) else text
