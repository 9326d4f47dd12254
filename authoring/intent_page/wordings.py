"""What the page of an intent calls things, and the examples it shows to a new author."""

from collections.abc import Mapping

from django.utils.functional import Promise
from django.utils.translation import gettext_lazy as _

Words = str | Promise

#: Priorities that have a name, the highest first.
PRIORITIES: Mapping[int, Words] = {
    100: _("Safety"),
    95: _("Bodily needs"),
    80: _("Wishes about the talk"),
    50: _("Robot actions"),
    45: _("Small talk"),
    40: _("Likes and dislikes"),
}

KINDS: Mapping[str, Words] = {
    "text": _("Any words (a title, a name)"),
    "topic": _("A topic (what something is about)"),
    "number": _("A number"),
    "duration": _("A length of time (ten minutes)"),
    "time": _("A clock time (half past seven)"),
    "date": _("A day (tomorrow, on Monday)"),
    "yes_no": _("Yes or no"),
}

#: How a sentence was understood, after "Understood".
WAYS: Mapping[str, Words] = {
    "words": _("word by word"),
    "clause": _("by one part of the sentence; the rest was set aside"),
    "fillers": _("after filler words were left out"),
    "spelling": _("after its spelling was mended"),
    "suggestion": _("not surely: the robot would ask whether this was meant"),
}

#: By the prefix of a row and language: what stands in an empty line.
EXAMPLES: Mapping[tuple[str, str], str] = {
    ("triggers", "en"): "(water|give water to) [all] (the|my) (plants|flowers)",
    ("triggers", "it"): "(annaffia|innaffia) [tutte] (le|le mie) piante",
    ("triggers", "ja"): "(植物|花|お花) に [お] 水 を (あげて|やって)",
    ("plan_sentences", "en"): "The plants will be glad of some water.",
    ("plan_sentences", "it"): "Alle piante un po' d'acqua farà bene.",
    ("plan_sentences", "ja"): "お花も喜びますね。",
    ("tests", "en"): "Could you water my plants, please?",
    ("tests", "it"): "Mi annaffi le piante, per favore?",
    ("tests", "ja"): "お花に水をあげてくれる？",
}
#: Ways of asking that new authors forget.
WAYS_OF_ASKING: Mapping[str, tuple[str, ...]] = {
    "en": (
        "water the plants",
        "would you mind watering the plants",
        "I'd like you to water the plants",
        "don't forget to water the plants",
        "can you give the plants a bit of water",
        "the plants need water",
        "the plants look thirsty",
    ),
    "it": (
        "annaffia le piante",
        "mi annaffi le piante?",
        "vorrei che annaffiassi le piante",
        "ricordati di annaffiare le piante",
        "puoi dare da bere alle piante?",
        "bisogna annaffiare le piante",
        "le piante hanno sete",
    ),
    "ja": (
        "花に水をあげて",
        "お花にお水をあげてほしい",
        "花に水をあげるのを忘れないで",
        "花の水やりをお願い",
        "はなにみずをやって",
        "花が水をほしがっている",
    ),
}
QUESTIONS: Mapping[str, str] = {
    "en": "Which plants?",
    "it": "Quali piante?",
    "ja": "どの植物ですか？",
}
ABILITIES: Mapping[str, str] = {
    "en": "water the plants",
    "it": "annaffiare le piante",
    "ja": "植物に水をやる",
}


def priority_words(priority: int) -> str:
    """Return the name of a priority with its number: "Safety (100)", or the number alone."""
    name = PRIORITIES.get(priority)
    return f"{name} ({priority})" if name else str(priority)
