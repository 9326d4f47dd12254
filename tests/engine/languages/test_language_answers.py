"""What an answer to a yes/no question says, by a list of real ones."""

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as some

from languages.known import LANGUAGES
from languages.language import Attitude
from tests.engine.growth import grows_like_a_line


def listed_answers() -> list[tuple[str, str, str]]:
    answers = []
    for line in (Path(__file__).parent / "answers.txt").read_text().splitlines():
        if line.startswith("["):
            language, attitude = line.strip("[]").split()
        elif line and not line.startswith("#"):
            answers.append((language, attitude, line))
    return answers


@pytest.mark.parametrize(("language", "attitude", "sentence"), listed_answers())
def test_an_answer_is_understood(language: str, attitude: str, sentence: str) -> None:
    assert LANGUAGES[language].attitude(sentence) is Attitude[attitude]


@given(some.text(max_size=200), some.sampled_from(list(LANGUAGES)))
def test_any_text_has_an_attitude(sentence: str, language: str) -> None:
    assert LANGUAGES[language].attitude(sentence) in Attitude


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize(
    "piece", ["non ", "I don't like it ", "あまり好き", "yes, ", "mi piace ma "]
)
def test_a_very_long_answer_is_read_quickly(language: str, piece: str) -> None:
    attitude = LANGUAGES[language].attitude
    assert grows_like_a_line(lambda size: attitude(piece * size), 1_000)
