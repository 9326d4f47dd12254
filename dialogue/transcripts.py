"""Talks as text files: told again from their `user:` lines, with the same seed the same talk."""

from collections.abc import Iterator

from dialogue.engine.content import Content
from dialogue.engine.manager import start
from dialogue.turns import take_turn
from languages.known import LANGUAGES

USER = "user: "


def retell(content: Content, text: str) -> str:
    """Return a transcript with what the agent answers now.

    The first line is `language culture seed`, e.g. `it IT 7`; of the rest only the `user:` lines
    are read.
    """
    head, *lines = text.splitlines()
    said = [line.removeprefix(USER) for line in lines if line.startswith(USER)]
    return "\n".join([head, "", *_talk(content, head, said)]) + "\n"


def _talk(content: Content, head: str, said: list[str]) -> Iterator[str]:
    language, culture, seed = head.split()
    separator = " " if LANGUAGES[language].spaced else ""
    reply = start(content, language, culture, int(seed))
    yield f"agent: {reply.sentence}"
    for sentence in said:
        yield f"{USER}{sentence}"
        taken = take_turn(content, reply.state, sentence)
        reply = taken.reply
        if taken.plan.plan:
            yield f"plan: {taken.plan.plan}"
        yield f"agent: {separator.join(filter(None, (taken.plan.plan_sentence, reply.sentence)))}"
