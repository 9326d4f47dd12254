"""The sheet of topics: one line a topic, its names and keywords in each language."""

import copy
from collections.abc import Iterator, Mapping, Sequence

from django.core.exceptions import ValidationError
from django.db.models import QuerySet
from django.utils.translation import gettext as _
from django.utils.translation import gettext_lazy

from authoring.sheets.codes import fields_text, keywords, keywords_text, name_fields
from authoring.sheets.columns import Choice, Column, language_word, note_errors
from authoring.sheets.places import EVERYTHING, branch_choices, language_choices, numbers_of
from authoring.sheets.records import Record
from authoring.sheets.sheet import Sheet
from authoring.sheets.suggesting import Suggestions, listed
from authoring.sheets.tables import Row
from authoring.sheets.topic_parts import check_parts, write_parts
from authoring.sheets.topic_tree import Change, misplaced
from authoring.topic_page.shape import read_shape
from dialogue import models
from dialogue.authoring import give_likeliness, next_position
from dialogue.engine.concepts import ROOT
from languages.known import LANGUAGES

NAME, IS_A, HOME, NOTE = "name in the ontology", "is a", "home", "note"
_FIELDS = {"key": NAME, "note": NOTE, "parent": IS_A, "home": HOME}


class Topics(Sheet):
    """What topics are called and by which words they are recognised."""

    name = "topics"
    title = gettext_lazy("Topics")
    told = gettext_lazy(
        "Topics: where they stand, what they are called, the words that lead there."
    )
    tab = "Topics"
    writes = ("dialogue.topic", "dialogue.topicname", "dialogue.keywordset")
    filters = {"branch": gettext_lazy("Branch"), "language": gettext_lazy("Language")}

    def all_columns(self) -> Iterator[Column]:
        """Yield the columns, three for each language."""
        yield Column(NAME, needed=True, is_name=True)
        yield Column(IS_A)
        yield Column(HOME, lambda text: text.strip().upper())
        for code in LANGUAGES:
            word = language_word(code)
            yield Column(f"{word} name", language=code)
            yield Column(f"{word} forms", name_fields, language=code)
            yield Column(f"{word} keywords", keywords, language=code)
        yield Column(NOTE)

    def choices(self, name: str) -> Iterator[Choice]:
        """Yield what a filter offers."""
        return language_choices() if name == "language" else branch_choices()

    def rows(self, chosen: Mapping[str, str]) -> Iterator[Record]:
        """Yield the topics of a branch in the order of the tree."""
        shape = read_shape()
        order = numbers_of(shape, chosen.get("branch", EVERYTHING))
        wanted = set(order)
        found = {one.pk: one for one in _whole(models.Topic.objects.all()) if one.pk in wanted}
        yield from (self._record(found[number]) for number in order if number in found)

    def _record(self, topic: models.Topic) -> Record:
        names = {one.language: one for one in topic.names.all()}
        words = {one.language: one for one in topic.keywords.all()}
        texts = {
            NAME: topic.key,
            IS_A: topic.parent.key if topic.parent else ROOT,
            HOME: topic.home.code if topic.home else "",
            NOTE: topic.note,
        }
        for code in LANGUAGES:
            name, known = names.get(code), words.get(code)
            word = language_word(code)
            texts[f"{word} name"] = name.name if name else ""
            texts[f"{word} forms"] = fields_text(name.fields) if name else ""
            texts[f"{word} keywords"] = keywords_text(known.first, known.second) if known else ""
        old = {one.name: one.stored(texts[one.name]) for one in self.columns}
        return Record(topic.key, old, row=topic, parts={"names": names, "keywords": words})

    def look_up(self, rows: Sequence[Row]) -> None:
        """Read the topics of the lines, and the shape of the whole tree."""
        self.shape = read_shape()
        self.numbers = {key: number for number, key in self.shape.keys.items()}
        self.cultures = {one.code: one for one in models.Culture.objects.all()}
        self.coming = {row.texts[NAME].strip() for row in rows}
        self.nearest = Suggestions([*self.numbers, ROOT])
        found = _whole(models.Topic.objects.filter(key__in=self.coming))
        self.known = {one.key: self._record(one) for one in found}
        self.position: int | None = None

    def find(self, row: Mapping[str, str]) -> Record | None:
        """Return the topic of this name."""
        key = row[NAME].strip()
        if not key:
            raise ValidationError({NAME: _("Write the name in the ontology, e.g. GreenTea.")})
        return self.known[key].again() if key in self.known else None

    def begin(self, row: Mapping[str, str]) -> Record:
        """Return a new topic."""
        return Record(row[NAME].strip())

    def check(self, record: Record) -> None:
        """Look at one topic, its names and its keywords."""
        if record.delete:
            return
        topic = copy.copy(record.row) if record.row else models.Topic(key=record.key)
        topic.note = record.new.get(NOTE, "")
        above, home = record.new.get(IS_A, ""), record.new.get(HOME, "")
        if not above:
            record.refuse(IS_A, _("Write the topic above it, or %s for a branch.") % ROOT)
        elif above != ROOT and above not in self.numbers and above not in self.coming:
            words = _("There is no topic “%s”.") % above[:60]
            record.refuse(IS_A, self.nearest.told(words, above))
        if home and home not in self.cultures:
            words = _("There is no culture %(code)s. Use: %(known)s.")
            record.refuse(HOME, words % {"code": home[:20], "known": listed(self.cultures)})
        topic.home = self.cultures.get(home)
        try:
            topic.clean_fields(exclude=["parent", "home"])
        except ValidationError as error:
            note_errors(record, error, _FIELDS)
        check_parts(record)
        record.parts["topic"] = topic

    def check_together(self, records: Sequence[Record]) -> None:
        """Refuse what would not make a tree; tell what is deleted with a topic."""
        by_key = {record.key: record for record in records}
        changes = [
            Change(one.key, one.new.get(IS_A, ROOT), is_new=one.old is None, gone=one.delete)
            for one in records
        ]
        for key, message in misplaced(self.shape, changes):
            by_key[key].refuse(IS_A if not by_key[key].delete else "delete", message)
        gone = [record for record in records if record.delete]
        counts = _sentences([record.row.pk for record in gone])
        for record in gone:
            count = counts.get(record.row.pk, 0)
            record.note = _("Its sentences are deleted too: %d.") % count if count else ""

    def in_order(self, records: Sequence[Record]) -> Sequence[Record]:
        """Return what is written from the top down, then what is deleted from below."""
        above = {
            key: self.shape.keys.get(self.shape.parents[n] or 0, ROOT)
            for key, n in self.numbers.items()
        }
        later = above | {one.key: one.new.get(IS_A, ROOT) for one in records if not one.delete}
        kept = sorted(
            (one for one in records if not one.delete), key=lambda one: _depth(one.key, later)
        )
        gone = sorted(
            (one for one in records if one.delete), key=lambda one: -_depth(one.key, above)
        )
        return [*kept, *gone]

    def write(self, record: Record) -> None:
        """Save the topic, its names and its keywords."""
        if record.delete:
            record.row.delete()
            return
        topic: models.Topic = record.parts["topic"]
        is_new = topic.pk is None
        if record.changed(IS_A, HOME, NOTE):
            above = record.new[IS_A]
            topic.parent = None if above == ROOT else models.Topic.objects.get(key=above)
            if is_new:
                topic.position = self._next_position()
            topic.full_clean()
            topic.save()
        write_parts(record, topic)
        if is_new:
            give_likeliness(topic)

    def _next_position(self) -> int:
        if self.position is None:
            self.position = next_position(models.Topic) - 1
        self.position += 1
        return self.position


def _whole(topics: QuerySet[models.Topic]) -> QuerySet[models.Topic]:
    return topics.select_related("parent", "home").prefetch_related("names", "keywords")


def _sentences(numbers: Sequence[int]) -> dict[int, int]:
    found: dict[int, int] = {}
    topics = models.Frame.objects.filter(topic_id__in=numbers).order_by() if numbers else ()
    for frame in topics:
        found[frame.topic_id or 0] = found.get(frame.topic_id or 0, 0) + 1
    return found


def _depth(key: str, above: Mapping[str, str]) -> int:
    depth, passed = 0, {key}
    while (key := above.get(key, ROOT)) != ROOT and key not in passed:
        passed.add(key)
        depth += 1
    return depth
