"""Any sentence in three languages: matchers never raise, and their work grows like a line."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dialogue.engine.content import Content
from tests.fuzz.steps import steps
from tests.fuzz.strategies import LANGUAGES, examples, sentences

SHORT, LONG = 100, 800
UNITS = [
    "play ", "play the song ", "I love tea and ", "a", " ", "é ", "e\u0301", "non lo so, ",
    "metti ", "音楽を", "パン", "ー", "をかけて", "茶", "9 ", "twenty one ", ", ", "play (a|b) ",
    "🎵", "\u200d", "İ", "you know ", "\x00", "l'", "'", "-", ". ", "ﬀ", "vorrei che tu ",
]  # fmt: skip


@examples(150)
@given(data=st.data(), code=LANGUAGES)
def test_any_sentence_is_matched_by_words_of_its_own(
    shipped: Content, data: st.DataObject, code: str
) -> None:
    said = data.draw(sentences(shipped.catalogue, code))[:1000]
    match = shipped.catalogue.match(said, code) or shipped.catalogue.suggest(said, code)
    assert match is None or set(match.parameters) <= {slot.name for slot in match.intent.slots}
    for found in shipped.keywords[code].search(said):
        assert found.words
        assert all(word in said for word in found.words)


@pytest.mark.parametrize("code", ["en", "it", "ja"])
@pytest.mark.parametrize("unit", UNITS)
def test_the_work_of_a_long_sentence_grows_like_a_line(
    shipped: Content, unit: str, code: str
) -> None:
    def work(length: int) -> int:
        said = (unit * length)[:length]
        shipped.catalogue.forget(code)

        def match() -> None:
            shipped.catalogue.match(said, code)
            shipped.catalogue.suggest(said, code)
            shipped.keywords[code].search(said)

        match()  # builds what is built on first use
        shipped.catalogue.forget(code)
        return steps(match)

    assert work(LONG) <= LONG // SHORT * 2 * work(SHORT) + 20_000
