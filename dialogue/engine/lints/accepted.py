"""Remarks that were looked at and are wanted: which, and why."""

from collections.abc import Collection, Iterable
from dataclasses import dataclass

from dialogue.engine.lints.remarks import Remark

STALE = "A1"


@dataclass(frozen=True, slots=True)
class Accepted:
    """Remarks that are no faults: their code, their place, the reason.

    `where` is the key of a topic or sentence; `language` "" holds for all languages.
    """

    code: str
    where: str
    reason: str
    language: str = ""

    def covers(self, remark: Remark) -> bool:
        """Say whether this is a remark that was accepted."""
        same = (self.code, self.where) == (remark.code, remark.where)
        return same and self.language in ("", remark.language)


_MINE = "Who says 私の声 means their own voice, not the robot's."
_ABOUT_THE_ROBOT = (
    *("RobotSelf", "RobotNature", "RobotAbilities", "RobotRest", "RobotFeelings", "RobotVoice"),
    *("RobotMemory", "RobotOwnName", "RobotMakers", "RobotPower", "RobotListening"),
    "RobotLanguages",
)
_SHORT = "People say this short word, and it means nothing else."
_SHORT_IN_ENGLISH = (
    *("Honeybee", "Piglet", "Mother", "Father", "Sadness", "Vegetable", "TeaWithMilk"),
    *("Saxophone", "Oak", "Sunshine", "Haymaking", "TvRadioKind"),
)
_SHORT_IN_ITALIAN = ("AuntUncle", "TeaWithMilk", "Saxophone")
_THEIRS = "Who speaks of someone of theirs is listened to, in their own words."
_NOBODY = "It speaks of {}, not of the person."
ACCEPTED: tuple[Accepted, ...] = (
    Accepted(
        "G2", "ElectricKettle.c1", "'Mettere su' is one verb: 'su' stays as it is.", language="it"
    ),
    Accepted("G2", "SpanishLanguage.c2", "The letter is called 'una esse'.", language="it"),
    Accepted("P1", "Donkey.c2", _NOBODY.format("the donkey"), language="it"),
    Accepted("P1", "Genkan.c1", "'Il benvenuto' is the welcome.", language="it"),
    Accepted("P1", "Shinobue.c1", _NOBODY.format("the pace"), language="it"),
    Accepted("P1", "MariaMontessori.w1", _NOBODY.format("any child"), language="it"),
    *(Accepted("K1", key, _SHORT, language="en") for key in _SHORT_IN_ENGLISH),
    *(Accepted("K1", key, _SHORT, language="it") for key in _SHORT_IN_ITALIAN),
    *(
        Accepted("K2", key, _THEIRS, language="ja")
        for key in ("GreatGrandchild", "SisterInLaw", "TeaFriend", "FamilyFriend")
    ),
    *(Accepted("K2", key, _MINE, language="ja") for key in _ABOUT_THE_ROBOT),
    Accepted("K2", "FirstLove", "'love' at the end of a wish is the robot.", language="en"),
    *(
        Accepted("K2", "RobotNature", "Nobody says 'my being a robot' of a robot.", language=code)
        for code in ("en", "it")
    ),
)


def without_accepted(
    remarks: Iterable[Remark], accepted: Collection[Accepted] = ACCEPTED
) -> list[Remark]:
    """Return the remarks nobody accepted, then one for each acceptance that covers nothing."""
    kept: list[Remark] = []
    used: set[Accepted] = set()
    for remark in remarks:
        covering = [one for one in accepted if one.covers(remark)]
        used.update(covering)
        if not covering:
            kept.append(remark)
    kept += [_stale(one) for one in accepted if one not in used]
    return kept


def _stale(one: Accepted) -> Remark:
    message = f"It is accepted that it falls short of {one.code}, but it does not any more."
    return Remark(STALE, one.where, message, "Remove the line in accepted.py.", one.language)
