"""Italian as the service knows it."""

from collections.abc import Mapping

from languages import italian_names, italian_words
from languages.answers import read_answer
from languages.italian_answers import ITALIAN_ANSWERS
from languages.language import Attitude, NameForms, Token
from languages.listing import listed
from languages.tokens import WORDS, find_tokens, without_accents


class Italian:
    """Italian; stateless, use the instance ITALIAN."""

    code = "it"
    tag = "it-IT"
    own_name = "Italiano"
    spaced = True
    form_names = italian_names.FORMS
    name_fields = italian_names.FIELDS

    def tokens(self, sentence: str) -> tuple[Token, ...]:
        """Return the words of a sentence."""
        return find_tokens(sentence, WORDS)

    def inflections(self, word: str) -> frozenset[str]:
        """Return the regular forms of a word."""
        return italian_words.inflections(word)

    def name_forms(self, fields: Mapping[str, str]) -> NameForms:
        """Return every form of a name."""
        return italian_names.name_forms(fields)

    def attitude(self, sentence: str) -> Attitude:
        """Return what an answer says."""
        return read_answer(sentence, self.tokens(sentence), ITALIAN_ANSWERS)

    def their_words(self, words: str) -> str:
        """Return the person's words as the agent says them."""
        return italian_words.their_words(words)

    def asks(self, sentence: str) -> bool:
        """Say whether the sentence is a question."""
        return sentence.rstrip().endswith(("?", "？"))

    def listed(self, names: tuple[str, ...]) -> str:
        """Return names as a choice."""
        return listed(names, ", ", " o ")

    def fold(self, text: str) -> str:
        """Return the text without accents."""
        return without_accents(text)


ITALIAN = Italian()
