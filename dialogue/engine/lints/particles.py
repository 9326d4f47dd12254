"""G4: which Japanese particles may stand together after a name."""

import re
from functools import lru_cache

from languages.lints import Finding

_PARTICLES = (
    *("から", "まで", "より", "だけ", "など", "って"),
    *("は", "が", "を", "に", "の", "と", "で", "へ", "も", "や", "か"),
)
_ONE = "|".join(_PARTICLES)
#: か and や begin too many words to tell them behind another particle: パンはかごに.
_NEXT = "|".join(one for one in _PARTICLES if one not in ("か", "や"))
#: A particle is over where no kana follows, or a word that often does: お, ご, どんな, いつ …
_OVER = r"(?=[^ぁ-ん]|お|ご|どん|どな|どう|どこ|どの|いつ|よく|なぜ|きっと|$)"
_PAIR = re.compile(rf"\$(?:hasName|toName)(?:\.[a-z]+)?({_ONE})({_NEXT}){_OVER}")

#: The pairs of good sentences.
ALLOWED = frozenset(
    (first, second)
    for first, seconds in {
        "に": "は も",
        "と": "は の も",
        "で": "は も の",
        "へ": "は の も と",
        "から": "は の も が",
        "まで": "は の も に が",
        "より": "は も の",
        "だけ": "は が を に の で も",
        "など": "は が を に の で と も",
        "って": "の",
    }.items()
    for second in seconds.split()
)


@lru_cache(maxsize=16384)
def lint_particles(template: str) -> tuple[Finding, ...]:
    """Return each pair after a name that no good sentence has: 「お茶をは」."""
    return tuple(
        Finding(
            "G4",
            f"「{pair[1]}{pair[2]}」 after a name.",
            "These two particles do not meet.",
            error=False,
        )
        for pair in _PAIR.finditer(template)
        if pair.groups() not in ALLOWED
    )
