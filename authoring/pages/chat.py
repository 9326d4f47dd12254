"""The page "Try it": a talk on the draft, on what is published or on a release, and why."""

from random import SystemRandom
from typing import TypeVar

import msgspec
from django.conf import settings
from django.http import HttpRequest, HttpResponse, JsonResponse
from django.shortcuts import render
from django.urls import reverse
from django.utils.translation import get_language
from django.utils.translation import gettext as _
from django.views.decorators.debug import sensitive_variables
from django.views.decorators.http import require_POST, require_safe

from authoring.chat.chat_contents import DRAFT, Chosen, content_of
from authoring.chat.chat_limits import limit
from authoring.chat.chat_messages import (
    HeardMessage,
    Json,
    ReplayMessage,
    SaveMessage,
    TurnMessage,
    all_actions,
    content_json,
    sentence_of,
    turn_json,
)
from authoring.chat.chat_troubles import answered, refuse
from authoring.chat.conversation_turns import WORDS, Said, Turn, said_in, wanted_words
from authoring.chat.conversations import About, save, turns_of
from authoring.chat.replaying import MOST_TURNS, Exchange, begin, proceed, replay, settled
from authoring.models.conversation import Conversation
from authoring.site_context import page_context
from dialogue.models import Culture, Publication
from dialogue.turns import MOST_SEED, read_state
from languages.known import LANGUAGES

MOST_RELEASES_OFFERED = 30
MOST_BYTES = 1_000_000
Message = TypeVar("Message", TurnMessage, ReplayMessage, SaveMessage)


@require_safe
def chat(request: HttpRequest) -> HttpResponse:
    """Show the page; it begins with `?topic=Key`, or with a `?conversation=number`."""
    asked = request.GET
    opened = _opened(request, asked.get("conversation", ""))
    row = Conversation(
        language=asked.get("language", "")[:8],
        culture=asked.get("culture", "")[:8],
        topic=asked.get("topic", "")[:100],
    )
    context = {
        **page_context(request),
        "title": _("Try it"),
        "languages": [(one.code, one.own_name) for one in LANGUAGES.values()],
        "cultures": _cultures(),
        "releases": Publication.objects.defer("data")[:MOST_RELEASES_OFFERED],
        "wanted": asked.get("content", DRAFT),
        "begun": opened or row,
        "seed": opened.seed if opened else SystemRandom().randint(1, 9999),
        "most_seed": MOST_SEED,
        "actions": all_actions(),
        "able": set(opened.capabilities or ()) if opened else set(),
        "opened": _turns_json(opened),
        "may_save": request.user.has_perm("authoring.add_conversation"),
        "longest": settings.CAIR_LONGEST_SENTENCE,
        "most_turns": MOST_TURNS,
    }
    return render(request, "authoring/chat.html", context)


def _opened(request: HttpRequest, number: str) -> Conversation | None:
    known = number.isascii() and number.isdecimal() and len(number) < 10
    if not known or not request.user.has_perm("authoring.view_conversation"):
        return None
    return Conversation.objects.filter(pk=int(number)).first()


def _turns_json(row: Conversation | None) -> list[Json]:
    """Return the turns of a conversation as they were found right."""
    if row is None:
        return []
    try:
        turns = turns_of(row)
    except msgspec.ValidationError:
        return []
    return [
        {"heard": one.heard, "reply": one.said.text(row.language), "plan": one.said.plan}
        for one in turns
    ]


def _cultures() -> list[tuple[str, str, str]]:
    """Return code, name and usual language of each culture."""
    here = (get_language() or "en")[:2]
    rows = Culture.objects.all()
    return [
        (row.code, row.names.get(here) or row.names.get("en") or row.code, row.language)
        for row in rows
    ]


@require_POST
@sensitive_variables()
def chat_turn(request: HttpRequest) -> JsonResponse:
    """Begin a talk, or answer one sentence."""

    def work() -> Json:
        asked = _message(request, TurnMessage, settings.CAIR_LONGEST_BODY)
        _take(request, 1)
        chosen = content_of(asked.talk.content)
        turn = _turn(chosen, asked)
        state = turn.reply.state
        return {
            "turn": turn_json(chosen, turn),
            "content": content_json(chosen),
            "language": state.language,
            "culture": state.culture,
        }

    return answered(work)


def _turn(chosen: Chosen, asked: TurnMessage) -> Exchange:
    talk = asked.talk.talk()
    if not asked.state:
        return begin(chosen.content, talk, explain=True)
    state, sentence = read_state(asked.state), sentence_of(asked.sentence)
    return proceed(chosen.content, talk, state, sentence, explain=True)


@require_POST
@sensitive_variables()
def chat_replay(request: HttpRequest) -> JsonResponse:
    """Have a whole talk again and tell what has changed since."""

    def work() -> Json:
        asked = _message(request, ReplayMessage, MOST_BYTES)
        _take(request, len(asked.turns))
        chosen = content_of(asked.talk.content)
        turns = _replayed(chosen, asked)
        pairs = zip(turns, asked.turns, strict=True)
        return {
            "turns": [turn_json(chosen, turn, shown) for turn, shown in pairs],
            "content": content_json(chosen),
        }

    return answered(work)


def _replayed(chosen: Chosen, asked: ReplayMessage) -> list[Exchange]:
    sentences = [sentence_of(turn.heard) for turn in asked.turns[1:]]
    return list(replay(chosen.content, asked.talk.talk(), sentences, explain=True))


@require_POST
@sensitive_variables()
def chat_save(request: HttpRequest) -> JsonResponse:
    """Keep a talk as a regression conversation, with what must hold of each turn."""

    def work() -> Json:
        asked = _message(request, SaveMessage, MOST_BYTES)
        _take(request, len(asked.turns))
        chosen = content_of(asked.talk.content)
        talk = settled(chosen.content, asked.talk.talk())
        said = [said_in(turn) for turn in _replayed(chosen, asked)]
        turns = [_kept(talk.language, *pair) for pair in zip(asked.turns, said, strict=True)]
        about = About(asked.title, asked.note, request.user.pk)
        row = save(chosen.content, talk, turns, about)
        return {"url": reverse("admin:conversation", args=[row.pk]), "title": row.title}

    return answered(work)


def _kept(language: str, shown: HeardMessage, now: Said) -> Turn:
    """Return a turn to keep; refused where the reply is not the one that was shown."""
    if (shown.reply, shown.plan) != (now.text(language), now.plan):
        message = _("The replies have changed meanwhile. Choose “Again with the new draft” first.")
        refuse(409, "changed", message)
    turn = Turn(sentence_of(shown.heard), now, shown.kind, shown.value.strip())
    if shown.kind == WORDS and not wanted_words(turn.value):
        refuse(400, "expected", _("Write which words must come, apart by commas."))
    return turn


def _message(request: HttpRequest, kind: type[Message], most: int) -> Message:
    """Return what the page sent. Raises TroubleError or msgspec's errors."""
    length = request.META.get("CONTENT_LENGTH") or "0"
    if not length.isdecimal() or len(length) > 9 or int(length) > most:
        refuse(413, "large", _("That is too much at once. Write less, or begin a new talk."))
    return msgspec.json.decode(request.body, type=kind)


def _take(request: HttpRequest, turns: int) -> None:
    seconds = limit.take(request.user.pk or 0, turns)
    if seconds:
        message = _("That was very quick. Wait %(seconds)s seconds and try again.")
        refuse(429, "busy", message % {"seconds": seconds})
