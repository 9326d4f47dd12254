"""What a client should know of an action besides its name: how to take its values."""

from collections.abc import Mapping
from types import MappingProxyType

_STEPS = "`high`, `normal` and `low` set it; "

CLIENT_ADVICE: Mapping[str, str] = MappingProxyType(
    {
        "volume": _STEPS + "`louder`, `raise`, `higher` are a step up; `quieter`, `lower` down.",
        "voicespeed": _STEPS + "`faster` and `slower` are steps.",
        "weather": "`None`: of the place where the robot is.",
        "translate": "Either may be `None`: ask for it.",
        "dictionary": "`None`: ask for the word.",
        "playsong": "`None`: any song the person likes.",
        "playkaraoke": "`None`: let the person choose.",
        "playmovie": "`None`: let the person choose.",
        "showexercise": "`None`: an easy one for the whole body.",
        "move": "`None`: ask for the direction.",
        "go": "`None`: ask for the direction.",
        "learnplace": "`None`: ask what this place is called.",
        "setposition": "`None`: ask where it is.",
        "goto": "`docking station` is its own dock; say so where a place is not on the map.",
        "rest": "Comes after `goto where=docking station`.",
        "alert": "At once: do not wait until `plan_sentence` has been said.",
        "timer": "`seconds` is in digits. `None`: ask how long.",
        "alarm": "`time` is four digits, 0730. `None`: ask for the time.",
        "reminder": "Either `seconds` or `time` (0730) is given; what is not, is `None`.",
        "news": "`None`: the headlines.",
        "call": "`None`: ask whom.",
        "light": "`None`: ask.",
        "brightness": "`None`: ask.",
    }
)
