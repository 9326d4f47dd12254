"""What the authoring pages do for an expert: keys and places proposed, names kept in step."""

from django.db.models import Max, Model

from dialogue.engine.concepts import usual_likeliness
from dialogue.models import Culture, Frame, Topic, TopicInstance


def next_key(topic: Topic | None, pool: str, type_: str) -> str:
    """Return the key of a new frame: GreenTea.q4 after GreenTea.q3, start.7 after start.6."""
    begin = f"{topic}.{type_}" if topic else f"{pool}."
    rows = topic.frames if topic else Frame.objects.filter(pool=pool)
    keys = rows.filter(key__startswith=begin).values_list("key", flat=True)
    numbers = [int(end) for key in keys if (end := key.removeprefix(begin)).isdecimal()]
    return f"{begin}{max(numbers, default=0) + 1}"


def next_position(model: type[Model]) -> int:
    """Return the place after all others."""
    last: int | None = model._default_manager.aggregate(last=Max("position"))["last"]
    return 0 if last is None else last + 1


def rename_frames(topic: Topic) -> None:
    """Give the frames of a topic that was renamed keys with its new name; numbers stay."""
    frames = [frame for frame in topic.frames.all() if not frame.key.startswith(f"{topic}.")]
    for frame in frames:
        frame.key = f"{topic}.{frame.key.partition('.')[2]}"
    Frame.objects.bulk_update(frames, ["key"], batch_size=400)


def give_likeliness(topic: Topic) -> None:
    """Give a topic an individual in each culture where it has none, with the usual likeliness."""
    cultures = {culture.code: culture for culture in Culture.objects.all()}
    home = topic.home.code if topic.home else ""
    usual = usual_likeliness(home, tuple(cultures))
    present = set(topic.instances.values_list("culture__code", flat=True))
    TopicInstance.objects.bulk_create(
        TopicInstance(topic=topic, culture=cultures[code], likeliness=f"{value:.3f}")
        for code, value in usual.items()
        if code not in present
    )
