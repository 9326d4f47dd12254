"""How large a sheet may be; settings of the same names in Django's settings win."""

from django.conf import settings

_USUAL = {
    "CAIR_SHEET_ROWS": 2000,
    "CAIR_SHEET_BYTES": 10_000_000,
    "CAIR_SHEET_INFLATED": 60_000_000,
}
#: Columns that are looked at; our sheets have at most a dozen.
MOST_COLUMNS = 40
#: Rows that are looked at, blank ones too.
MOST_SCANNED = 20_000
LONGEST_CELL = 10_000


def limit(name: str) -> int:
    """Return a limit: rows of a sheet, bytes of a file, bytes of what an .xlsx unpacks to."""
    return int(getattr(settings, name, _USUAL[name]))
