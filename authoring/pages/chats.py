"""The pages of talks: the test chat with what its script asks, and the conversations kept."""

from django.utils.translation import gettext_lazy as _

from authoring.pages.chat import chat, chat_replay, chat_save, chat_turn
from authoring.pages.conversations import conversation, conversations
from authoring.pages.page import Page

VIEW = "dialogue.view_topic"
KEPT = "authoring.view_conversation"

CHAT_PAGES: tuple[Page, ...] = (
    Page("chat", "chat/", chat, VIEW, _("Try it"), 30),
    Page("chat_turn", "chat/turn/", chat_turn, VIEW),
    Page("chat_replay", "chat/replay/", chat_replay, VIEW),
    Page("chat_save", "chat/save/", chat_save, "authoring.add_conversation"),
    Page("conversations", "conversations/", conversations, KEPT, _("Conversations"), 45),
    Page("conversation", "conversations/<int:number>/", conversation, KEPT),
)
