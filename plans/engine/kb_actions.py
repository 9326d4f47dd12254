"""The table of KBplan actions: what a plan can do to the knowledge base and the talk."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class KBAction:
    """A KBplan action; the Dialogue Manager has one file for each."""

    name: str
    parameters: tuple[str, ...]
    meaning: str


KB_ACTIONS: tuple[KBAction, ...] = (
    KBAction("setlikeliness", ("topic", "value"), "Set how much the person likes the topic."),
    KBAction("jump", ("topic", "startsentence"), "Go to the topic, begin with that sentence type."),
    KBAction("leave", ("topic",), "Leave the topic (None: this one), stay out of it for a while."),
    KBAction("change", (), "Go to another topic of the agent's choice."),
    KBAction("repeat", (), "Say the last sentence again."),
    KBAction("opinion", ("topic",), "Say what the agent thinks, without a yes/no question."),
    KBAction("more", (), "Stay with the topic and tell or ask more."),
    KBAction("stop", (), "Say goodbye and end the talk."),
    KBAction("forget", (), "Forget what the person likes."),
    KBAction("list", (), "Name some topics there are to talk about."),
    KBAction("abilities", (), "Say what this robot can do."),
    KBAction("listen", ("startsentence",), "Stay with the person: c quietly, w with a question."),
    KBAction("tell", ("kind",), "Tell a joke, a riddle, a story, ...: a line of that pool."),
)
KB_ACTIONS_BY_NAME = {action.name: action for action in KB_ACTIONS}
