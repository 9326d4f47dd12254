"""Changes between releases in plain words, in the language of the page."""

from collections.abc import Mapping
from dataclasses import dataclass

from django.urls import reverse
from django.utils.functional import Promise
from django.utils.translation import get_language, gettext, ngettext
from django.utils.translation import gettext_lazy as _

from authoring.language_names import language_name
from authoring.releases.release_notes import Notes
from authoring.releases.release_rows import KINDS, Change
from authoring.word_marks import Piece, word_marks
from dialogue.engine.concepts import ROOT, Culture
from dialogue.engine.pools import POOLS
from dialogue.engine.sentence_types import SENTENCE_TYPES

GROUPS: Mapping[str, Promise] = {
    "cultures": _("Cultures"),
    "topics": _("Topics"),
    "names": _("Names of topics"),
    "keywords": _("Words that lead to topics"),
    "likeliness": _("Likeliness"),
    "sentences": _("Sentences about topics"),
    "pools": _("Sentences about no topic"),
    "intents": _("Intents"),
    "vocabulary": _("Phrases and lists of values"),
}

#: What is said of a change; the texts that differ are shown below where they are not named here.
WORDS: Mapping[str, Promise] = {
    "cultures.added": _("New culture %(where)s."),
    "cultures.removed": _("The culture %(where)s is gone."),
    "cultures.language": _("%(where)s: the usual language is %(new)s, it was %(old)s."),
    "cultures.names": _("%(where)s: its name in %(language)s."),
    "cultures.order": _("The cultures come in another order."),
    "topics.added": _("New topic %(where)s below %(detail)s; sentences of its own: %(new)s."),
    "topics.removed": _("The topic %(where)s is gone; sentences of its own: %(old)s."),
    "topics.renamed": _("The topic %(old)s is called %(new)s now."),
    "topics.moved": _("%(where)s stands below %(new)s now, before it stood below %(old)s."),
    "topics.of": _("%(where)s: the culture where it is at home."),
    "topics.gentle": _("%(where)s: a hard subject? %(new)s, before: %(old)s."),
    "topics.stop": _("%(where)s: the types of sentences it does not take from above."),
    "topics.pattern": _("%(where)s: the order in which its sentences are said."),
    "topics.note": _("%(where)s: the note for colleagues."),
    "topics.variable": _("%(where)s: the word for %(detail)s."),
    "topics.order": _("The topics below %(where)s come in another order."),
    "topics.link_added": _("%(where)s leads to %(new)s too now."),
    "topics.link_removed": _("%(where)s no longer leads to %(old)s."),
    "topics.link_changed": _("%(where)s leads to %(new)s now instead of %(old)s."),
    "topics.link_order": _("%(where)s: the topics it leads to come in another order."),
    "topics.also_added": _("%(where)s takes sentences from %(new)s too now."),
    "topics.also_removed": _("%(where)s no longer takes sentences from %(old)s."),
    "topics.also_changed": _("%(where)s takes sentences from %(new)s now instead of %(old)s."),
    "topics.also_order": _("%(where)s: the topics it takes sentences from, in another order."),
    "names.name": _("%(where)s: its name in %(language)s."),
    "names.forms": _("%(where)s: the forms of its name in %(language)s."),
    "keywords.words": _("%(where)s: the words that lead here in %(language)s."),
    "likeliness.value": _("%(where)s: likeliness for %(culture)s people %(old)s → %(new)s."),
    "sentences.added": _("New sentence %(where)s (%(type)s):"),
    "sentences.removed": _("The sentence %(where)s (%(type)s) is gone:"),
    "sentences.moved": _("The sentence %(where)s belongs to %(new)s now, before to %(old)s."),
    "sentences.text": _("%(where)s says in %(language)s now:"),
    "sentences.type": _("%(where)s is of the type %(new)s now, before %(old)s."),
    "sentences.only": _("%(where)s: the cultures it is kept for."),
    "sentences.scope": _("%(where)s: where it may be said."),
    "sentences.do": _("%(where)s: the activity it offers."),
    "sentences.order": _("The sentences of %(where)s come in another order."),
    "pools.added": _("New sentence %(where)s (%(pool)s):"),
    "pools.removed": _("The sentence %(where)s (%(pool)s) is gone:"),
    "pools.text": _("%(where)s says in %(language)s now:"),
    "pools.type": _("%(where)s is said %(new)s now, before %(old)s."),
    "pools.only": _("%(where)s: the cultures it is kept for."),
    "pools.scope": _("%(where)s: where it may be said."),
    "pools.do": _("%(where)s: the activity it offers."),
    "pools.order": _("The sentences of %(where)s come in another order."),
    "intents.added": _("New intent %(where)s; trigger sentences: %(new)s."),
    "intents.removed": _("The intent %(where)s is gone."),
    "intents.renamed": _("The intent %(old)s is called %(new)s now."),
    "intents.family": _("%(where)s: its family."),
    "intents.priority": _("%(where)s: priority %(old)s → %(new)s."),
    "intents.note": _("%(where)s: the note for colleagues."),
    "intents.ability": _("%(where)s: what the robot says it can do, in %(language)s."),
    "intents.slot": _("%(where)s: the parameter %(detail)s."),
    "intents.plan": _("%(where)s: what the robot does."),
    "intents.kbplan": _("%(where)s: what it changes in the talk."),
    "intents.order": _("The intents come in another order."),
    "intents.trigger_added": _("%(where)s: trigger added in %(language)s."),
    "intents.trigger_removed": _("%(where)s: trigger removed in %(language)s."),
    "intents.trigger_changed": _("%(where)s: trigger changed in %(language)s."),
    "intents.trigger_order": _("%(where)s: the triggers in %(language)s in another order."),
    "intents.says_added": _("%(where)s: the robot can say too in %(language)s:"),
    "intents.says_removed": _("%(where)s: the robot no longer says in %(language)s:"),
    "intents.says_changed": _("%(where)s: the robot says in %(language)s now:"),
    "intents.says_order": _("%(where)s: what it says in %(language)s, in another order."),
    "intents.test_added": _("%(where)s: test added in %(language)s."),
    "intents.test_removed": _("%(where)s: test removed in %(language)s."),
    "intents.test_changed": _("%(where)s: test changed in %(language)s."),
    "intents.test_order": _("%(where)s: the tests in %(language)s in another order."),
    "vocabulary.phrase_added": _("New phrase <%(where)s>."),
    "vocabulary.phrase_removed": _("The phrase <%(where)s> is gone."),
    "vocabulary.phrase": _("The phrase <%(where)s> in %(language)s."),
    "vocabulary.phrase_order": _("The phrases come in another order."),
    "vocabulary.value_added": _("New list of values %(where)s."),
    "vocabulary.value_removed": _("The list of values %(where)s is gone."),
    "vocabulary.value": _("The list of values %(where)s: the words for %(detail)s."),
    "vocabulary.value_order": _("The lists of values come in another order."),
}


#: So many names are listed in one sentence.
MOST_NAMES = 8


@dataclass(frozen=True, slots=True)
class Told:
    """A change as the page shows it: words, the marked texts, the address of its row ("")."""

    words: str
    pieces: tuple[Piece, ...]
    url: str


@dataclass(frozen=True, slots=True)
class Group:
    """The changes of one kind: its name, how many there are, those that are shown."""

    kind: str
    title: str
    count: int
    told: tuple[Told, ...]

    @property
    def hidden(self) -> int:
        """Return how many are counted only."""
        return self.count - len(self.told)


def groups(notes: Notes, cultures: tuple[Culture, ...], most: int, only: str = "") -> list[Group]:
    """Return the changes in their groups, at most so many in all; `only` names one group."""
    names = {one.code: _called(one) for one in cultures}
    counts = {only: notes.counts.get(only, 0)} if only else notes.counts
    shares = _shares(counts, most)
    found = []
    for kind, count in counts.items():
        these = [change for change in notes.shown if change.kind == kind][: shares[kind]]
        told = tuple(tell(change, names) for change in these)
        found.append(Group(kind, str(GROUPS[kind]), count, told))
    return sorted(found, key=lambda group: KINDS.index(group.kind))


def _shares(counts: Mapping[str, int], most: int) -> dict[str, int]:
    """Share the places among the kinds: small groups are shown whole, large ones share the rest."""
    shares: dict[str, int] = {}
    left, waiting = most, sorted(counts, key=counts.__getitem__)
    for place, kind in enumerate(waiting):
        shares[kind] = min(counts[kind], left // (len(waiting) - place))
        left -= shares[kind]
    return shares


def headlines(notes: Notes) -> list[str]:
    """Return what is new and gone, in a few sentences with names."""
    whats = notes.whats
    added, gone = whats.get(("topics", "added"), 0), whats.get(("topics", "removed"), 0)
    new, old = whats.get(("intents", "added"), 0), whats.get(("intents", "removed"), 0)
    changed = len(notes.changed_intents)
    told = (
        (added, ngettext("%(n)s topic added", "%(n)s topics added", added), "topics", "added"),
        (gone, ngettext("%(n)s topic gone", "%(n)s topics gone", gone), "topics", "removed"),
        (new, ngettext("%(n)s intent added", "%(n)s intents added", new), "intents", "added"),
        (old, ngettext("%(n)s intent gone", "%(n)s intents gone", old), "intents", "removed"),
        (
            changed,
            ngettext("%(n)s intent changed", "%(n)s intents changed", changed),
            "intents",
            "",
        ),
    )
    return [
        words % {"n": number} + _names(notes, kind, what)
        for number, words, kind, what in told
        if number
    ]


def _names(notes: Notes, kind: str, what: str) -> str:
    keys = [one.where for one in notes.shown if (one.kind, one.what) == (kind, what)]
    if not what:
        keys = list(notes.changed_intents)
    named = ", ".join(keys[:MOST_NAMES]) + (" …" if len(keys) > MOST_NAMES else "")
    return f": {named}" if keys else ""


def tell(change: Change, cultures: Mapping[str, str]) -> Told:
    """Return a change in words, with the culture's names by code."""
    template = str(WORDS[f"{change.kind}.{change.what}"])
    words = template % {
        "where": gettext("the root") if change.where == ROOT else change.where,
        "old": _value(change.old),
        "new": _value(change.new),
        "detail": _value(change.detail),
        "language": language_name(change.detail),
        "culture": cultures.get(change.detail, change.detail),
        "type": _type(change.detail),
        "pool": _pool(change.detail),
    }
    named = "%(old)s" in template or "%(new)s" in template
    return Told(words, () if named else tuple(word_marks(change.old, change.new)), _url(change))


def _value(text: str) -> str:
    return {"yes": gettext("yes"), "no": gettext("no"), ROOT: gettext("the root")}.get(
        text, text or "–"
    )


def _called(culture: Culture) -> str:
    code = (get_language() or "en")[:2]
    return culture.names.get(code) or culture.names.get("en") or culture.code


def _type(letter: str) -> str:
    known = SENTENCE_TYPES.get(letter)
    return gettext(known.name) if known else letter


def _pool(name: str) -> str:
    known = POOLS.get(name)
    return gettext(known.used_when) if known else name


_FORMS = {"topics": "topic", "names": "topic", "keywords": "topic", "likeliness": "topic"}


def _url(change: Change) -> str:
    if not change.number or change.what == "removed":
        return ""
    if change.kind == "intents":
        return reverse("admin:plans_intent_change", args=[change.number])
    form = "topic" if change.what == "order" else _FORMS.get(change.kind, "frame")
    return reverse(f"admin:dialogue_{form}_change", args=[change.number])
