"""The authoring pages of intents (plain forms)."""

from django.contrib import admin

from plans import models


class SlotInline(admin.TabularInline):
    model = models.Slot
    extra = 0


class TriggerInline(admin.TabularInline):
    model = models.Trigger
    extra = 0


class PlanSentenceInline(admin.TabularInline):
    model = models.PlanSentence
    extra = 0


class PlanActionInline(admin.TabularInline):
    model = models.PlanAction
    extra = 0


class KBPlanActionInline(admin.TabularInline):
    model = models.KBPlanAction
    extra = 0


class IntentTestInline(admin.TabularInline):
    model = models.IntentTest
    extra = 0


@admin.register(models.Intent)
class IntentAdmin(admin.ModelAdmin):
    list_display = ("key", "priority", "note")
    search_fields = ("key", "triggers__text")
    inlines = (
        SlotInline,
        TriggerInline,
        PlanSentenceInline,
        PlanActionInline,
        KBPlanActionInline,
        IntentTestInline,
    )


@admin.register(models.Phrase)
class PhraseAdmin(admin.ModelAdmin):
    list_display = ("key",)


@admin.register(models.ValueList)
class ValueListAdmin(admin.ModelAdmin):
    list_display = ("key",)
