"""What every language offers."""

import pytest

from languages.known import LANGUAGES
from languages.language import NameForms


def test_the_languages_are_known_in_order_and_fixed() -> None:
    assert list(LANGUAGES) == ["en", "it", "ja"]
    with pytest.raises(TypeError):
        LANGUAGES["xx"] = LANGUAGES["en"]  # type: ignore[index]


@pytest.mark.parametrize("code", LANGUAGES)
def test_a_language_tells_its_names_and_fields(code: str) -> None:
    language = LANGUAGES[code]
    assert language.code == code
    assert language.tag.startswith(code)
    assert language.own_name
    assert "bare" in language.form_names
    assert "name" in language.name_fields
    assert language.spaced is (code != "ja")


def test_name_forms_cannot_be_changed() -> None:
    forms = {"": "tea"}
    tea = NameForms(forms)
    forms[""] = "milk"
    assert tea.forms[""] == "tea"
    with pytest.raises(TypeError):
        tea.forms[""] = "milk"  # type: ignore[index]
