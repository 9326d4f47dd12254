"""English word forms: the regular ones of a keyword, and "my wife" as "your wife"."""

import re

_VOWELS = "aeiou"
_IRREGULAR = {
    "man": "men", "woman": "women", "child": "children", "foot": "feet", "tooth": "teeth",
    "mouse": "mice", "goose": "geese", "knife": "knives", "wife": "wives", "life": "lives",
    "leaf": "leaves", "loaf": "loaves", "half": "halves", "wolf": "wolves", "calf": "calves",
    "shelf": "shelves", "thief": "thieves", "scarf": "scarves", "hoof": "hooves", "elf": "elves",
    "person": "people", "fisherman": "fishermen", "fireman": "firemen",
    "grandchild": "grandchildren",
    "policeman": "policemen", "postman": "postmen", "milkman": "milkmen", "snowman": "snowmen",
    "housewife": "housewives", "midwife": "midwives",
}  # fmt: skip
_SINGULAR = {plural: single for single, plural in _IRREGULAR.items()}
#: Plurals whose "singular" is another word, or none.
_NO_SINGULAR_TEXT = """
    news goods glasses arms customs thanks clothes spectacles means series species works looks
    scales needs spirits always perhaps maths physics politics gymnastics athletics
"""
_NO_SINGULAR = frozenset(_NO_SINGULAR_TEXT.split())
_ADJECTIVES_TEXT = """
    big small old young new tall short long high low hot cold warm cool sweet sour fast slow
    loud quiet soft hard kind nice sad great fine fresh strong weak rich poor dark light bright
    cheap clean clever deep few near far thick thin wide wild mild white black
"""
_ADJECTIVES = frozenset(_ADJECTIVES_TEXT.split())
_SIBILANT = re.compile(r"(?:s|x|z|ch|sh)$")
_SHORT_SYLLABLE = re.compile(r"[^aeiou]*(?:qu)?[aeiou][bdfgklmnprtvz]")


def inflections(word: str) -> frozenset[str]:
    """Return the regular forms of a word: dog, dogs; dance, danced, dancing; happy, happier.

    Plurals give their singular too. Irregular verbs (swam) are left to the author.
    """
    if len(word) < 3 or not word.isascii() or not word.isalpha():
        return frozenset((word,))
    forms = {word, *_singulars(word), *_plurals(word)}
    if not word.endswith("s") or word.endswith("ss"):
        forms.update(_verb_forms(word))
    if word in _ADJECTIVES or (word.endswith("y") and len(word) > 4):
        forms.update(_stem(word) + ending for ending in ("er", "est"))
    return frozenset(forms)


def _plurals(word: str) -> list[str]:
    if word in _IRREGULAR:
        return [_IRREGULAR[word]]
    if word.endswith("y") and word[-2] not in _VOWELS:
        return [f"{word[:-1]}ies"]
    if _SIBILANT.search(word):
        return [] if word in _NO_SINGULAR or _is_plural(word) else [f"{word}es"]
    if word.endswith("o") and word[-2] not in _VOWELS:
        return [f"{word}s", f"{word}es"]
    return [f"{word}s"]


def _is_plural(word: str) -> bool:
    return word.endswith("s") and not word.endswith(("ss", "us", "is", "as", "os"))


def _singulars(word: str) -> list[str]:
    if word in _SINGULAR:
        return [_SINGULAR[word]]
    if not _is_plural(word) or word in _NO_SINGULAR or len(word) < 4:
        return []
    if word.endswith("ies"):
        return [f"{word[:-3]}y", word[:-1]]
    if word.endswith(("ches", "shes", "xes", "sses", "oes")):
        return [word[:-2]]
    return [word[:-1]]


def _verb_forms(word: str) -> list[str]:
    stem = _stem(word)
    if word.endswith("ie"):
        return [f"{word}d", f"{word[:-2]}ying"]
    if word.endswith(("ee", "oe", "ye")):  # agreed, but see: seed
        return [f"{word}ing"] if len(word) < 4 else [f"{word}ing", f"{word}d"]
    participle = word if word.endswith("y") else stem
    forms = [f"{stem}ed", f"{participle}ing"]
    if re.search(r"[aeiou][^aeiou]*[aeiou]l$", word):  # travel: travelled, traveled
        forms += [f"{word}led", f"{word}ling"]
    return forms


def _stem(word: str) -> str:
    """Return what -ed and -er are put on: danc, stopp, happi."""
    if word.endswith("e"):
        return word[:-1]
    if word.endswith("y") and word[-2] not in _VOWELS:
        return f"{word[:-1]}i"
    return word + word[-1] if _SHORT_SYLLABLE.fullmatch(word) else word


_THEIRS = {
    "my": "your", "mine": "yours", "myself": "yourself", "i": "you", "me": "you",
    "our": "your", "ours": "yours", "ourselves": "yourselves", "we": "you", "us": "you",
    "your": "my", "yours": "mine", "yourself": "myself", "you": "me",
}  # fmt: skip
#: "I am", "I'm", "I was" first, then single words; an apostrophe may be typed or curly.
_OWN_WORDS = re.compile(
    r"\b(?:(?P<was>I|we)(?=\s+(?:am|was)\b)\s+(?P<verb>am|was)|(?P<contracted>I['’]m)"
    r"|(?P<word>myself|mine|my|I|me|ourselves|ours|our|we|us|yourself|yours|your|you))\b",
    re.IGNORECASE,
)
_VERBS = {"am": "are", "was": "were"}


def their_words(words: str) -> str:
    """Return the person's words as the agent says them: "my wife Ann" is "your wife Ann"."""
    return _OWN_WORDS.sub(_turned, words)


def _turned(found: re.Match[str]) -> str:
    if found["verb"]:
        return f"you {_VERBS[found['verb'].lower()]}"
    if found["contracted"]:
        return "you’re" if "’" in found["contracted"] else "you're"
    word = found["word"]
    turned = _THEIRS[word.lower()]
    return turned.capitalize() if word[0].isupper() and word.lower() != "i" else turned
