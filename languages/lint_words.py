"""The words a robot must not say, per language: rows of pattern, what is wrong, what to write."""

import re
from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple


class Row(NamedTuple):
    """One thing to look for; an `error` stops the publication, a warning does not."""

    code: str
    pattern: re.Pattern[str]
    message: str
    hint: str
    error: bool


def _row(code: str, pattern: str, message: str, hint: str, *, error: bool = True) -> Row:
    return Row(code, re.compile(pattern, re.IGNORECASE), message, hint, error)


def _human(pattern: str) -> Row:
    hint = "Say only what is true of a robot: 'I cannot taste, but …'."
    return _row("P1", pattern, "The robot claims a human life", hint)


def _age(pattern: str) -> Row:
    hint = "Leave the age out; general topics are for everybody."
    return _row("P1", pattern, "It assumes the person's age", hint, error=False)


def _abbreviation(pattern: str) -> Row:
    return _row("S1", pattern, "An abbreviation cannot be spoken", "Write the words in full.")


_EVERYWHERE = (
    _row("G1", r"[{}|]|\$(?!(?:name|desspk|prevspk)\b)", "A gap was left over", "Mend the gap."),
    _row("S1", r"[()\[\]（）［］【】<>]", "Brackets cannot be spoken", "Use two sentences."),
    _row("S1", r"[/／\\]", "A slash cannot be spoken", "Write 'or' / 'o' / 「か」."),
    _row("S1", r"\d{5,}", "The number is hard to hear", "Use at most 4 figures."),
)

_ENGLISH = (
    _abbreviation(r"\b(?:e\.g|i\.e|etc|approx|vs|Mr|Mrs|Ms|Dr|St)\.|\betc\b"),
    _human(
        r"\bI(?:['’]ve| have)?(?: (?:once|just|often|always|also|really))?"
        r" (?:ate|eaten|drank|drunk|slept|dreamt|dreamed|tasted|smelled|smelt|grew up|cooked"
        r"|was born|married|got married|went to school)\b"
    ),
    _human(
        r"\bwhen I was (?:a (?:child|boy|girl|baby)|little|young|small|at school)\b"
        r"|\bI (?:am (?:hungry|thirsty|sleepy)|eat|drink|sleep|dream)\b"
    ),
    _human(
        r"\bmy (?:childhood|mother|father|parents|wife|husband|grandmother|grandfather|family"
        r"|sister|brother|school days|wedding)\b"
    ),
    _age(r"\bwhen you were young(?:er)?\b|\b(?:at your age|back in your day|old people)\b"),
    _row(
        "G3",
        r"(?<![-\w])(?:(?:the|an?|my|your) (?:the|an?)|(of|to|in|is|are|with|about) \1)(?![-\w])",
        "Two small words meet",
        "Use $hasName.bare after an article.",
    ),
)

#: Participles and adjectives that would tell a man from a woman.
_GENDERED = (
    "stat|andat|nat|cresciut|stanc|content|sicur|pront|brav|arrivat|tornat|divertit|innamorat"
    "|sposat|abituat|sedut|svegliat|sol|appassionat|interessat|curios|trovat|sentit|vestit"
    "|affezionat|legat|portat|bambin|piccol|ragazz"
)
_BETWEEN = "(?:mai|già|sempre|ancora|più)"

_ITALIAN = (
    _abbreviation(r"\b(?:ecc|es|dott|sig|sig\.ra|prof|pag|p\.es)\.(?=\s|$)|\becc\b"),
    _human(
        r"(?<!\bnon )\bho (?:sempre |appena )?"
        r"(?:mangiato|bevuto|dormito|sognato|assaggiato|cucinato)\b"
        r"|\b(?:sono nat|sono cresciut|mi sono sposat)[oa]\b"
    ),
    _human(
        r"\bquando ero (?:piccol[oa]|bambin[oa]|giovane|ragazz[oa])\b|(?<!\bnon )\bho (?:fame|sete"
        r"|sonno)\b|\b(?:mia madre|mio padre|mia moglie|mio marito|mia nonna|mio nonno"
        r"|la mia infanzia|i miei genitori|la mia famiglia)\b"
    ),
    _row(
        "P1",
        r"\b(?:benvenut|bentornat)[oa]\b|\bda (?:bambin|piccol|ragazz|sol)[oa]\b|\bcar[oa] mi[oa]\b"
        rf"|\b(?:sei|eri|sarai|saresti|sia|fossi)(?: {_BETWEEN})? (?:{_GENDERED})[oa]\b",
        "It may agree with the person's gender",
        "Use 'ti è mai capitato di …', 'hai mai visto …', 'da piccoli'.",
        error=False,
    ),
    _age(r"\bquando eri giovane\b|\balla tua età\b|\bai tuoi tempi\b"),
    _row(
        "G2",
        # Lower case only: "di La Spezia" is right.
        r"(?-i:\b(?:[Dd]i|[Aa]|[Dd]a|[Ii]n|[Ss]u) (?:(?:il|lo|la|i|gli|le) |l['’]))",
        "Preposition and article do not melt",
        "Use $hasName.di, .a, .da, .in or .su instead of 'di $hasName'.",
    ),
)

_JAPANESE = (
    _human(
        r"(?:私|わたし|僕)(?:は|も|が)[^。？！]{0,20}(?:食べました|食べたこと|飲みました|眠りました"
        r"|寝ました|[でに]生まれました|育ちました|結婚しました)"
    ),
    _human(
        r"(?:私|わたし|僕)[がの](?:子どものころ|子供の頃|小さいころ|若いころ|母|父|妻|夫|家族"
        r"|祖母|祖父)"
    ),
    _row("G4", r"あなた", "「あなた」 is rude here", "Leave it out."),
    _row(
        "G4", r"たいですか", "This is too direct", "Write 「いかがですか」 or 「〜てみませんか」."
    ),
    _row("G4", r"[ｦ-ﾟ?!,]|\.(?!\d)", "Half-width signs", "Write 。、？！ and ア in full width."),
    _row(
        "G4",
        r"(?<!です)(?<!ます)(?<!ました)(?<!でした)(?<!ません)(?<!ください)(?<!しょう)(?<!ね)(?<!よ)"
        r"(?<!か)(?<!から)(?<!なるほど)(?<!はい)(?<!ええ)(?<![。！？])[。！？]",
        "A sentence does not end in です・ます",
        "End with です, ます, ました, ください, ね or よ.",
        error=False,
    ),
    _age(r"お?若いころ|お?若い頃|若かったころ|そのお年"),
)

WORDS: Mapping[str, tuple[Row, ...]] = MappingProxyType(
    {
        "en": _EVERYWHERE + _ENGLISH,
        "it": _EVERYWHERE + _ITALIAN,
        "ja": _EVERYWHERE + _JAPANESE,
    }
)

_ADVICE = {
    "en": r"\b(?:should|ought to|must|have to|need to|had better)\b",
    "it": r"\b(?:dovresti|devi|bisogna|occorre|è meglio che|ti conviene)\b",
    "ja": r"べき|なければなりません|なければいけません|ほうがいい|方がいい",
}
_CHEERFUL = {
    "en": r"\b(?:great|wonderful|fantastic|lovely|how nice|excellent|fun)\b",
    "it": r"\b(?:ottim[oa]|fantastic[oa]|che bell[oa]|bellissim[oa]|evviva|divertente)\b",
    "ja": r"素敵|すてき|素晴らしい|すばらしい|いいですね|楽しい",
}


def _compiled(patterns: Mapping[str, str]) -> Mapping[str, re.Pattern[str]]:
    return {language: re.compile(text, re.IGNORECASE) for language, text in patterns.items()}


#: What a robot must not tell people about their health, and what is too merry for grief.
ADVICE = _compiled(_ADVICE)
CHEERFUL = _compiled(_CHEERFUL)
