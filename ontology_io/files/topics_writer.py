"""Write a branch file: one line a leaf, blocks for classes (docs/content-format.md)."""

from collections.abc import Iterable

from dialogue.engine.concepts import Frame, Topic, usual_likeliness
from ontology_io.files.emit import flow_list, flow_map, flow_scalar, raw_map, scalar


def write_topics(
    topics: Iterable[Topic], classes: frozenset[str], cultures: tuple[str, ...]
) -> str:
    """Return the text of a branch file; `classes` are the topics with something below them."""
    topics = tuple(topics)
    inner = [topic for topic in topics if topic.key in classes]
    leaves = [topic for topic in topics if topic.key not in classes]
    parts: list[str] = []
    if inner:
        parts += ["classes:", *(_class(topic, cultures) for topic in inner)]
    if leaves:
        parts += ["leaves:", *(_leaf(topic, cultures) for topic in leaves)]
    lines = [_line(topic, frame) for topic in leaves for frame in topic.frames]
    if lines:
        parts += ["lines:", *lines]
    return "\n".join(parts) + "\n"


def _class(topic: Topic, cultures: tuple[str, ...]) -> str:
    lines = [f"  {key}: {value}" for key, value in topic_entries(topic, cultures).items()]
    if topic.frames:
        lines.append("  s:")
        for frame in topic.frames:
            lines += frame_block(frame)
    return "-" + "\n".join(lines)[1:]


def frame_block(frame: Frame) -> list[str]:
    """Return the lines of one sentence in a class or a pool."""
    entries = {key: scalar(text) for key, text in frame.texts.items()}
    return [
        f"    {frame.key.partition('.')[2]}:",
        *(f"      {key}: {value}" for key, value in (_circumstances(frame) | entries).items()),
    ]


def _circumstances(frame: Frame) -> dict[str, str]:
    entries = {}
    if frame.only:
        entries["only"] = flow_list(frame.only)
    if frame.scope:
        entries["scope"] = frame.scope
    if frame.do:
        entries["do"] = flow_scalar(frame.do)
    return entries


def _leaf(topic: Topic, cultures: tuple[str, ...]) -> str:
    return "- " + raw_map(topic_entries(topic, cultures))


def _line(topic: Topic, frame: Frame) -> str:
    texts = {key: flow_scalar(text) for key, text in frame.texts.items()}
    head = {"at": topic.key, "id": frame.key.partition(".")[2]}
    return "- " + raw_map(head | _circumstances(frame) | texts)


def topic_entries(topic: Topic, cultures: tuple[str, ...]) -> dict[str, str]:
    """Return the written entries of a topic, without its sentences, in the canonical order."""
    entries = {"id": topic.key, "is_a": topic.is_a}
    if topic.also:
        entries["also"] = flow_list(topic.also)
    if topic.of:
        entries["of"] = topic.of
    if topic.gentle:
        entries["gentle"] = "yes"
    if topic.stop:
        entries["stop"] = flow_list(topic.stop)
    if topic.pattern:
        entries["pattern"] = flow_scalar(" | ".join(topic.pattern))
    variables = {
        f"{code}.{name}": text
        for code, texts in topic.variables.items()
        for name, text in texts.items()
    }
    if variables:
        entries["vars"] = flow_map(variables)
    entries |= {code: flow_map(fields) for code, fields in topic.names.items()}
    return entries | _recognition(topic, cultures)


def _recognition(topic: Topic, cultures: tuple[str, ...]) -> dict[str, str]:
    entries = {}
    keywords = {
        code: f"{'|'.join(first)} / {'|'.join(second)}"
        for code, (first, second) in topic.keywords.items()
    }
    if keywords:
        entries["kw"] = flow_map(keywords)
    usual = usual_likeliness(topic.of, cultures)
    unusual = [
        f"{code} {short_number(value)}"
        for code, value in topic.likeliness.items()
        if value != usual.get(code)
    ]
    if unusual:
        entries["like"] = " ".join(unusual)
    if topic.individuals:
        entries["individuals"] = flow_map(topic.individuals)
    if topic.see:
        entries["see"] = flow_list(topic.see)
    if topic.note:
        entries["note"] = flow_scalar(topic.note)
    return entries


def short_number(value: float) -> str:
    """Return 0.3 as `.3`, 0 and 1 as they are."""
    return f"{value:.3f}".rstrip("0").rstrip(".").removeprefix("0") or "0"
