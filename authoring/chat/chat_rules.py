"""The rules of the algorithm in plain words: one row a step that the engine can note.

The engine tells its steps in short English; here they are read again and told for experts, in
the language of the page, with the topics, sentences and intents as links.
"""

import re
from typing import NamedTuple

from django.utils.functional import Promise
from django.utils.translation import gettext_lazy as _


class Rule(NamedTuple):
    """A step: the rule's name, what the engine says, the words for it.

    A group of the pattern fills the `%(name)s` of the words: `topic`, `line` and `intent` become
    links; `type`, `pool`, `order`, `way` and `attitude` are put in words.
    """

    name: str
    pattern: re.Pattern[str]
    words: str | Promise


def _rule(name: str, pattern: str, words: str | Promise) -> Rule:
    return Rule(name, re.compile(pattern, re.DOTALL), words)


#: What the steps do in Algorithm 1 of the paper, for who knows it.
LINES: dict[str, str] = {
    "kbplan": "2–20",
    "setlikeliness": "4–8",
    "learn": "21–27",
    "keywords": "21–24",
    "name": "21–24",
    "begin": "25",
    "next": "31",
    "say": "29–37",
    "pause": "29–37",
    "skip": "29–37",
}

RULES: tuple[Rule, ...] = (
    _rule(
        "say",
        r"(?P<line>\S+) \([^)]*\) about (?P<topic>\S+)",
        _("It says %(line)s about %(topic)s."),
    ),
    _rule(
        "pool",
        r"(?P<line>\S+), from the pool (?P<pool>\S+)",
        _("It says %(line)s, one of the lines %(pool)s."),
    ),
    _rule("repeat", r"(?P<line>\S+) again", _("It says %(line)s again.")),
    _rule(
        "skip",
        r"(?P<topic>\S+) has nothing of type (?P<type>\S+)\.",
        _("%(topic)s has no sentence of the kind “%(type)s” to say now; it is left out."),
    ),
    _rule(
        "unfilled",
        r"(?P<line>[^:\s]+): (?P<problem>.*)",
        _("%(line)s cannot be said here: %(problem)s"),
    ),
    _rule(
        "keywords", r"(?P<words>.*) → (?P<topic>\S+)", _("The words “%(words)s” lead to %(topic)s.")
    ),
    _rule("name", r"(?P<words>.*) → (?P<topic>\S+)", _("“%(words)s” is the name of %(topic)s.")),
    _rule(
        "begin",
        r"Topic (?P<topic>\S+) \((?P<way>\w+)\), ordering (?P<order>.*)",
        _("The talk goes to %(topic)s, %(way)s. To come: %(order)s."),
    ),
    _rule(
        "begin",
        r"Topic (?P<topic>\S+), ordering (?P<order>.*)",
        _("The talk goes to %(topic)s. To come: %(order)s."),
    ),
    _rule("next", r"No topic is left to propose\.", _("No topic is left to propose.")),
    _rule(
        "next",
        r"none drawn: (?P<way>[\w ]+?)(?: of (?P<from>\S+))?",
        _("None of these topics may be proposed now."),
    ),
    _rule(
        "next",
        r"(?P<topic>\S+) drawn: below (?P<from>\S+)",
        _("Drawn by likeliness among what is below %(from)s: %(topic)s."),
    ),
    _rule(
        "next",
        r"(?P<topic>\S+) drawn: branch near the root",
        _("Drawn by likeliness among the branches: %(topic)s."),
    ),
    _rule(
        "next",
        r"(?P<topic>\S+) drawn: child of (?P<from>\S+)",
        _("Drawn by likeliness among the topics below %(from)s: %(topic)s."),
    ),
    _rule(
        "next",
        r"(?P<topic>\S+) drawn: sibling of (?P<from>\S+)",
        _("Drawn by likeliness among the topics beside %(from)s: %(topic)s."),
    ),
    _rule(
        "next",
        r"(?P<topic>\S+) drawn: link (?:out of the branch )?of (?P<from>\S+)",
        _("Drawn by likeliness among the topics that %(from)s leads to: %(topic)s."),
    ),
    _rule(
        "learn",
        r"(?P<attitude>\w+) to (?P<topic>\S+): likeliness (?P<value>\S+)",
        _("The answer was heard as “%(attitude)s”: the likeliness of %(topic)s is now %(value)s."),
    ),
    _rule(
        "setlikeliness",
        r"No topic (?P<words>.*): nothing to do\.",
        _("There is no topic %(words)s: nothing is learned."),
    ),
    _rule(
        "setlikeliness",
        r"(?P<topic>\S+): likeliness (?P<value>\S+)",
        _("What was said sets the likeliness of %(topic)s to %(value)s."),
    ),
    _rule(
        "kbplan",
        r"No action (?P<words>.*) is known\.",
        _("The intent asks for %(words)s, which the robot does not know."),
    ),
    _rule(
        "urgent",
        r".*",
        _("Help was asked for: no small talk now, the robot stays with the person."),
    ),
    _rule("welcome", r".*", _("Nothing was said: the person is back and is greeted.")),
    _rule("offer", r"(?P<intent>\S+) refused", _("The offer (%(intent)s) was refused.")),
    _rule(
        "offer",
        r"(?P<intent>\S+) accepted: (?P<plan>.*)",
        _("The offer (%(intent)s) was accepted: %(plan)s"),
    ),
    _rule(
        "ask",
        r"(?P<slot>\w+) is missing: asked for\.",
        _("“%(slot)s” is missing: the robot asks for it."),
    ),
    _rule(
        "ask",
        r"No (?P<slot>\w+): (?P<intent>\S+) is let be\.",
        _("No answer for “%(slot)s”: %(intent)s is let be."),
    ),
    _rule("ask", r"(?P<intent>\S+) was not meant\.", _("%(intent)s was not meant.")),
    _rule("ask", r"(?P<intent>\S+): (?P<plan>.*)", _("The answer completes %(intent)s: %(plan)s")),
    _rule("suggest", r".*", _("It was nearly understood: the robot asks whether it was meant.")),
    _rule(
        "stay",
        r"(?P<topic>\S+) is what we are talking about\.",
        _("%(topic)s is what the talk is about already."),
    ),
    _rule(
        "stay",
        r"(?P<topic>\S+) can wait: .*",
        _("%(topic)s can wait: the person is being listened to."),
    ),
    _rule(
        "stay",
        r"Nothing else was named: go on listening about (?P<topic>\S+)\.",
        _("Nothing else was named: the robot goes on listening about %(topic)s."),
    ),
    _rule(
        "stay",
        r"Somebody of theirs, .*",
        _("This is about somebody of theirs, or about something unknown: the robot listens."),
    ),
    _rule(
        "hand over",
        r"(?P<topic>\S+) is a hard subject: .*",
        _("%(topic)s is a hard subject: the person chooses how to go on."),
    ),
    _rule("pause", r".*", _("Two questions in a row are enough: a remark first.")),
    _rule("listen", r".*", _("The robot stays with the person and listens.")),
    _rule("tell", r"There is nothing .*", _("There is nothing of that kind to tell.")),
    _rule("tell", r".*", _("A joke, a story or the like was asked for.")),
    _rule(
        "leave",
        r"(?P<topic>\S+) stays out for (?P<value>\d+) turns\.",
        _("%(topic)s is not brought up for %(value)s turns."),
    ),
    _rule("forget", r".*", _("All that the robot learned about the person is forgotten.")),
    _rule("more", r".*", _("The person wants more: the robot stays with the topic.")),
    _rule("stop", r".*", _("The person ended the talk.")),
    _rule(
        "abilities",
        r"(?P<value>\d+) of (?P<all>\d+) .*",
        _("The robot names %(value)s of the %(all)s things it can do."),
    ),
)

TITLES: dict[str, str | Promise] = {
    "plan": _("What was asked for"),
    "say": _("What is said"),
    "pool": _("What is said"),
    "repeat": _("What is said"),
    "skip": _("What is left out"),
    "unfilled": _("What is left out"),
    "keywords": _("The words"),
    "name": _("The words"),
    "begin": _("The topic"),
    "next": _("The next topic"),
    "learn": _("What was learned"),
    "setlikeliness": _("What was learned"),
}
OTHER_TITLE = _("How it goes on")

WAYS: dict[str, str | Promise] = {
    "child": _("more special than the one before"),
    "sibling": _("beside the one before"),
    "link": _("to which the one before leads"),
    "far": _("which has nothing to do with the one before"),
}
ATTITUDES: dict[str, str | Promise] = {
    "YES_STRONG": _("a strong yes"),
    "YES": _("yes"),
    "A_LITTLE": _("a little"),
    "DEPENDS": _("it depends"),
    "NOT_REALLY": _("not really"),
    "NO": _("no"),
    "NO_STRONG": _("a strong no"),
}
REACTION_WORDS = _("the reaction to the answer")
NOTHING_WORDS = _("nothing")
MATCHING: dict[str, str | Promise] = {
    "words": _("all its words were said"),
    "clause": _("one part of the sentence says it"),
    "fillers": _("small words around it were forgiven"),
    "spelling": _("a slip in the spelling was forgiven"),
    "suggestion": _("it was nearly understood, so the robot asks first"),
}
LOSING: dict[str, str | Promise] = {
    "has a lower priority": _("has a lower priority"),
    "has fewer words of its own in the sentence": _("has fewer words of its own in the sentence"),
    "has fewer listed values": _("has fewer words of its lists in the sentence"),
    "has more free slots": _("leaves more open"),
    "has longer free words": _("leaves more words open"),
    "comes later in the library": _("comes later in the list of intents"),
}
