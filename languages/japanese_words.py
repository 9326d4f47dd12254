"""Japanese word forms: the stems a keyword may end in, and 「妻」 said politely as 「奥様」."""

import re

_KANJI = "\u3005\u4e00-\u9fff"
_GODAN = {
    "う": "いっわえお", "く": "きいかけこ", "ぐ": "ぎいがげご", "す": "しさせそ",
    "つ": "ちったてと", "ぬ": "にんなねの", "ぶ": "びんばべぼ", "む": "みんまめも",
    "る": "りっられろ",
}  # fmt: skip
_ICHIDAN = ("て", "た", "ま", "な", "ら", "よ", "れ", "ず")
_ADJECTIVE = ("く", "か", "さ", "け")
_I_OR_E = "いきぎしじちぢにひびみりえけげせぜてでねへべめれ"
_HAS_KANJI = re.compile(f"[{_KANJI}]")


def inflections(word: str) -> frozenset[str]:
    """Return a word with the beginnings of its forms: 泳ぐ, 泳ぎ, 泳い …; 楽しい, 楽しく, 楽しか.

    Keywords are matched as the longest substring, so a beginning stands for 泳ぎます and 泳いだ.
    Words without kanji stay as they are: their beginnings would be found inside other words.
    """
    if len(word) < 2 or not _HAS_KANJI.match(word):
        return frozenset((word,))
    stem, last = word[:-1], word[-1]
    endings: tuple[str, ...] = ()
    if word.endswith("する"):
        stem, endings = word[:-2], ("し", "さ", "せ", "すれ")
    elif last == "い":
        endings = _ADJECTIVE
    elif last in _GODAN:
        endings = _verb_endings(stem, last)
    return frozenset({word, *(stem + ending for ending in endings)})


def _verb_endings(stem: str, last: str) -> tuple[str, ...]:
    if last != "る":
        return tuple(_GODAN[last])
    if stem[-1] in _I_OR_E:
        return _ICHIDAN
    # 見る or 走る? Only a dictionary knows; the wrong forms are no words.
    return (*_ICHIDAN, *_GODAN["る"]) if _HAS_KANJI.match(stem[-1]) else tuple(_GODAN["る"])


#: How one speaks of the family of the person one talks to.
_POLITE = {
    "家内": "奥様", "女房": "奥様", "妻": "奥様", "嫁": "お嫁さん", "夫": "ご主人",
    "主人": "ご主人",
    "旦那": "ご主人", "母親": "お母様", "父親": "お父様", "両親": "ご両親", "母": "お母様",
    "父": "お父様", "祖母": "おばあ様", "祖父": "おじい様", "息子": "息子さん", "娘": "娘さん",
    "兄弟": "ご兄弟", "姉妹": "ご姉妹", "兄": "お兄様", "姉": "お姉様", "弟": "弟さん",
    "妹": "妹さん", "孫": "お孫さん", "子供": "お子さん", "子ども": "お子さん", "家族": "ご家族",
    "友達": "お友達", "友だち": "お友だち", "友人": "ご友人", "親戚": "ご親戚", "実家": "ご実家",
    "故郷": "ふるさと", "叔母": "おば様", "伯母": "おば様", "叔父": "おじ様", "伯父": "おじ様",
    "姪": "姪御さん", "甥": "甥御さん", "おふくろ": "お母様", "おやじ": "お父様",
}  # fmt: skip
_MINE = re.compile(
    r"(?:亡くなった|死んだ)(?=(?:私|わたし|僕|ぼく|俺|うち)の)"
    r"|(?:私たち|私達|わたしたち|私|わたし|わたくし|あたし|僕|ぼく|俺|おれ|自分|うち|我が家)の"
)
_FAMILY = re.compile(
    f"(?<![{_KANJI}おご])(?:{'|'.join(sorted(_POLITE, key=len, reverse=True))})"
    f"(?:さん|さま|様|ちゃん|君|くん)?(?![{_KANJI}])"
)
_TITLED = re.compile(r"(?:さん|さま|様|ちゃん|君|くん)$")
# A given name behind a relative gets its さん: 奥様の和子 → 奥様の和子さん. Known by its last
# character; words that merely end like one (帽子, 様子) are not names.
_NAMED = re.compile(
    rf"(?<=の)((?!(?:椅|帽|様|調|弟|菓|餃|扇|女|男|親|迷|利|障|冊|王|双|種|団|獅|硝)子)"
    rf"[{_KANJI}]{{1,2}}[子美江恵代枝郎雄男夫助介吉太])$"
)


def their_words(words: str) -> str:
    """Return the person's words as the agent says them: 「私の妻の春子」 is 「奥様の春子さん」.

    Words already polite (お母さん) and parts of other words (母国) stay.
    """
    turned = _FAMILY.sub(_turned, _MINE.sub("", words))
    return turned if turned == words else _NAMED.sub(r"\1さん", turned)


def _turned(found: re.Match[str]) -> str:
    return _POLITE[_TITLED.sub("", found.group())]
