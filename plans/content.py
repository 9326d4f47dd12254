"""Read the rows of the Plan Manager into plain values (seven queries, whatever the size)."""

from collections import defaultdict
from collections.abc import Iterable
from typing import Protocol, TypeVar

from languages.known import LANGUAGES
from plans import models
from plans.engine import intents as values


class _OfIntent(Protocol):
    intent_id: int


Row = TypeVar("Row", bound=_OfIntent)
Rows = dict[int, list[Row]]


def read_library() -> values.Library:
    """Return all intents, value lists and phrases of the draft."""
    slots = _grouped(models.Slot.objects.all())
    triggers = _grouped(models.Trigger.objects.all())
    sentences = _grouped(models.PlanSentence.objects.all())
    plans = _grouped(models.PlanAction.objects.all())
    kbplans = _grouped(models.KBPlanAction.objects.all())
    tests = _grouped(models.IntentTest.objects.all())
    return values.Library(
        intents=tuple(
            values.Intent(
                number=row.pk,
                key=row.key,
                family=row.family,
                priority=row.priority,
                abilities=row.abilities,
                note=row.note,
                slots=tuple(map(_slot, slots[row.pk])),
                triggers={
                    code: tuple(one.text for one in these)
                    for code, these in _by_language(triggers[row.pk]).items()
                },
                plan_sentences={
                    code: tuple(
                        values.PlanSentence(text=one.text, only=tuple(one.only.split()))
                        for one in these
                    )
                    for code, these in _by_language(sentences[row.pk]).items()
                },
                plan=tuple(map(_action, plans[row.pk])),
                kbplan=tuple(map(_action, kbplans[row.pk])),
                tests={
                    code: tuple(map(_test, these))
                    for code, these in _by_language(tests[row.pk]).items()
                },
            )
            for row in models.Intent.objects.all()
        ),
        values=tuple(
            values.ValueList(
                key=row.key,
                values={
                    code: {name: tuple(words) for name, words in lists.items()}
                    for code, lists in row.values.items()
                },
            )
            for row in models.ValueList.objects.all()
        ),
        phrases=tuple(
            values.Phrase(key=row.key, texts=row.texts) for row in models.Phrase.objects.all()
        ),
    )


def _grouped(rows: Iterable[Row]) -> Rows[Row]:
    groups: Rows[Row] = defaultdict(list)
    for row in rows:
        groups[row.intent_id].append(row)
    return groups


class _Spoken(Protocol):
    language: str


Spoken = TypeVar("Spoken", bound=_Spoken)


def _by_language(rows: Iterable[Spoken]) -> dict[str, list[Spoken]]:
    groups: dict[str, list[Spoken]] = {}
    for row in rows:
        groups.setdefault(row.language, []).append(row)
    return {code: groups[code] for code in LANGUAGES if code in groups}


def _slot(row: models.Slot) -> values.Slot:
    return values.Slot(name=row.name, kind=row.kind, required=row.required, questions=row.questions)


def _action(row: models.PlanAction | models.KBPlanAction) -> values.ActionItem:
    pairs = tuple((str(name), str(value)) for name, value in row.parameters)
    return values.ActionItem(action=row.action, parameters=pairs)


def _test(row: models.IntentTest) -> values.IntentTest:
    return values.IntentTest(sentence=row.sentence, parameters=row.parameters)
