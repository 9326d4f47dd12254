"""Names that were probably meant."""

from collections.abc import Collection, Iterable
from difflib import get_close_matches

from django.utils.translation import gettext as _

#: Looking for what was meant takes a while; after so many different slips it is left out.
MOST_LOOKED_FOR = 40


class Suggestions:
    """Finds for a name that does not exist the nearest that does."""

    def __init__(self, names: Iterable[str]) -> None:
        self._names = tuple(names)
        self._folded = {name.casefold(): name for name in self._names}
        self._found: dict[str, str] = {}

    def nearest(self, text: str) -> str:
        """Return the name that was probably meant, or ""."""
        if text not in self._found:
            if len(self._found) >= MOST_LOOKED_FOR or len(text) > 100:
                return self._folded.get(text.casefold(), "")
            self._found[text] = self._look_for(text.casefold())
        return self._found[text]

    def _look_for(self, text: str) -> str:
        if text in self._folded:
            return self._folded[text]
        near = get_close_matches(text, self._folded, n=1, cutoff=0.6)
        return self._folded[near[0]] if near else ""

    def told(self, message: str, text: str) -> str:
        """Return the message, with what was probably meant."""
        meant = self.nearest(text)
        return f"{message} " + _("Did you mean %s?") % meant if meant else message


def listed(names: Collection[str], most: int = 12) -> str:
    """Return names apart by commas; the rest of many as "…"."""
    shown = list(names)[:most]
    return ", ".join(shown) + (", …" if len(names) > most else "")
