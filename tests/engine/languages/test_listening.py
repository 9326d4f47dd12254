"""Words that only show that one listens are no question and no answer."""

import pytest

from languages.known import LANGUAGES
from languages.language import Attitude

JAPANESE = LANGUAGES["ja"]


@pytest.mark.parametrize(
    "sentence", ["そうですか。", "へえ、そうなんですか", "ああ、そうでしたか。"]
)
def test_i_see_is_no_question_in_japanese(sentence: str) -> None:
    assert not JAPANESE.asks(sentence)


@pytest.mark.parametrize("sentence", ["お好きですか", "そうですか、それは何ですか", "どこですか？"])
def test_a_question_still_is_one(sentence: str) -> None:
    assert JAPANESE.asks(sentence)


@pytest.mark.parametrize("sentence", ["ふうん。", "ふーん", "さあ。"])
def test_a_grunt_is_no_yes(sentence: str) -> None:
    assert JAPANESE.attitude(sentence) is Attitude.UNCLEAR


def test_a_short_yes_still_is_one() -> None:
    assert JAPANESE.attitude("うん") is Attitude.YES
