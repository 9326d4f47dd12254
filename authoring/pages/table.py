"""All pages of the admin besides the forms, one row each."""

from django.utils.translation import gettext_lazy as _

from authoring.pages.audit import audit, back
from authoring.pages.chats import CHAT_PAGES
from authoring.pages.checks_pages import CHECK_PAGES
from authoring.pages.coverage import COVERAGE_PAGE
from authoring.pages.keys import keys
from authoring.pages.ontology_import import ONTOLOGY_PAGES
from authoring.pages.page import Page
from authoring.pages.sheets import SHEET_PAGES
from authoring.pages.topics import TOPIC_PAGES
from authoring.pages.tree import TREE_PAGES
from authoring.pages.try_sentence import check_intent, failing_intents, try_answer, try_sentence

PAGES: tuple[Page, ...] = (
    Page("intent_try", "intents/try/", try_sentence, "plans.view_intent", _("Try a sentence"), 40),
    Page("intent_answer", "intents/answer/", try_answer, "plans.view_intent"),
    Page("intent_check", "intents/check/", check_intent, "plans.view_intent"),
    Page("intent_failing", "intents/failing/", failing_intents, "plans.view_intent"),
    Page("audit", "audit/", audit, "dialogue.publish_draft", _("History"), 80),
    Page("audit_back", "audit/<str:model>/<int:record>/", back, "dialogue.change_topic"),
    Page("keys", "keys/", keys, "authoring.view_apikey", _("API keys"), 90),
    *TOPIC_PAGES,
    *CHAT_PAGES,
    *CHECK_PAGES,
    *TREE_PAGES,
    *SHEET_PAGES,
    *ONTOLOGY_PAGES,
    COVERAGE_PAGE,
)
