"""Sentence texts with gaps, compiled and filled."""

from pathlib import Path

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as some

from languages.known import LANGUAGES
from languages.templates import TemplateError, compile_template

GNOCCHI = LANGUAGES["it"].name_forms({"name": "gnocchi", "g": "m", "n": "p"})
PIZZA = LANGUAGES["it"].name_forms({"name": "pizza", "g": "f"})
DOGS = LANGUAGES["en"].name_forms({"name": "dogs", "n": "p", "bare": "dog"})
TEA = LANGUAGES["en"].name_forms({"name": "green tea", "count": "no"})
SUSHI = LANGUAGES["ja"].name_forms({"name": "寿司", "polite": "お寿司"})


def english(text: str, **variables: str) -> str:
    return compile_template(text, "en").fill({"hasName": TEA, "toName": DOGS}, variables)


@pytest.mark.parametrize(
    ("text", "filled"),
    [
        ("do you like $hasName?", "Do you like green tea?"),
        ("$hasName {is|are} good. $hasName.", "Green tea is good. Green tea."),
        ("Speaking of $hasName, $toName.one comes to mind.",
         "Speaking of green tea, a dog comes to mind."),
        ("$name, I like $hasName. $desspk $prevspk", "$name, I like green tea. $desspk $prevspk"),
        ("{is|are} it $hasName? \"yes\" it is!", "Is it green tea? \"Yes\" it is!"),
        ("well... we see. 3.5 cups", "Well... we see. 3.5 cups"),
        ("No gap.", "No gap."),
    ],
)  # fmt: skip
def test_english_sentences_are_filled(text: str, filled: str) -> None:
    assert english(text) == filled


def test_italian_switches_agree_with_the_name() -> None:
    text = "Ti {piace|piacciono} $hasName? {È|Sono} buon{o|a|i|e}"
    template = compile_template(text, "it")
    assert template.fill({"hasName": PIZZA}, {}) == "Ti piace la pizza? È buona"
    assert template.fill({"hasName": GNOCCHI}, {}) == "Ti piacciono gli gnocchi? Sono buoni"


def test_japanese_names_need_no_separator() -> None:
    template = compile_template("$hasNameは$hasName.bareです。", "ja")
    assert template.fill({"hasName": SUSHI}, {}) == "お寿司は寿司です。"


def test_the_variables_of_a_template_are_known_before_filling() -> None:
    template = compile_template("$unit $hasName.bare, $toName e {a|b} $name", "it")
    assert template.variables == {"unit", "hasName.bare", "hasName", "toName"}


def test_a_class_variable_may_hold_the_name() -> None:
    filled = english("$when people meet $when.", when="during $hasName")
    assert filled == "During green tea people meet during green tea."


def test_only_the_first_letter_becomes_a_capital() -> None:
    assert english("$who smiles.", who="mr. smith") == "Mr. smith smiles."
    assert english("$who", who="") == ""


def test_a_part_of_speech_gets_no_capital() -> None:
    template = compile_template("playsong title=$hasName.bare", "en", sentence=False)
    assert template.fill({"hasName": TEA}, {}) == "playsong title=green tea"


@pytest.mark.parametrize(
    ("text", "position"),
    [("See $hasName.one", 4), ("$unit of it", 0), ("$when", 0), ("$toName", 0)],
)
def test_what_is_missing_is_told_with_its_place(text: str, position: int) -> None:
    with pytest.raises(TemplateError) as error:
        compile_template(text, "en").fill({"hasName": TEA}, {"when": "on $day"})
    assert error.value.position == (3 if text == "$when" else position)


def test_a_switch_without_a_name_is_an_error() -> None:
    with pytest.raises(TemplateError, match="needs"):
        compile_template("It {is|are}", "en").fill({}, {})


@pytest.mark.parametrize(
    ("language", "text", "position"),
    [
        ("en", "", 0),
        ("en", "cost: $5", 6),
        ("en", "a {b", 2),
        ("en", "a } b", 2),
        ("en", "a|b", 1),
        ("en", "{is $unit|are}", 0),
        ("en", "{a|b|c}", 0),
        ("en", "good{o|a|i|e}", 4),
        ("it", "{solo}", 0),
        ("it", "Ecco $hasName.one", 5),
        ("it", "$unit.di", 0),
        ("ja", "{は|が}", 0),
    ],
)
def test_an_unreadable_text_is_refused_with_its_place(
    language: str, text: str, position: int
) -> None:
    with pytest.raises(TemplateError) as error:
        compile_template(text, language)
    assert error.value.position == position


@given(some.text(some.sampled_from("ab $hasName.di{}|.!? "), max_size=40))
def test_any_text_compiles_or_is_refused(text: str) -> None:
    try:
        template = compile_template(text, "it")
    except TemplateError as error:
        position = error.position
    else:
        position = 0
        wanted = template.variables - {"hasName", "hasName.di"}
        filled = template.fill({"hasName": GNOCCHI}, dict.fromkeys(wanted, "x"))
        assert not set(filled) & set("{}|$")
    assert 0 <= position <= len(text)


HERE = Path(__file__).parent
CLASSES = yaml.safe_load((HERE / "worked_classes.yaml").read_text())
LEAVES = yaml.safe_load((HERE / "worked_leaves.yaml").read_text())


def filled_sentences(kind: str, language: str) -> list[str]:
    filled = []
    templates = [
        row[language] for type, rows in CLASSES[kind].items() if type != "vars" for row in rows
    ]
    for leaf in LEAVES[kind]:
        inherited = CLASSES[kind].get("vars", {}) | leaf.get("vars", {})
        variables = {key[3:]: text for key, text in inherited.items() if key.startswith(language)}
        names = {"hasName": LANGUAGES[language].name_forms(leaf[language])}
        filled += [compile_template(text, language).fill(names, variables) for text in templates]
    return filled


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("kind", CLASSES)
def test_the_worked_classes_fill_for_all_their_leaves(kind: str, language: str) -> None:
    filled = filled_sentences(kind, language)
    assert len(filled) == 120
    assert not any(set(text) & set("${}|") for text in filled)


@pytest.mark.parametrize(
    ("kind", "language", "sentence"),
    [
        ("Dish", "it", "Ti piacciono gli gnocchi?"),
        ("Drink", "it", "Va bene, non ti proporrò più una tazzina di espresso."),
        ("Profession", "it", "C'è uno psicologo nella tua famiglia?"),
        ("City", "it", "Ti piacerebbe passare qualche giorno all'Aia?"),
        ("Festival", "en", "How lovely! People seem a little closer on New Year's Day."),
        ("Animal", "en", "Have you ever seen an owl up close?"),
        ("Instrument", "ja", "フルートを吹いたことはありますか？"),
    ],
)
def test_worked_sentences_read_well(kind: str, language: str, sentence: str) -> None:
    assert sentence in filled_sentences(kind, language)
