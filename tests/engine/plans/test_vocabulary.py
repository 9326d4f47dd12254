"""Spelling: one edit, found through deletions, as a plain comparison finds it."""

from hypothesis import given
from hypothesis import strategies as st

from languages.known import LANGUAGES
from plans.engine.vocabulary import Vocabulary, one_edit_apart

ITALIAN = Vocabulary(LANGUAGES["it"], ["perché", "è", "e", "parlare", "musica", "metti", "su"])
LETTERS = st.text(alphabet="abc", min_size=3, max_size=6)


def one_edit(word: str) -> set[str]:
    """Return everything one edit away, made the long way."""
    cuts = [(word[:place], word[place:]) for place in range(len(word) + 1)]
    return {
        *(left + right[1:] for left, right in cuts),
        *(left + letter + right for left, right in cuts for letter in "abc"),
        *(left + letter + right[1:] for left, right in cuts for letter in "abc" if right),
        *(left + right[1] + right[0] + right[2:] for left, right in cuts if len(right) > 1),
    }


@given(LETTERS, LETTERS)
def test_one_edit_is_one_letter_or_one_swap(one: str, two: str) -> None:
    assert one_edit_apart(one, two) == (two in one_edit(one))


@given(st.sets(LETTERS, max_size=30), LETTERS)
def test_the_index_finds_what_comparing_every_word_finds(words: set[str], said: str) -> None:
    found = Vocabulary(LANGUAGES["en"], words).spelt(said)
    assert set(found) == {word for word in words if word in one_edit(said)}


def test_accents_do_not_count_as_errors() -> None:
    assert ITALIAN.spelt("prche") == ("perché",)
    assert ITALIAN.known("perche") == "perché"


def test_short_words_that_differ_in_accents_are_twins() -> None:
    assert ITALIAN.twins("e") == ("è",)
    assert ITALIAN.twins("su") == ()


def test_a_lost_blank_leaves_two_halves() -> None:
    assert ("metti", "su") in set(ITALIAN.halves("mettisu"))
    assert ("metti", "volare") in set(ITALIAN.halves("mettivolare"))
    assert set(ITALIAN.halves("casa")) == set()


def test_endless_words_are_left_alone() -> None:
    assert ITALIAN.spelt("a" * 10_000) == ()
    assert list(ITALIAN.halves("a" * 10_000)) == []
