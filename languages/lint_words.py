"""The words a robot must not say, per language: rows of pattern, what is wrong, what to write."""

import re
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


_HUMAN = "The robot claims a human life"
_HUMAN_HINT = "Say only what is true of a robot: 'I cannot taste, but …'."
_AGE = "It assumes the person's age"
_AGE_HINT = "Leave the age out; general topics are for everybody."

_EVERYWHERE = (
    _row("G1", r"[{}|]|\$(?!(?:name|desspk|prevspk)\b)", "A gap was left over", "Mend the gap."),
    _row(
        "S1", r"[()\[\]（）［］【】<>]", "Brackets cannot be spoken", "Use commas or two sentences."
    ),
    _row("S1", r"[/／\\]", "A slash cannot be spoken", "Write 'or' / 'o' / 「か」."),
    _row("S1", r"\d{5,}", "The number is hard to hear", "Use at most 4 figures."),
)

WORDS = {
    "en": (
        *_EVERYWHERE,
        _row(
            "S1",
            r"\b(?:e\.g|i\.e|etc|approx|vs|Mr|Mrs|Ms|Dr|St|no)\.(?=\s*[\w,;]|$)(?<!\bno\.)"
            r"|\be\.g\b|\bi\.e\b|\betc\b",
            "An abbreviation cannot be spoken",
            "Write the words in full.",
        ),
        _row(
            "P1",
            r"\bI(?:'ve| have)?(?: (?:once|just|often|always|also|really))?"
            r" (?:ate|eaten|drank|drunk|slept|dreamt|dreamed|tasted|smelled|smelt|grew up|cooked"
            r"|was born|married|got married|went to school)\b",
            _HUMAN,
            _HUMAN_HINT,
        ),
        _row(
            "P1",
            r"\bwhen I was (?:a (?:child|boy|girl|baby)|little|young|small|at school)\b"
            r"|\bmy (?:childhood|mother|father|parents|wife|husband|grandmother|grandfather|family"
            r"|sister|brother|school days|wedding)\b|\bI am (?:hungry|thirsty|sleepy)\b"
            r"|\bI (?:eat|drink|sleep|dream) \b(?!nothing)",
            _HUMAN,
            _HUMAN_HINT,
        ),
        _row(
            "P1",
            r"\bwhen you were (?:young|younger)\b|\bat your age\b|\bin your day\b|\bold people\b",
            _AGE,
            _AGE_HINT,
            error=False,
        ),
        _row(
            "G3",
            r"\b(the|a|an|my|your|of|to|in) (?:\1|the|an?)\b(?<!of the)(?<!of a)(?<!of an)"
            r"(?<!to the)(?<!to a)(?<!to an)(?<!in the)(?<!in a)(?<!in an)",
            "Two articles meet",
            "Use $hasName.bare after an article.",
        ),
    ),
    "it": (
        *_EVERYWHERE,
        _row(
            "S1",
            r"\b(?:ecc|es|dott|sig|sig\.ra|prof|pag|p\.es)\.(?=\s|$)|\becc\b",
            "An abbreviation cannot be spoken",
            "Write the words in full.",
        ),
        _row(
            "P1",
            r"\bho (?:mai |sempre |appena )?(?:mangiato|bevuto|dormito|sognato|assaggiato|cucinato)\b"
            r"(?<!non ho mangiato)(?<!non ho mai mangiato)|\bsono nat[oa]\b|\bsono cresciut[oa]\b"
            r"|\bmi sono sposat[oa]\b",
            _HUMAN,
            _HUMAN_HINT,
        ),
        _row(
            "P1",
            r"\b(?:quando|da quando) ero (?:piccol[oa]|bambin[oa]|giovane|ragazz[oa])\b"
            r"|\b(?:mia madre|mio padre|mia moglie|mio marito|mia nonna|mio nonno|la mia infanzia"
            r"|i miei genitori|la mia famiglia)\b|\bho (?:fame|sete|sonno)\b",
            _HUMAN,
            _HUMAN_HINT,
        ),
        _row(
            "P1",
            r"\b(?:benvenut[oa]|bentornat[oa])\b"
            r"|\b(?:sei|eri|sarai|saresti|sia|fossi|ti sei|ti eri)(?: (?:mai|già|sempre|ancora|più))?"
            r" (?:stat[oa]|andat[oa]|nat[oa]|cresciut[oa]|stanc[oa]|content[oa]|sicur[oa]|pront[oa]"
            r"|brav[oa]|arrivat[oa]|tornat[oa]|divertit[oa]|innamorat[oa]|sposat[oa]|abituat[oa]"
            r"|sedut[oa]|svegliat[oa]|sol[oa]|appassionat[oa]|interessat[oa]|curios[oa]|trovat[oa]"
            r"|sentit[oa]|vestit[oa]|affezionat[oa]|legat[oa]|portat[oa]|bambin[oa]|piccol[oa]"
            r"|ragazz[oa])\b|\bda (?:bambin[oa]|piccol[oa]|ragazz[oa]|sol[oa])\b|\bcar[oa] (?:mi[oa])\b",
            "It agrees with the person's gender",
            "Use 'ti è mai capitato di …', 'hai mai visto …', 'da piccoli'.",
        ),
        _row(
            "P1",
            r"\bquando eri giovane\b|\balla tua età\b|\bai tuoi tempi\b|\b(?:gli )?anziani\b",
            _AGE,
            _AGE_HINT,
            error=False,
        ),
        _row(
            "G2",
            r"\b(?:di|a|da|in|su) (?:il|lo|la|i|gli|le)(?= [a-zà-ù])(?<!\ba la)(?<!\bda la)"
            r"|\b(?:di|a|da|in|su) l['’]",
            "Preposition and article do not melt",
            "Use $hasName.di, .a, .da, .in or .su instead of 'di $hasName'.",
        ),
    ),
    "ja": (
        *_EVERYWHERE,
        _row("S1", r"など々|etc", "An abbreviation cannot be spoken", "Write 「など」."),
        _row(
            "P1",
            r"(?:私|わたし|僕)(?:は|も|が)[^。？！]{0,20}(?:食べました|食べたこと|飲みました|眠りました|寝ました"
            r"|生まれました|育ちました|結婚しました)|(?:私|わたし|僕)が?の?(?:子どものころ|子供の頃|小さいころ|若いころ)"
            r"|私の(?:母|父|妻|夫|家族|祖母|祖父)",
            _HUMAN,
            "ロボットとして本当のことだけを言います。",
        ),
        _row("G4", r"あなた", "「あなた」 is rude here", "Leave it out, or use 「〜さん」."),
        _row(
            "G4",
            r"たいですか",
            "「〜たいですか」 is too direct to the person",
            "Write 「〜はいかがですか」 or 「〜てみませんか」.",
        ),
        _row(
            "G4",
            r"[ｦ-ﾟ?!.,]",
            "Half-width signs in Japanese",
            "Write 。、？！ and ア in full width.",
        ),
        _row(
            "G4",
            r"(?:[^すたんねよかだう」]|(?<!で|ま)す|(?<!し|で)た|る|ない|だ)[。]$",
            "The sentence does not end in です・ます",
            "End with です, ます, ました, ください, ね or よ.",
            error=False,
        ),
        _row(
            "P1",
            r"お若いころ|お若い頃|若かったころ|そのお年|お年寄り",
            _AGE,
            _AGE_HINT,
            error=False,
        ),
    ),
}

ADVICE = {
    "en": re.compile(r"\b(?:should|ought to|must|have to|need to|had better)\b", re.IGNORECASE),
    "it": re.compile(
        r"\b(?:dovresti|devi|bisogna|occorre|è meglio che|ti conviene)\b", re.IGNORECASE
    ),
    "ja": re.compile(r"べき|なければなりません|なければいけません|ほうがいい|方がいい|てください"),
}
CHEERFUL = {
    "en": re.compile(
        r"\b(?:great|wonderful|fantastic|lovely|how nice|excellent|fun)\b", re.IGNORECASE
    ),
    "it": re.compile(
        r"\b(?:ottimo|ottima|fantastico|che bello|che bella|bellissimo|evviva|divertente)\b",
        re.IGNORECASE,
    ),
    "ja": re.compile(r"素敵|すてき|素晴らしい|すばらしい|いいですね|楽しい|やった"),
}
