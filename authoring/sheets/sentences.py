"""The sheet of sentences: one line a frame, all languages abreast."""

import copy
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

from django.core.exceptions import ValidationError
from django.db.models import Q, QuerySet
from django.utils.translation import gettext as _
from django.utils.translation import gettext_lazy

from authoring.sheets.codes import culture_codes, kind_letter
from authoring.sheets.columns import KEY, Choice, Column, language_word, note_errors
from authoring.sheets.places import EVERYTHING, branch_choices, language_choices, numbers_of
from authoring.sheets.records import Record
from authoring.sheets.sheet import Sheet
from authoring.sheets.suggesting import Suggestions, listed
from authoring.sheets.tables import Row
from authoring.sheets.trial import Trial, tried_together
from authoring.topic_page.shape import read_shape
from authoring.topic_page.trial import unreadable
from authoring.topic_page.words import KINDS
from dialogue import models
from dialogue.authoring import next_position
from dialogue.engine import concepts
from dialogue.engine.pools import POOLS
from languages.known import LANGUAGES

PLACE, TYPE, CULTURES, ACTIVITY, WHERE = "topic or pool", "type", "cultures", "activity", "where"
LANGUAGE_COLUMNS = {code: language_word(code) for code in LANGUAGES}
_FIELDS = {"key": KEY, "topic": PLACE, "pool": PLACE, "type": TYPE, "scope": WHERE, "do": ACTIVITY}
#: Begins the value of a filter that is a pool, no branch.
POOL = "pool:"


class Sentences(Sheet):
    """What the robot says about topics and from pools."""

    name = "sentences"
    title = gettext_lazy("Sentences")
    told = gettext_lazy("What the robot says: one line a sentence, all languages abreast.")
    tab = "Sentences"
    writes = ("dialogue.frame", "dialogue.sentence")
    filters = {"branch": gettext_lazy("Branch or pool"), "language": gettext_lazy("Language")}

    def all_columns(self) -> Iterator[Column]:
        """Yield the columns."""
        yield Column(KEY, needed=True, is_name=True)
        yield Column(PLACE)
        yield Column(TYPE, kind_letter)
        yield Column(CULTURES, culture_codes)
        for code, word in LANGUAGE_COLUMNS.items():
            yield Column(word, language=code)
        yield Column(ACTIVITY)
        yield Column(WHERE, lambda text: text.strip().casefold())

    def choices(self, name: str) -> Iterator[Choice]:
        """Yield what a filter offers."""
        if name == "language":
            yield from language_choices()
            return
        yield from branch_choices()
        for pool in POOLS.values():
            yield Choice(f"{POOL}{pool.name}", f"{pool.name}: {_(pool.used_when)}")

    def rows(self, chosen: Mapping[str, str]) -> Iterator[Record]:
        """Yield the frames of a branch or pool in the order of the tree."""
        branch = chosen.get("branch", EVERYTHING)
        frames = _whole(models.Frame.objects.all())
        if branch.startswith(POOL):
            yield from map(self._record, frames.filter(pool=branch.removeprefix(POOL)))
            return
        place = {number: order for order, number in enumerate(numbers_of(read_shape(), branch))}
        kinds = {letter: order for order, letter in enumerate(KINDS)}
        of_topics = frames.filter(topic__isnull=False)
        found = [one for one in of_topics if one.topic_id in place]
        found.sort(
            key=lambda one: (place[one.topic_id or 0], kinds.get(one.type, 99), one.position)
        )
        yield from map(self._record, found)
        if branch == EVERYTHING:
            yield from map(self._record, frames.exclude(pool="").order_by("pool", "position"))

    def _record(self, frame: models.Frame) -> Record:
        sentences = {one.language: one for one in frame.sentences.all()}
        texts = {
            KEY: frame.key,
            PLACE: frame.topic.key if frame.topic else frame.pool,
            TYPE: frame.type,
            CULTURES: " ".join(one.code for one in frame.only.all()),
            ACTIVITY: frame.do,
            WHERE: frame.scope,
        }
        for code, word in LANGUAGE_COLUMNS.items():
            texts[word] = sentences[code].text if code in sentences else ""
        old = {one.name: one.stored(texts[one.name]) for one in self.columns}
        return Record(frame.key, old, row=frame, parts={"sentences": sentences})

    def look_up(self, rows: Sequence[Row]) -> None:
        """Read the frames of the lines, and those beside which new ones would stand."""
        self.topics = {one.key: one for one in models.Topic.objects.only("key")}
        self.cultures = {one.code: one for one in models.Culture.objects.all()}
        self.nearest = Suggestions([*self.topics, *POOLS])
        keys = {row.texts[KEY].strip() for row in rows}
        new = [row.texts for row in rows if not row.texts[KEY].strip()]
        places = {texts.get(PLACE, "").strip() for texts in new}
        beside = Q(topic__key__in=places) | Q(pool__in=places - {""})
        wanted = Q(key__in=keys) | beside if new else Q(key__in=keys)
        frames = list(_whole(models.Frame.objects.filter(wanted)))
        self.known = {one.key: self._record(one) for one in frames}
        self.same = {
            (*_place(old), code, old[word]): record
            for record in self.known.values()
            for code, word in LANGUAGE_COLUMNS.items()
            if (old := record.old or {}).get(word)
        }
        self.position: int | None = None
        self.last: dict[str, int] = {}
        for key in self.known:
            self._count(key)

    def _count(self, key: str) -> None:
        begin = key.rstrip("0123456789")
        number = key.removeprefix(begin)
        if number:
            self.last[begin] = max(self.last.get(begin, 0), int(number))

    def find(self, row: Mapping[str, str]) -> Record | None:
        """Return the frame of this name; of a line without one, the frame that says the same."""
        key = row[KEY].strip()
        if key:
            return self.known[key].again() if key in self.known else None
        new = {one.name: one.tidy(row[one.name]) for one in self.columns if one.name in row}
        for code, word in LANGUAGE_COLUMNS.items():
            record = self.same.get((*_place(new), code, new.get(word, "")))
            if record and not any(_differs(record, new, one) for one in new):
                return record.again()
        return None

    def begin(self, row: Mapping[str, str]) -> Record:
        """Return a new frame, with the next free name where the line has none."""
        key = row[KEY].strip()
        if not key:
            place, letter = _place(
                {PLACE: row.get(PLACE, ""), TYPE: kind_letter(row.get(TYPE, ""))}
            )
            begin = f"{place}.{letter}"
            self.last[begin] = self.last.get(begin, 0) + 1
            key = f"{begin}{self.last[begin]}"
        return Record(key)

    def check(self, record: Record) -> None:
        """Look at one frame and its texts."""
        if record.delete:
            return
        frame = self._frame(record)
        if record.problems:
            return
        try:
            frame.clean_fields(exclude=["topic"])
            frame.clean()
        except ValidationError as error:
            note_errors(record, error, _FIELDS)
        self._check_texts(record)
        record.parts["frame"] = frame

    def _frame(self, record: Record) -> models.Frame:
        """Return the frame as the line wants it, not saved."""
        frame = copy.copy(record.row) if record.row else models.Frame(key=record.key)
        new = record.new
        place, letter = new.get(PLACE, ""), new.get(TYPE, "")
        if record.old and record.changed(PLACE, TYPE):
            words = _("%(key)s keeps its topic and type. Add a new line without key, delete this.")
            record.refuse(PLACE if record.changed(PLACE) else TYPE, words % {"key": record.key})
        if letter and letter not in KINDS:
            words = _("There is no type “%s”. Use a letter:") % letter[:20]
            names = [f"{kind.letter} {kind.name}" for kind in KINDS.values()]
            record.refuse(TYPE, f"{words} {listed(names)}.")
        if not record.row:
            self._settle(record, frame, place, letter)
        for code in new.get(CULTURES, "").split():
            if code not in self.cultures:
                words = _("There is no culture %(code)s. Use: %(known)s.")
                record.refuse(CULTURES, words % {"code": code[:20], "known": listed(self.cultures)})
        if new.get(WHERE, "") not in ("", "self", "below"):
            record.refuse(WHERE, _("Write self, below, or nothing: here and below."))
        frame.do, frame.scope = new.get(ACTIVITY, ""), new.get(WHERE, "")
        return frame

    def _settle(self, record: Record, frame: models.Frame, place: str, letter: str) -> None:
        """Give a new frame its topic or pool."""
        if place in POOLS and place not in self.topics:
            frame.pool = place
        elif place in self.topics:
            frame.topic = self.topics[place]
        elif place:
            words = _("There is no topic or pool “%s”.") % place[:60]
            record.refuse(PLACE, self.nearest.told(words, place))
        else:
            record.refuse(PLACE, _("Write the topic it is about, or the pool."))
        frame.type = letter

    def _check_texts(self, record: Record) -> None:
        texts = _texts(record)
        if not texts:
            record.refuse("", _("Write what it says in one language at least, or delete the line."))
        changed = {c: t for c, t in texts.items() if record.changed(LANGUAGE_COLUMNS[c])}
        for problem in unreadable(changed):
            record.refuse(LANGUAGE_COLUMNS[problem.language], problem.message)

    def check_together(self, records: Sequence[Record]) -> None:
        """Try the changed frames on every topic that would say them."""
        tried = (*LANGUAGE_COLUMNS.values(), ACTIVITY, WHERE)
        trials, by_number = [], {}
        for place, record in enumerate(records):
            frame = record.parts.get("frame")
            if frame is None or record.delete or not record.changed(*tried):
                continue
            number = frame.pk or -2 - place
            by_number[number] = record
            value = concepts.Frame(
                number=number,
                key=frame.key,
                type=frame.type or frame.pool,
                texts=_texts(record),
                scope=frame.scope,
                do=frame.do,
            )
            trials.append(Trial(value, frame.topic_id, frame.pool))
        for number, problems in tried_together(trials).items():
            for problem in problems:
                column = LANGUAGE_COLUMNS.get(problem.language, ACTIVITY)
                by_number[number].refuse(column, problem.message)

    def _next_position(self) -> int:
        """Return the place after all others; asked once, then counted on."""
        if self.position is None:
            self.position = next_position(models.Frame) - 1
        self.position += 1
        return self.position

    def write(self, record: Record) -> None:
        """Save the frame, its cultures and the texts that differ."""
        if record.delete:
            record.row.delete()
            return
        frame = record.parts["frame"]
        if frame.pk is None:
            frame.position = self._next_position()
        if record.changed(ACTIVITY, WHERE):
            frame.full_clean()
            frame.save()
        if record.changed(CULTURES):
            frame.only.set([self.cultures[code] for code in record.new.get(CULTURES, "").split()])
        present: Mapping[str, models.Sentence] = record.parts.get("sentences", {})
        for code, word in LANGUAGE_COLUMNS.items():
            if record.changed(word):
                _write_text(frame, code, record.new.get(word, ""), present.get(code))


def _write_text(frame: models.Frame, code: str, text: str, row: models.Sentence | None) -> None:
    if text:
        row = row or models.Sentence(frame=frame, language=code)
        row.text = text
        row.full_clean(exclude=["frame"])
        row.save()
    elif row:
        row.delete()


def _differs(record: Record, new: Mapping[str, str], column: str) -> bool:
    return column != KEY and (record.old or {}).get(column) != new[column]


def _whole(frames: QuerySet[models.Frame]) -> QuerySet[models.Frame]:
    return frames.select_related("topic").prefetch_related("sentences", "only")


def _place(texts: Mapping[str, Any]) -> tuple[str, str]:
    return str(texts.get(PLACE, "")).strip(), str(texts.get(TYPE, ""))


def _texts(record: Record) -> dict[str, str]:
    words: Iterable[tuple[str, str]] = LANGUAGE_COLUMNS.items()
    return {code: record.new[word] for code, word in words if record.new.get(word)}
