"""Number words of the three languages, for slots of kind number."""

from collections.abc import Mapping

_UP_TO_TWENTY = {
    "en": "zero one two three four five six seven eight nine ten eleven twelve thirteen fourteen "
    "fifteen sixteen seventeen eighteen nineteen twenty",
    "it": "zero uno due tre quattro cinque sei sette otto nove dieci undici dodici tredici "
    "quattordici quindici sedici diciassette diciotto diciannove venti",
    "ja": "ゼロ 一 二 三 四 五 六 七 八 九 十 十一 十二 十三 十四 十五 十六 十七 十八 十九 二十",
}
_FROM_THIRTY = {
    "en": "thirty forty fifty sixty seventy eighty ninety",
    "it": "trenta quaranta cinquanta sessanta settanta ottanta novanta",
    "ja": "三十 四十 五十 六十 七十 八十 九十",
}


def number_words(language: str) -> Mapping[str, str]:
    """Return the number words of a language with their digits: {"five": "5"}."""
    small = _UP_TO_TWENTY.get(language, "").split()
    tens = _FROM_THIRTY.get(language, "").split()
    words = {word: str(number) for number, word in enumerate(small)}
    return words | {word: str(30 + 10 * step) for step, word in enumerate(tens)}
