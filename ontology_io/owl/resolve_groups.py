"""Which sentences of a place (a topic, a pool) belong together: one frame in its languages."""

from collections.abc import Hashable, Iterable, Sequence
from dataclasses import dataclass, field

from dialogue.engine.concepts import Frame
from ontology_io.owl.file_records import Said
from ontology_io.owl.resolve_notes import Notes, number_in


@dataclass
class Group:
    """Sentences that are one frame; `number` 0 is new. `cultures` are those of individuals.

    `said` is by language; `sure` are those whose id says so.
    """

    type: str
    number: int = 0
    tag: str = ""
    cultures: tuple[str, ...] = ()
    said: dict[str, Said] = field(default_factory=dict)
    sure: list[Said] = field(default_factory=list)

    @property
    def texts(self) -> dict[str, str]:
        """Return the text of each language."""
        return {code: said.text for code, said in self.said.items()}


def grouped(
    where: str, said: Sequence[Said], before: Iterable[Frame], cultures: Sequence[str], notes: Notes
) -> list[Group]:
    """Return the frames of a place in the order of the file.

    `before` are the frames the draft has there, `cultures` the codes in their order.
    """
    table = _Table(where, tuple(before), notes)
    waiting = [left for one in dict.fromkeys(said) if (left := table.by_id(one))]
    waiting = [one for one in waiting if not table.by_text(one)]
    for one in waiting:
        table.by_tag(one)
    return _merged(table.groups.values(), cultures)


class _Table:
    """The groups found so far, each by what makes it one."""

    def __init__(self, where: str, before: Sequence[Frame], notes: Notes) -> None:
        self.where, self.notes = where, notes
        self.groups: dict[tuple[Hashable, ...], Group] = {}
        self.before = {frame.number: frame for frame in before}
        self.keys = {frame.key: frame for frame in before}
        self.texts: dict[tuple[str, str, str], list[Frame]] = {}
        for frame in before:
            for code, text in frame.texts.items():
                self.texts.setdefault((frame.type, code, text), []).append(frame)

    def _add(self, said: Said, number: int, *name: Hashable, sure: bool = False) -> bool:
        """Put a sentence into its group; not where the group speaks this language already."""
        key = (number or name, said.type, said.culture)
        group = self.groups.get(key)
        if group is None:
            group = self.groups[key] = Group(said.type, number)
            group.cultures = (said.culture,) if said.culture else ()
        elif said.language in group.said:
            return group.said[said.language].text == said.text
        group.said[said.language] = said
        group.tag = group.tag or said.frame
        if sure:
            group.sure.append(said)
        return True

    def by_id(self, said: Said) -> Said | None:
        """Take a sentence with an id of ours, of two the one the draft has; return what is left."""
        number = number_in(said.id, "frame")
        if not number:
            return said
        key = (number, said.type, said.culture)
        group, frame = self.groups.get(key), self.before.get(number)
        first = group.said.get(said.language) if group else None
        if group and first and first.text != said.text:
            if frame and frame.texts.get(said.language) == said.text:
                group.said[said.language] = said
                group.sure = [said if one is first else one for one in group.sure]
                said = first
            self.notes.note(
                self.where,
                f"The id {said.id} stands at two sentences; {said.text!r} is taken as new.",
                "Leave the id out of what is new.",
            )
            return said
        self._add(said, number, sure=True)
        return None

    def by_text(self, said: Said) -> bool:
        """Take a sentence without an id that the draft has word for word."""
        for frame in self.texts.get((said.type, said.language, said.text), ()):
            group = self.groups.get((frame.number, said.type, said.culture))
            if group is None or said.language not in group.said:
                return self._add(said, frame.number)
        return False

    def by_tag(self, said: Said) -> None:
        """Take a new sentence: with those of the same frame, else alone."""
        number = 0
        if said.frame:
            frame = self.keys.get(said.frame)
            same = [
                group.number
                for group in self.groups.values()
                if group.tag == said.frame and group.type == said.type
            ]
            number = same[0] if same else frame.number if frame and frame.type == said.type else 0
            if self._add(said, number, "tag", said.frame):
                return
        self._add(said, 0, "text", said.language, said.text)


def _merged(groups: Iterable[Group], cultures: Sequence[str]) -> list[Group]:
    """Return the groups, with those on individuals that say the same in several cultures as one."""
    found: dict[Hashable, Group] = {}
    for index, group in enumerate(groups):
        texts = frozenset(group.texts.items())
        alone = not group.cultures
        key = index if alone else (group.number, group.type, group.tag, texts)
        first = found.setdefault(key, group)
        if first is not group:
            both = {*first.cultures, *group.cultures}
            first.cultures = tuple(code for code in cultures if code in both)
            first.sure += group.sure
    return list(found.values())
