"""The small form in which a sentence is changed on its topic's page, in all languages at once."""

from collections.abc import Iterable, Mapping
from typing import Any

from django import forms
from django.db import transaction
from django.utils.translation import gettext_lazy as _

from authoring.history.conflicts import digest
from authoring.history.history import changes, history_of
from authoring.topic_page.refusals import refusals
from authoring.topic_page.trial import LONGEST
from authoring.topic_page.words import LANGUAGE_NAMES
from dialogue import models
from dialogue.engine import concepts
from languages.known import LANGUAGES


class TextsForm(forms.Form):
    """The words of one frame by language; `seen` is a digest of what the person was shown.

    `conflict` says that somebody else has changed the frame since: then nothing is valid, the
    form holds the person's words, and its errors what stands there now.
    """

    seen = forms.CharField(widget=forms.HiddenInput, required=False, max_length=64)

    data: Any

    def __init__(self, frame: models.Frame, data: Any = None) -> None:
        self.frame = frame
        self.rows = {row.language: row for row in frame.sentences.all()}
        self.stored = {code: row.text for code, row in self.rows.items()}
        now, prefix = _digest(frame, self.rows.values()), f"s{frame.pk}"
        super().__init__(data, initial={**self.stored, "seen": now}, prefix=prefix)
        self.conflict = data is not None and data.get(self.add_prefix("seen")) != now
        if self.conflict:
            self.data = self._mine() | {self.add_prefix("seen"): now}
        for code in LANGUAGES:
            self.fields[code] = forms.CharField(
                label=str(LANGUAGE_NAMES[code]),
                max_length=LONGEST,
                required=code in self.rows,
                error_messages={"required": _("Write the sentence.")},
                widget=forms.Textarea(
                    attrs={"rows": 2, "lang": code, "data-language": code, "class": "sentence"}
                ),
            )

    def _mine(self) -> dict[str, Any]:
        """Return what was posted, with the words of somebody else where the person has none."""
        mine = {self.add_prefix(code): text for code, text in self.stored.items()}
        return mine | {name: text for name, text in self.data.items() if text.strip()}

    def texts(self) -> list[Any]:
        """Return the fields of the languages."""
        return [self[code] for code in LANGUAGES]

    def clean(self) -> dict[str, Any]:
        """Refuse what cannot be said, and what would overwrite the words of somebody else."""
        cleaned: dict[str, Any] = super().clean() or self.cleaned_data
        if self.conflict:
            self._tell_of_others()
        elif not self.errors:
            for problem in refusals(self._as_frame(cleaned), self.frame.topic_id, self.frame.pool):
                self.add_error(problem.language or None, problem.message)
        return cleaned

    def _tell_of_others(self) -> None:
        last = next(iter(changes(history_of(self.frame), 0, 1)), None)
        again = _("Nothing of yours has been saved yet. Save again to put your words in its place.")
        told = _("Somebody else has changed this sentence meanwhile.")
        who = [f"{last.words.rstrip('.:')}."] if last else []
        self.add_error(None, " ".join(map(str, (told, *who, again))))
        for code in LANGUAGES:
            mine, now = str(self[code].value() or "").strip(), self.stored.get(code, "")
            if mine != now:
                there = _("It says now: %s") % now if now else _("It has no words now.")
                self.add_error(code, there)

    def _as_frame(self, cleaned: Mapping[str, str]) -> concepts.Frame:
        return concepts.Frame(
            number=self.frame.pk,
            key=self.frame.key,
            type=self.frame.type or self.frame.pool,
            texts={code: cleaned[code] for code in LANGUAGES if cleaned.get(code)},
            scope=self.frame.scope,
            do=self.frame.do,
        )

    @transaction.atomic
    def save(self) -> None:
        """Save the sentences that were changed."""
        for code in LANGUAGES:
            text = self.cleaned_data.get(code, "")
            row = self.rows.get(code) or models.Sentence(frame=self.frame, language=code)
            if text and text != row.text:
                row.text = text
                row.full_clean()
                row.save()


def _digest(frame: models.Frame, rows: Iterable[models.Sentence]) -> str:
    return digest(frame, {"only": [one.pk for one in frame.only.all()]}, rows)
