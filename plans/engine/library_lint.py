"""All checks of a library that compiles: conflicts, completeness, what was accepted."""

from collections.abc import Collection

from plans.engine.accepted import ACCEPTED, Accepted, without_accepted
from plans.engine.catalogue import Catalogue
from plans.engine.completeness import completeness
from plans.engine.conflicts import conflicts
from plans.engine.intents import Library
from plans.engine.remarks import Remark


def lint(
    library: Library,
    catalogue: Catalogue,
    *,
    intents: Collection[str] = (),
    languages: Collection[str] = (),
    accepted: Collection[Accepted] = ACCEPTED,
) -> list[Remark]:
    """Return all remarks but the accepted ones; with `intents`, about these intents only.

    An acceptance that covers nothing any more is a remark too, where everything was checked.
    """
    found = [
        *conflicts(library, catalogue, intents=intents, languages=languages),
        *completeness(library, intents=intents, languages=languages),
    ]
    kept, idle = without_accepted(found, accepted)
    if not intents and not languages:
        kept += [_idle(each) for each in idle if each.where in catalogue.intents]
    return sorted(kept, key=lambda remark: (not remark.error, remark.code))


def _idle(accepted: Accepted) -> Remark:
    other = f" with {accepted.other}" if accepted.other else ""
    text = f"{accepted.code}{other} was accepted, but is no longer there; delete that line."
    return Remark("C015", accepted.where, accepted.language, text)
