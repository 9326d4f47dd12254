"""What experts write about intents, as plain frozen values: slots, triggers, plans, tests."""

import msgspec

SLOT_KINDS = ("text", "topic", "number", "duration", "time", "date", "yes_no")
VALUE_KIND = "value:"


class Slot(msgspec.Struct, frozen=True, kw_only=True):
    """A `{name}` of a trigger: `kind` is one of SLOT_KINDS or `value:<list id>`.

    `questions` asks for it when it is required and missing: `{"en": "Which song?"}`.
    """

    name: str
    kind: str = "text"
    required: bool = False
    questions: dict[str, str] = {}

    @property
    def list_key(self) -> str:
        """Return the id of the value list, or "" for the other kinds."""
        return self.kind.removeprefix(VALUE_KIND) if self.kind.startswith(VALUE_KIND) else ""

    @property
    def free(self) -> bool:
        """Say whether any words can stand in this slot (text and topic)."""
        return self.kind in ("text", "topic")

    @property
    def unbounded(self) -> bool:
        """Say whether the words themselves do not tell where this slot begins and ends."""
        return self.free or self.kind == "yes_no"


class ActionItem(msgspec.Struct, frozen=True, kw_only=True):
    """One action of a plan; a value is a constant or a template such as `{title}`."""

    action: str
    parameters: tuple[tuple[str, str], ...] = ()


class PlanSentence(msgspec.Struct, frozen=True, kw_only=True):
    """What the agent says before the plan; `only` names the cultures it is kept for.

    A sentence with `{title}` is chosen only where the title is known.
    """

    text: str
    only: tuple[str, ...] = ()


class IntentTest(msgspec.Struct, frozen=True, kw_only=True):
    """A stored test; `parameters` None means: must not match this intent."""

    sentence: str
    parameters: dict[str, str] | None = None


class Intent(msgspec.Struct, frozen=True, kw_only=True):
    """One thing a person may ask for; dictionaries are keyed by language ("en").

    `family` groups intents for their authors ("media"). `abilities` name what the agent does for
    it, to be put after "I can": `{"en": "play a song", "it": "mettere una canzone"}`.
    """

    number: int
    key: str
    family: str = ""
    priority: int = 50
    slots: tuple[Slot, ...] = ()
    abilities: dict[str, str] = {}
    triggers: dict[str, tuple[str, ...]]
    plan_sentences: dict[str, tuple[PlanSentence, ...]]
    plan: tuple[ActionItem, ...] = ()
    kbplan: tuple[ActionItem, ...] = ()
    tests: dict[str, tuple[IntentTest, ...]] = {}
    note: str = ""


class ValueList(msgspec.Struct, frozen=True, kw_only=True):
    """Words with one meaning: language -> canonical value -> synonyms."""

    key: str
    values: dict[str, dict[str, tuple[str, ...]]]


class Phrase(msgspec.Struct, frozen=True, kw_only=True):
    """A named piece of pattern per language, written `<key>` in triggers."""

    key: str
    texts: dict[str, str]


class Library(msgspec.Struct, frozen=True, kw_only=True):
    """Everything the Plan Manager knows, before it is compiled."""

    intents: tuple[Intent, ...] = ()
    values: tuple[ValueList, ...] = ()
    phrases: tuple[Phrase, ...] = ()
