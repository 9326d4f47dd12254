"""Compile frames to lines: sentence templates a language, and the proposals of activities."""

from types import MappingProxyType

from dialogue.engine.concepts import Frame
from dialogue.engine.tree import Line, Proposal
from languages.known import LANGUAGES
from languages.templates import Template, compile_template


class ProposalError(ValueError):
    """The activity of a proposal cannot be read: says what is wrong with it."""


def compile_line(frame: Frame, owner: int) -> Line:
    """Return the frame ready to be said. Raises TemplateError or ProposalError."""
    return Line(
        number=frame.number,
        key=frame.key,
        type=frame.type,
        slot=frame.slot,
        owner=owner,
        only=frozenset(frame.only),
        scope=frame.scope,
        templates=MappingProxyType(
            {
                code: compile_template(text, code)
                for code, text in frame.texts.items()
                if text.strip() and code in LANGUAGES
            }
        ),
        proposal=parse_proposal(frame.do) if frame.do else None,
    )


def parse_proposal(text: str) -> Proposal:
    """Return the intent and parameters of e.g. `playsong title=$hasName.bare`.

    As in plan strings, only the last value may hold several words.
    """
    intent, _, rest = text.strip().partition(" ")
    if not intent.isidentifier():
        raise ProposalError(
            f"{text!r} must begin with a plan's name, e.g. playsong title=$hasName."
        )
    parameters = []
    while rest := rest.strip():
        name, equals, rest = rest.partition("=")
        if not equals or not name.isidentifier():
            raise ProposalError(f"{name!r} in {text!r} is no parameter; write name=value.")
        value, rest = _value_and_rest(rest)
        parameters.append((name, _in_every_language(value)))
    return Proposal(intent, tuple(parameters))


def _value_and_rest(text: str) -> tuple[str, str]:
    """Split at the last blank before the next `name=`."""
    head, equals, _ = text.partition("=")
    if not equals:
        return text.strip(), ""
    value, _, _ = head.rpartition(" ")
    return value.strip(), text[len(value) :]


def _in_every_language(value: str) -> MappingProxyType[str, Template]:
    return MappingProxyType(
        {code: compile_template(value, code, sentence=False) for code in LANGUAGES}
    )
