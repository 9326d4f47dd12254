"""How hostile data is drawn; FUZZ_EXAMPLES=5000 makes the tests of this folder draw more."""

import os
from collections.abc import Callable, Sequence
from random import Random

from hypothesis import HealthCheck, settings
from hypothesis import strategies as st

from plans.engine.catalogue import Catalogue
from plans.engine.patterns import PatternError, parse_pattern, sample

_NASTY = (
    "\0\t\n\r #=\"'|[]{}<>()$%\\/.,;:!?、。？！　éèìñßİıſﬀ"
    "\u0301\u200b\u200d\u202e\u2028\ufeff\ufffe"
)
_SCRIPTS = "aeioutplyAZ019 caffèperché音楽をかけてパンダ・ーｶﾞ緑茶🎵👩‍👩‍👧שלםمرحबा"
UNICODE = st.text(max_size=200) | st.text(alphabet=_NASTY + _SCRIPTS, max_size=200)
LANGUAGES = st.sampled_from(["en", "it", "ja"])


def examples(few: int, **more: object) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Return Hypothesis' settings: `few` examples, or as many as FUZZ_EXAMPLES says."""
    return settings(
        max_examples=int(os.environ.get("FUZZ_EXAMPLES", few)),
        deadline=None,
        suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow],
        **more,  # type: ignore[arg-type]
    )


def mutated(seeds: Sequence[bytes], words: Sequence[str] = ()) -> st.SearchStrategy[bytes]:
    """Return seeds with up to eight cuts, repeats, flips and words put in anywhere."""
    pieces = st.binary(max_size=8) | st.sampled_from([word.encode() for word in words] or [b"\0"])
    edit = st.tuples(st.floats(0, 1), st.floats(0, 0.2), st.booleans(), pieces)
    return st.builds(_edited, st.sampled_from(list(seeds)), st.lists(edit, max_size=8))


def _edited(data: bytes, edits: list[tuple[float, float, bool, bytes]]) -> bytes:
    for place, share, repeated, piece in edits:
        start = int(place * len(data))
        end = start + int(share * len(data))
        data = data[:start] + data[start:end] * (2 * repeated) + piece + data[end:]
    return data[:60_000]


def sentences(catalogue: Catalogue, code: str) -> st.SearchStrategy[str]:
    """Return what people may say: wishes, wishes spoilt, anything at all."""
    triggers = [text for one in catalogue.intents.values() for text in one.triggers.get(code, ())]
    wishes = st.builds(_wish, st.sampled_from(triggers), UNICODE, st.integers(0, 2**32))
    spoilt = st.builds(
        lambda wish, place, text: wish[: int(place * len(wish))] + text + wish[int(place * 9) :],
        wishes,
        st.floats(0, 1),
        UNICODE,
    )
    return wishes | spoilt | UNICODE


def _wish(trigger: str, value: str, seed: int) -> str:
    try:
        pattern = parse_pattern(trigger.replace("<", "").replace(">", ""))
    except PatternError:
        return trigger
    return " ".join(sample(pattern, Random(seed), {}, lambda _: value))
