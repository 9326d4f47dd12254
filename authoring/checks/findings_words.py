"""The kinds of findings in plain words, and what they say in words instead of codes."""

import re
from collections.abc import Mapping

from django.utils.functional import Promise
from django.utils.translation import gettext_lazy as _

from authoring.language_names import language_name
from languages.known import LANGUAGES

KINDS: Mapping[str, Promise] = {
    "D001": _("Two topics with one name"),
    "D002": _("A topic whose parent is gone"),
    "D003": _("A topic below itself"),
    "D004": _("Sentences taken from a topic that is gone"),
    "D005": _("A link to a topic that is gone"),
    "D006": _("A link to itself, or twice the same link"),
    "D007": _("A name that cannot be used"),
    "D008": _("A culture that is gone"),
    "D009": _("A likeliness that is not from 0 to 1"),
    "D010": _("A topic without a name in a language"),
    "D011": _("A name whose forms cannot be made"),
    "D012": _("An order of sentences that cannot be read"),
    "D013": _("A type of sentence that does not exist"),
    "D014": _("A sentence of an unknown type"),
    "D015": _("A sentence not written in a language"),
    "D016": _("A sentence for a culture that is gone"),
    "D017": _("A proposal without an activity"),
    "D018": _("An activity that cannot be read"),
    "D019": _("Nothing to say at a moment of the talk"),
    "D020": _("Sentences for a moment that does not exist"),
    "D021": _("A sentence that cannot be read"),
    "D022": _("A sentence that cannot be said about a topic"),
    "D023": _("A sentence that uses a word not known there"),
    "D024": _("A sentence that cannot be said about every topic"),
    "D025": _("A proposal of something the robot cannot do"),
    "D026": _("A proposal with an unknown parameter"),
    "D027": _("A keyword without letters"),
    "D028": _("A text too long for its field, or a name that cannot be used"),
    "P001": _("An intent that cannot be read"),
    "T001": _("A test of an intent that fails"),
    "C001": _("Another intent takes some of its sentences"),
    "C002": _("A trigger that can never win"),
    "C003": _("Only the order decides between two intents"),
    "C004": _("A trigger sentence that matches nothing"),
    "C005": _("Two intents share a wording"),
    "C006": _("A phrase that is never used"),
    "C007": _("A list of values that is never used"),
    "C008": _("One word for two values"),
    "C009": _("A value that robots do not understand"),
    "C010": _("A required parameter without a question"),
    "C011": _("An intent not written, or not tested, in a language"),
    "C012": _("Too few or too many triggers, answers or tests"),
    "C013": _("An intent with no answer that can always be said"),
    "C014": _("An action that no intent asks for"),
    "C015": _("An accepted conflict that is gone"),
    "C1": _("A topic that lacks keywords, likeliness or links"),
    "C2": _("A topic with too little to say"),
    "C3": _("A class that lacks sentences of a kind"),
    "G1": _("A gap that was left over in a sentence"),
    "G2": _("An Italian article or ending that does not agree"),
    "G3": _("An English article or verb that does not agree"),
    "G4": _("Japanese that is impolite, or particles that do not meet"),
    "G5": _("A sentence that ends wrongly, or asks twice"),
    "U1": _("Sentences that are too much alike"),
    "S1": _("A sentence that is hard to say or to follow"),
    "P1": _("Words that a robot should avoid"),
    "K1": _("Keywords that lead to several topics, or too easily to one"),
    "K2": _("A topic that its own name does not find"),
    "T1": _("A tree that is too flat, too deep or not linked enough"),
    "L1": _("A culture that comes too short"),
    "A1": _("An accepted shortcoming that is gone"),
}
#: What to do, where the finding itself does not say it.
HINTS: Mapping[str, Promise] = {
    "T001": _("Change a trigger so that the test passes, or correct the test."),
    "C001": _("Make the trigger more precise, or give the intent another priority."),
    "C002": _("Remove the trigger, or make it more precise."),
    "C003": _("Give one of the two intents another priority, or make a trigger more precise."),
    "C004": _("Write the trigger more simply."),
    "C005": _("Take the wording out of one of the two intents."),
    "C010": _("Write the question by which the robot asks for it."),
    "C011": _("Write triggers and tests in that language."),
    "C012": _("Add what lacks, or take the weakest ones out."),
    "C015": _("Ask a programmer to remove that line."),
}
#: Codes whose messages name a language by its code after "in".
_WITH_LANGUAGE = frozenset(("D010", "D011", "D015", "D021", "D022", "D023", "D024", "D027"))
_CODES = "|".join(LANGUAGES)
_IN = re.compile(rf"\b([Ii]n) ({_CODES})(?=[ .:,]|$)")
_BRACKETS = re.compile(rf"\(({_CODES})\)")


def language_of(code: str, message: str) -> str:
    """Return the language a finding is about, "" for none."""
    named = _IN.search(message) if code in _WITH_LANGUAGE else None
    if named:
        return named[2]
    bracketed = _BRACKETS.search(message)
    return bracketed[1] if bracketed else ""


def plain(code: str, message: str) -> str:
    """Return the message with the names of languages in place of their codes."""
    if code in _WITH_LANGUAGE:
        message = _IN.sub(lambda found: f"{found[1]} {language_name(found[2])}", message, count=1)
    return _BRACKETS.sub(lambda found: f"({language_name(found[1])})", message)


def kind_name(code: str) -> str:
    """Return the kind of finding in words; the code itself where it is new."""
    return str(KINDS.get(code, code))


def hint_of(code: str, hint: str) -> str:
    """Return what to do."""
    return hint or str(HINTS.get(code, ""))
