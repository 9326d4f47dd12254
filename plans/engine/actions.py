"""The table of client actions: what a robot can be asked to do, with which parameters."""

from dataclasses import dataclass
from enum import Enum


class ParameterKind(Enum):
    """How clients read a parameter: a WORD up to its last letter or digit, TEXT to the end."""

    WORD = "word"
    TEXT = "text"


@dataclass(frozen=True, slots=True)
class Parameter:
    """One parameter; `values` lists the words clients understand, empty means any."""

    name: str
    kind: ParameterKind
    values: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class ClientAction:
    """One action; its only free text, if any, is its last parameter.

    One that is not `common` is promised only to clients that name it among their capabilities:
    nobody shall wait for a reminder that the robot cannot give.
    """

    name: str
    parameters: tuple[Parameter, ...]
    meaning: str
    common: bool = True


def _text(name: str) -> Parameter:
    return Parameter(name, ParameterKind.TEXT)


def _word(name: str, *values: str) -> Parameter:
    return Parameter(name, ParameterKind.WORD, values)


def _extra(name: str, meaning: str, *parameters: Parameter) -> ClientAction:
    return ClientAction(name, parameters, meaning, common=False)


_LEVEL = ("high", "normal", "low", "louder", "lower", "quieter", "raise", "higher")
_SPEED = ("high", "normal", "low", "faster", "slower")
_WHERE = ("forward", "back", "left", "right")

ACTIONS: tuple[ClientAction, ...] = (
    ClientAction("volume", (_word("level", *_LEVEL),), "Set or step the volume."),
    ClientAction("voicespeed", (_word("level", *_SPEED),), "Set or step the speaking rate."),
    ClientAction("hello", (), "Greet the English way."),
    ClientAction("namaste", (), "Greet the Indian way."),
    ClientAction("konnichiwa", (), "Greet the Japanese way."),
    ClientAction("attention", (), "Wave to get attention."),
    ClientAction("date", (), "Say today's date."),
    ClientAction("time", (), "Say the time."),
    ClientAction("weather", (_text("city"),), "Say the forecast."),
    ClientAction("translate", (_word("language"), _text("what")), "Translate words."),
    ClientAction("dictionary", (_text("what"),), "Give a definition."),
    ClientAction("wikisearch", (_text("what"),), "Read the start of an encyclopaedia's article."),
    ClientAction("playsong", (_text("title"),), "Play a song."),
    ClientAction("playkaraoke", (_text("title"),), "Karaoke on the tablet."),
    ClientAction("playmovie", (_text("title"),), "Play a film or its trailer."),
    ClientAction("showinstructions", (_text("what"),), "Show a how-to video."),
    ClientAction("showexercise", (_text("what"),), "Show a workout."),
    ClientAction("move", (_word("where", *_WHERE),), "Make one small step."),
    ClientAction("go", (_word("where", *_WHERE),), "Go until touched or blocked."),
    ClientAction("learnplace", (_text("where"),), "Store this place on the map."),
    ClientAction("setposition", (_text("where"),), "Be told where it is."),
    ClientAction("goto", (_text("where"),), "Go to a known place."),
    ClientAction("rest", (), "Dock and charge."),
    ClientAction("wakeup", (), "Leave the dock."),
    ClientAction("forgetmap", (), "Empty the map."),
    ClientAction("hug", (), "Give a hug."),
    ClientAction("handshake", (), "Shake hands."),
    ClientAction("privacy", (), "Turn away and cover the eyes until touched."),
    ClientAction("followme", (), "Follow, holding the person's hand."),
    ClientAction("registration", (), "Register a new speaker."),
    ClientAction("alert", (), "Call a member of the staff or a carer at once."),
    _extra("timer", "Ring after so many seconds.", _word("seconds")),
    _extra("alarm", "Ring that day at that time, HHMM.", _word("day"), _word("time")),
    _extra(
        "reminder",
        "Say it after so many seconds, or that day at that time, HHMM.",
        _word("day"),
        _word("time"),
        _word("seconds"),
        _text("what"),
    ),
    _extra("news", "Read the news, perhaps about something.", _text("about")),
    _extra("call", "Call a relative, a friend or a carer.", _text("who")),
    _extra("photo", "Take a photo."),
    _extra("dance", "Dance."),
    _extra("light", "Switch a light.", _word("level", "on", "off", "brighter", "dimmer")),
    _extra("brightness", "Step the brightness of its tablet.", _word("level", "higher", "lower")),
    _extra("quiz", "Play a quiz on the tablet."),
)
COMMON_ACTIONS = frozenset(action.name for action in ACTIONS if action.common)
ACTIONS_BY_NAME = {action.name: action for action in ACTIONS}
