"""How far a mended sentence is trusted: acted on, asked about, or left alone.

Talk must not become a request: "plan the party" is not "play {title}", "I liked tea" is not
"I like tea". What is left of the trigger, without the mended word, must be proof enough.
"""

from enum import Enum

from plans.engine.alignment import Alignment
from plans.engine.matchers.candidates import Fit
from plans.engine.matchers.patterns_mending import Mended
from plans.engine.matchers.patterns_near import LENGTH_MARK, SMALL

_LONG = 5
_SHORTEST_SKIPPED = 4
_SHORTEST_ALONE = 4
_SURE_WORDS = 3
_PROOF = 4
_SURE_PROOF = 6


class Trust(Enum):
    """What may be done with a candidate."""

    ACT = "act"
    ASK = "ask"
    NO = "no"


def trust_words(fit: Fit, option: Mended) -> Trust:
    """Say how far a sentence of words is trusted after one of them was mended."""
    place = option.place - fit.start
    after = place + len(option.words)
    if after <= 0 or place >= len(fit.names):
        return Trust.ACT if len(option.said) >= _SHORTEST_SKIPPED else Trust.NO
    if place < 0 or after > len(fit.names):
        return _trust_edge(fit, fit.names[0 if place < 0 else -1])
    slots = fit.template.slots
    roles = fit.names[place:after]
    known = sum(1 for name in roles if not name or not slots[name].free)
    if known < len(roles):
        return _trust_half(fit, option, known)
    return _trust_word(fit, option, fit.literal + fit.listed - known)


def _trust_edge(fit: Fit, name: str | None) -> Trust:
    """Judge a lost blank between a skip word and a word of the trigger: "couldyou sing"."""
    return Trust.ACT if name == "" and fit.literal + fit.listed > 1 + fit.free else Trust.NO


def _trust_word(fit: Fit, option: Mended, others: int) -> Trust:
    """Judge a mended word that is one of the trigger's own, with `others` besides."""
    if len(option.words) + option.length > 2:
        return Trust.ACT if others or not fit.free else Trust.ASK
    if option.accent:
        return Trust.ACT if others > fit.free else Trust.ASK
    return _trust_letter(fit, option, others)


def _trust_half(fit: Fit, option: Mended, known: int) -> Trust:
    """Judge a lost blank between a word of the trigger and free words: "lovemusic"."""
    others = fit.literal + fit.listed - known
    return Trust.ASK if known and len(option.words) > 1 and others else Trust.NO


def _trust_letter(fit: Fit, option: Mended, others: int) -> Trust:
    said, ending = len(option.said), _is_ending(option)
    if fit.free:
        if others >= _SURE_WORDS - (said >= _LONG) + ending:
            return Trust.ACT
        return Trust.NO if others <= 1 and (ending or said < _SHORTEST_ALONE) else Trust.ASK
    if others >= _SURE_WORDS or (others and said >= _LONG - (others > 1) and not ending):
        return Trust.ACT
    return Trust.ASK if others or said >= _SHORTEST_ALONE else Trust.NO


def _is_ending(option: Mended) -> bool:
    """Say whether only the end differs, as in "like" and "liked", "piace" and "piaci"."""
    said, meant = option.said, option.words[0]
    shorter = min(len(said), len(meant))
    return said[-1] != meant[-1] and said[: shorter - 1] == meant[: shorter - 1]


def trust_characters(fit: Fit, alignment: Alignment, said: str, meant: str) -> Trust:
    """Say how far a sentence of characters is trusted with one of them mended."""
    proof = fit.literal + fit.listed
    if not (said or meant) or proof < _PROOF:
        return Trust.NO
    harmless = _sounds_alike(fit, alignment, said, meant)
    if harmless:
        return Trust.ACT if proof >= _SURE_PROOF or not fit.free else Trust.ASK
    if _at_the_end(fit, alignment):
        return Trust.NO
    return Trust.ASK if proof >= _SURE_PROOF or not fit.free else Trust.NO


def _sounds_alike(fit: Fit, alignment: Alignment, said: str, meant: str) -> bool:
    if said and meant:
        return SMALL.get(said) == meant or SMALL.get(meant) == said
    if meant:
        return meant == LENGTH_MARK
    place = fit.start + alignment.extra[0]
    units = fit.reading.units
    doubled = said in units[max(place - 1, 0) : place] + units[place + 1 : place + 2]
    return said == LENGTH_MARK or doubled


def _at_the_end(fit: Fit, alignment: Alignment) -> bool:
    """Say whether the error may be another tense: かけた is not かけて."""
    places = alignment.wrong or alignment.extra
    if places:
        return places[0] >= len(fit.names) - 2
    accept = fit.template.machine.accept
    return any(accept >> position & 1 for position in alignment.missing)
