"""A sentence that is being written, as the robot will say it of a few topics."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass

from authoring.topic_page.neighbours import names_of
from authoring.topic_page.samples import samples
from authoring.topic_page.shape import Shape, read_shape
from authoring.topic_page.small_knowledge import read_small, saying, who_says, with_frame
from authoring.topic_page.trial import (
    LONGEST,
    Problem,
    Tried,
    pool_problems,
    pool_tried,
    tried,
    unreadable,
)
from dialogue.engine.concepts import Frame
from dialogue.engine.pools import POOLS
from dialogue.engine.sentence_types import SENTENCE_TYPES
from dialogue.models import TopicName
from languages.known import LANGUAGES
from languages.language import FormError

MOST_CHOICES = 200
_NEW = -1


@dataclass(frozen=True, slots=True)
class Draft:
    """What stands in the form: whose sentence, of which kind, and its texts by language.

    `about` is the one topic to try it with (0: samples); `culture` is who hears it.
    """

    owner: int | None
    pool: str
    type: str
    scope: str
    culture: str
    texts: Mapping[str, str]
    about: int = 0

    def frame(self) -> Frame:
        """Return the frame that this would be."""
        letter = self.type if self.type in SENTENCE_TYPES else "c"
        readable = {code: text for code, text in self.texts.items() if text.strip()}
        return Frame(
            key="?", number=_NEW, type=self.pool or letter, texts=readable, scope=self.scope
        )


def read_draft(data: Mapping[str, str]) -> Draft:
    """Return what a form sent; what makes no sense counts as not given."""
    pool = data.get("pool", "")
    return Draft(
        owner=_number(data.get("topic", "")) or None,
        pool=pool if pool in POOLS else "",
        type=data.get("type", ""),
        scope=data.get("scope", "") if data.get("scope") in ("self", "below") else "",
        culture=data.get("culture", "")[:8],
        texts={code: data.get(code, "") for code in LANGUAGES},
        about=_number(data.get("about", "")),
    )


def _number(text: str) -> int:
    return int(text) if text.isascii() and text.isdigit() and len(text) < 10 else 0


def preview(draft: Draft) -> dict[str, object]:
    """Return, ready for JSON, what each language says of each sample, or why it cannot."""
    problems = {one.language: one for one in unreadable(draft.texts)}
    if draft.pool:
        return _answer(_in_pool(draft, problems), problems, [])
    shape = read_shape()
    if draft.owner not in shape.keys:
        return _answer({}, problems, [])
    said, choices = _about_topics(draft, draft.owner or 0, shape, problems)
    return _answer(said, problems, choices)


def _about_topics(
    draft: Draft, owner: int, shape: Shape, problems: Mapping[str, Problem]
) -> tuple[dict[str, list[Tried]], list[dict[str, object]]]:
    among = [one for one in who_says(shape, owner) if draft.scope != "self" or one == owner]
    if draft.scope == "below" and len(among) > 1:
        among.remove(owner)
    if draft.about in among:
        chosen: Sequence[int] = (draft.about,)
    elif draft.about == owner:
        chosen = (owner,)
    else:
        chosen = samples(_names(among))
    texts = {code: text for code, text in draft.texts.items() if code not in problems}
    frame = Draft(draft.owner, "", draft.type, draft.scope, draft.culture, texts).frame()
    small = with_frame(read_small(shape, [owner, *chosen], frames=False), owner, frame)
    nodes = saying(small, _NEW, chosen) or [small.node(one) for one in chosen]
    said = {
        code: [tried(small, _NEW, node, code, draft.culture) for node in nodes]
        for code in frame.texts
    }
    return said, _choices(shape, among)


def _choices(shape: Shape, among: Sequence[int]) -> list[dict[str, object]]:
    called = names_of(shape, among[:MOST_CHOICES])
    return [{"number": number, "name": name} for number, name in called.items()]


def _names(numbers: Sequence[int]) -> dict[int, dict[str, dict[str, str]]]:
    found: dict[int, dict[str, dict[str, str]]] = {number: {} for number in numbers}
    rows = TopicName.objects.filter(topic__in=numbers)
    for number, language, name, fields in rows.values_list("topic", "language", "name", "fields"):
        found[number][language] = {"name": name, **fields}
    return found


def _in_pool(draft: Draft, problems: dict[str, Problem]) -> dict[str, list[Tried]]:
    texts = {code: text for code, text in draft.texts.items() if text and code not in problems}
    problems |= {one.language: one for one in pool_problems(draft.pool, texts)}
    some = TopicName.objects.order_by("topic")[: MOST_CHOICES * len(LANGUAGES)]
    found: dict[int, dict[str, dict[str, str]]] = {}
    for number, language, name, fields in some.values_list("topic", "language", "name", "fields"):
        found.setdefault(number, {})[language] = {"name": name, **fields}
    whole = {number: names for number, names in found.items() if _whole(names)}
    about = samples(whole) if POOLS[draft.pool].variables & {"hasName", "toName"} else ()
    return {
        code: [
            pool_tried(draft.pool, code, text, whole[number][code])
            for number in about or tuple(whole)[:1]
        ]
        for code, text in texts.items()
        if code not in problems
    }


def _whole(names: Mapping[str, Mapping[str, str]]) -> bool:
    """Say whether a topic has a name in every language whose forms can be made."""
    try:
        return all(LANGUAGES[code].name_forms(names[code]) for code in LANGUAGES)
    except (KeyError, FormError):
        return False


def _answer(
    said: Mapping[str, Sequence[Tried]],
    problems: Mapping[str, Problem],
    choices: list[dict[str, object]],
) -> dict[str, object]:
    return {
        "longest": LONGEST,
        "choices": choices,
        "languages": {
            code: {
                "problem": problems[code].message if code in problems else "",
                "position": problems[code].position if code in problems else -1,
                "said": [asdict(one) for one in said.get(code, ())],
            }
            for code in LANGUAGES
        },
    }
