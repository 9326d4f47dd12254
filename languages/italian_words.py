"""Italian word forms: the regular ones of a keyword, and "mia moglie" as "tua moglie"."""

import re

#: Words that look like infinitives and are none, or whose "forms" would be other words
#: (solare: sola, solo; cenere: cena).
_NO_VERBS_TEXT = """
    mare altare cellulare militare alveare popolare lunare solare polare familiare regolare
    collare focolare volgare esemplare particolare nucleare muscolare secolare cenere genere
    polvere carcere rovere essere avere dovere potere volere sapere cratere carattere stare fare
    dare andare dire venire salire piacere avvenire ventre tenere pere sere camere lettere
    titolare singolare lineare scolare stellare
"""
_NO_VERBS = frozenset(_NO_VERBS_TEXT.split())
#: Four forms each; of other words in -o the feminine is often another thing: il porto, la porta.
_ADJECTIVES_TEXT = """
    rosso nero giallo bianco azzurro grigio bello buono brutto piccolo nuovo vecchio caldo
    freddo amaro stanco solo malato contento allegro sereno antico moderno lungo corto alto
    basso largo stretto ricco povero dolce caro simpatico fresco salato fritto cotto crudo
    ripieno italiano americano africano indiano romano napoletano siciliano toscano veneziano
    lontano vicino sano santo sacro segreto storico classico romantico comico tragico elettrico
    magico
"""
_ADJECTIVES = frozenset(_ADJECTIVES_TEXT.split())
_ENDINGS = {
    "are": """
        o i a iamo ate ano avo avi ava avamo avate avano ai asti ò ammo aste arono ato ata ati
        ate ando erò erai erà eremo erete eranno erei eresti erebbe eremmo ereste erebbero ino
        assi asse assimo assero
    """,
    "ere": """
        o i e iamo ete ono evo evi eva evamo evate evano ei esti é emmo este erono uto uta uti
        ute endo erò erai erà eremo erete eranno erei eresti erebbe eremmo ereste erebbero ano
        essi esse essimo essero
    """,
    "ire": """
        o i e iamo ite ono isco isci isce iscono isca iscano ivo ivi iva ivamo ivate ivano ii
        isti ì immo iste irono ito ita iti ite endo irò irai irà iremo irete iranno irei iresti
        irebbe iremmo ireste irebbero ano issi isse issimo issero
    """,
}
_ATTACHED = ("mi", "ti", "si", "ci", "vi", "lo", "la", "li", "le", "ne", "gli")
_INFINITIVE = re.compile(r"(?P<stem>\w{2,})(?P<kind>[aei])r(?:e|si)")
_FRONT = tuple("eièéì")


def inflections(word: str) -> frozenset[str]:
    """Return the regular forms of a word: gatto, gatti; ballare, ballo, balla, ballato.

    A noun keeps its gender (caso is not casa); irregular verbs and plurals are left to the author.
    """
    if len(word) < 3 or not word.isalpha():
        return frozenset((word,))
    infinitive = _INFINITIVE.fullmatch(word)
    if infinitive and word not in _NO_VERBS and not word.endswith("iere"):
        return frozenset({word, *_verb_forms(infinitive["stem"], f"{infinitive['kind']}re")})
    return frozenset({word, *_noun_forms(word)})


def _noun_forms(word: str) -> list[str]:
    if word in _ADJECTIVES or word.endswith(("oso", "ivo", "iano", "issimo")):
        return _adjective_forms(word)
    rows: tuple[tuple[str, tuple[str, ...]], ...] = (
        ("ista", ("isti", "iste")),
        ("cia", ("cie", "ce")),
        ("gia", ("gie", "ge")),
        ("ca", ("che",)),
        ("ga", ("ghe",)),
        ("ma", ("me", "mi")),
        ("a", ("e",)),
        ("io", ("i", "ii")),
        ("co", ("chi", "ci")),
        ("go", ("ghi", "gi")),
        ("o", ("i",)),
        ("e", ("i",)),
        ("chi", ("co",)),
        ("ghi", ("go",)),
        ("i", ("o", "e", "io")),
    )
    for ending, others in rows:
        if word.endswith(ending):
            return [word.removesuffix(ending) + other for other in others]
    return []


def _adjective_forms(word: str) -> list[str]:
    stem = word[:-1]
    if word.endswith("e"):
        return [f"{stem}i"]
    if word.endswith("io"):
        return [f"{stem}a", stem, f"{stem}e"]
    if word.endswith(("co", "go")):
        return [f"{stem}a", f"{stem}hi", f"{stem}i", f"{stem}he"]
    return [stem + ending for ending in "aie"]


def _verb_forms(stem: str, kind: str) -> set[str]:
    forms = {_attach(stem, ending, kind) for ending in _ENDINGS[kind].split()}
    infinitive = stem + kind[:-1]
    return forms | {f"{infinitive}e"} | {infinitive + pronoun for pronoun in _ATTACHED}


def _attach(stem: str, ending: str, kind: str) -> str:
    """Join stem and ending as Italian spells them: giochi, mangi, mangerò, cercherò."""
    if kind == "are" and ending.startswith(_FRONT):
        if stem.endswith(("c", "g")):
            return f"{stem}h{ending}"
        soft = stem.endswith(("ci", "gi")) and len(stem) > 3  # mangerò, but scierò
        if stem.endswith("i") and (ending.startswith("i") or soft):
            return stem[:-1] + ending
    return stem + ending


_THEIRS = {
    "mio": "tuo", "mia": "tua", "miei": "tuoi", "mie": "tue",
    "nostro": "vostro", "nostra": "vostra", "nostri": "vostri", "nostre": "vostre",
    "io": "tu", "me": "te", "mi": "ti", "noi": "voi", "ho": "hai", "sono": "sei", "m": "t",
    "tuo": "mio", "tua": "mia", "tuoi": "miei", "tue": "mie", "tu": "io", "te": "me", "ti": "mi",
}  # fmt: skip
#: "sono" is "I am" only with "io": "i miei figli sono" stays.
_OWN_WORDS = re.compile(
    r"\b(?:(?P<am>io\s+)(?P<verb>sono|ho)|(?P<elided>m(?=['’]))"
    r"|(?P<word>mi[oae]|miei|nostr[oaie]|io|me|mi|noi|ho|tu[oae]|tuoi|tu|te|ti))\b",
    re.IGNORECASE,
)


def their_words(words: str) -> str:
    """Return the person's words as the agent says them: "mia moglie Anna" is "tua moglie Anna"."""
    return _OWN_WORDS.sub(_turned, words)


def _turned(found: re.Match[str]) -> str:
    if found["verb"]:
        return f"tu {_THEIRS[found['verb'].lower()]}"
    word = found["elided"] or found["word"]
    turned = _THEIRS[word.lower()]
    return turned.capitalize() if word[0].isupper() else turned
