"""Japanese as the service knows it."""

import re
from collections.abc import Mapping

from languages import japanese_names, japanese_words
from languages.answers import read_answer
from languages.japanese_answers import (
    JAPANESE_ANSWERS,
    JAPANESE_LONG_ANSWERS,
    LONGEST_SHORT_ANSWER,
)
from languages.language import Attitude, NameForms, Token
from languages.tokens import CHARACTERS, as_hiragana, find_tokens

_SEEN = re.compile(
    r"(?:(?:へえ|へぇ|ふうん|ふーん|ああ|あら|まあ|はい|ええ)[、。…\s]*)?"
    r"(?:そう|そうなの|そうなん|さよう)(?:です|でした|でしょう|だったんです)か[。.、…\s]*"
)


class Japanese:
    """Japanese; stateless, use the instance JAPANESE."""

    code = "ja"
    tag = "ja-JP"
    own_name = "日本語"
    spaced = False
    form_names = japanese_names.FORMS
    name_fields = japanese_names.FIELDS

    def tokens(self, sentence: str) -> tuple[Token, ...]:
        """Return the words of a sentence."""
        return find_tokens(sentence, CHARACTERS)

    def inflections(self, word: str) -> frozenset[str]:
        """Return the regular forms of a word."""
        return japanese_words.inflections(word)

    def name_forms(self, fields: Mapping[str, str]) -> NameForms:
        """Return every form of a name."""
        return japanese_names.name_forms(fields)

    def attitude(self, sentence: str) -> Attitude:
        """Return what an answer says."""
        tokens = self.tokens(sentence)
        short = len(tokens) <= LONGEST_SHORT_ANSWER
        return read_answer(sentence, tokens, JAPANESE_ANSWERS if short else JAPANESE_LONG_ANSWERS)

    def their_words(self, words: str) -> str:
        """Return the person's words as the agent says them."""
        return japanese_words.their_words(words)

    def asks(self, sentence: str) -> bool:
        """Say whether the sentence is a question; 「そうですか。」 only shows that one listens."""
        if _SEEN.fullmatch(sentence.strip()):
            return False
        return sentence.rstrip(" 。.").endswith(("?", "？", "ですか", "ますか", "でしょうか"))

    def listed(self, names: tuple[str, ...]) -> str:
        """Return names as a choice."""
        return "、".join(names)

    def fold(self, text: str) -> str:
        """Return katakana as hiragana, one character for one: コーヒー becomes こーひー."""
        return as_hiragana(text)


JAPANESE = Japanese()
