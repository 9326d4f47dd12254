"""Write intents, value lists and phrases to the database."""

from collections.abc import Iterable

from django.db import models as db

from plans import models
from plans.engine.intents import ActionItem, Intent, Library


def write_library(old: Library, new: Library) -> None:
    """Make the rows say what the library says; call it inside a transaction."""
    if old == new:
        return
    models.Phrase.objects.all().delete()
    models.Phrase.objects.bulk_create(
        models.Phrase(key=phrase.key, texts=phrase.texts, position=place)
        for place, phrase in enumerate(new.phrases)
    )
    models.ValueList.objects.all().delete()
    models.ValueList.objects.bulk_create(
        models.ValueList(key=one.key, values=one.values, position=place)
        for place, one in enumerate(new.values)
    )
    kept = {intent.number for intent in new.intents}
    models.Intent.objects.exclude(pk__in=kept).delete()
    before = {intent.key: intent for intent in old.intents}
    for place, intent in enumerate(new.intents):
        models.Intent.objects.update_or_create(
            id=intent.number,
            defaults={
                "key": intent.key,
                "family": intent.family,
                "priority": intent.priority,
                "abilities": intent.abilities,
                "note": intent.note,
                "position": place,
            },
        )
        if before.get(intent.key) != intent:
            _write_parts(intent)


def _write_parts(intent: Intent) -> None:
    parts: tuple[tuple[type[db.Model], Iterable[db.Model]], ...] = (
        (models.Slot, _slots(intent)),
        (models.Trigger, _triggers(intent)),
        (models.PlanSentence, _plan_sentences(intent)),
        (models.PlanAction, _actions(intent.number, intent.plan, models.PlanAction)),
        (models.KBPlanAction, _actions(intent.number, intent.kbplan, models.KBPlanAction)),
        (models.IntentTest, _tests(intent)),
    )
    for model, rows in parts:
        model._default_manager.filter(intent=intent.number).delete()
        model._default_manager.bulk_create(rows)


def _slots(intent: Intent) -> Iterable[db.Model]:
    for place, slot in enumerate(intent.slots):
        yield models.Slot(
            intent_id=intent.number,
            name=slot.name,
            kind=slot.kind,
            required=slot.required,
            questions=slot.questions,
            position=place,
        )


def _triggers(intent: Intent) -> Iterable[db.Model]:
    for code, texts in intent.triggers.items():
        for place, text in enumerate(texts):
            yield models.Trigger(intent_id=intent.number, language=code, text=text, position=place)


def _plan_sentences(intent: Intent) -> Iterable[db.Model]:
    for code, sentences in intent.plan_sentences.items():
        for place, one in enumerate(sentences):
            yield models.PlanSentence(
                intent_id=intent.number,
                language=code,
                text=one.text,
                only=" ".join(one.only),
                position=place,
            )


def _actions(
    number: int, items: Iterable[ActionItem], model: type[models.PlanAction | models.KBPlanAction]
) -> Iterable[db.Model]:
    for place, item in enumerate(items):
        yield model(
            intent_id=number,
            action=item.action,
            parameters=[list(pair) for pair in item.parameters],
            position=place,
        )


def _tests(intent: Intent) -> Iterable[db.Model]:
    for code, tests in intent.tests.items():
        for place, test in enumerate(tests):
            yield models.IntentTest(
                intent_id=intent.number,
                language=code,
                sentence=test.sentence,
                parameters=test.parameters,
                position=place,
            )
