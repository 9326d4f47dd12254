"""Spells numbers below ten thousand in each language."""


def _split(text: str) -> list[str]:
    return text.split()


ENGLISH = _split(
    "zero one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen "
    "sixteen seventeen eighteen nineteen"
)
ENGLISH_TENS = _split("twenty thirty forty fifty sixty seventy eighty ninety")
ITALIAN = _split(
    "zero uno due tre quattro cinque sei sette otto nove dieci undici dodici tredici quattordici "
    "quindici sedici diciassette diciotto diciannove"
)
ITALIAN_TENS = _split("venti trenta quaranta cinquanta sessanta settanta ottanta novanta")
JAPANESE = "〇一二三四五六七八九"


def english(number: int) -> str:
    if number < 20:
        return ENGLISH[number]
    if number < 100:
        one = f"-{ENGLISH[number % 10]}" if number % 10 else ""
        return ENGLISH_TENS[number // 10 - 2] + one
    size, name = (1_000, "thousand") if number >= 1_000 else (100, "hundred")
    rest = number % size
    joint = " and " if 0 < rest < 100 else " "
    return f"{ENGLISH[number // size]} {name}" + (joint + english(rest) if rest else "")


def italian(number: int) -> str:
    if number < 20:
        return ITALIAN[number]
    if number < 100:
        ten, one = ITALIAN_TENS[number // 10 - 2], number % 10
        if one == 3:
            return ten + "tré"
        return (ten[:-1] if one in (1, 8) else ten) + (ITALIAN[one] if one else "")
    if number < 1_000:
        head = "cento" if number < 200 else ITALIAN[number // 100] + "cento"
        return head + (italian(number % 100) if number % 100 else "")
    head = "mille" if number < 2_000 else ITALIAN[number // 1_000] + "mila"
    return head + (italian(number % 1_000) if number % 1_000 else "")


def japanese(number: int) -> str:
    if number < 10:
        return JAPANESE[number]
    text = ""
    for size, name in ((1_000, "千"), (100, "百"), (10, "十")):
        digit, number = divmod(number, size)
        text += ("" if digit == 1 else JAPANESE[digit]) + name if digit else ""
    return text + (JAPANESE[number] if number else "")
