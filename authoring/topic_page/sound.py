"""Leave out of some knowledge what cannot be built, so that one slip does not hide a page."""

import msgspec

from dialogue.engine.concepts import Frame, Knowledge, Topic
from dialogue.engine.findings import Finding
from dialogue.engine.lines import parse_proposal
from dialogue.engine.patterns import PatternError, parse_patterns
from languages.known import LANGUAGES
from languages.language import FormError
from languages.templates import TemplateError, compile_template


def sound(knowledge: Knowledge) -> tuple[Knowledge, list[Finding]]:
    """Return what can be built, and a finding for each thing left out."""
    found: list[Finding] = []
    topics = tuple(_topic(topic, found) for topic in knowledge.topics)
    pools = {
        name: tuple(_frame(frame, found) for frame in frames)
        for name, frames in knowledge.pools.items()
    }
    return msgspec.structs.replace(knowledge, topics=topics, pools=pools), found


def _topic(topic: Topic, found: list[Finding]) -> Topic:
    changes: dict[str, object] = {}
    names = {code: fields for code, fields in topic.names.items() if _named(topic, code, found)}
    if len(names) < len(topic.names):
        changes["names"] = names
    try:
        parse_patterns(topic.pattern)
    except PatternError as error:
        found.append(Finding("D012", topic.key, str(error), "Write for example q r w c [g]."))
        changes["pattern"] = ()
    frames = tuple(_frame(frame, found) for frame in topic.frames)
    if frames != topic.frames:
        changes["frames"] = frames
    return msgspec.structs.replace(topic, **changes) if changes else topic


def _named(topic: Topic, code: str, found: list[Finding]) -> bool:
    if code not in LANGUAGES:
        return False
    try:
        LANGUAGES[code].name_forms(topic.names[code])
    except FormError as error:
        found.append(Finding("D011", topic.key, f"Name in {code}: {error.message}", error.hint))
        return False
    return True


def _frame(frame: Frame, found: list[Finding]) -> Frame:
    changes: dict[str, object] = {}
    texts = {code: text for code, text in frame.texts.items() if _readable(frame, code, found)}
    if len(texts) < len(frame.texts):
        changes["texts"] = texts
    try:
        parse_proposal(frame.do or "none")
    except ValueError as error:
        found.append(Finding("D018", frame.key, str(error), "E.g. playsong title=$hasName."))
        changes["do"] = ""
    return msgspec.structs.replace(frame, **changes) if changes else frame


def _readable(frame: Frame, code: str, found: list[Finding]) -> bool:
    text = frame.texts[code]
    if code not in LANGUAGES or not text:
        return False
    try:
        compile_template(text, code)
    except TemplateError as error:
        hint = "Correct it at that place."
        found.append(Finding("D021", frame.key, f"In {code}: {error}", hint))
        return False
    return True
