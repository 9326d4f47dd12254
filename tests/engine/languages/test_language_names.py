"""The forms of names in three languages."""

import pytest
from hypothesis import given
from hypothesis import strategies as some

from languages.english_names import with_article
from languages.known import LANGUAGES
from languages.language import FormError, NameForms

AN = """hour|honest man|honour|heir|heirloom|honorary member|X-ray|MP|umbrella|uncle|urn|urge
|uninformed man|unidentified object|unanswered letter|usher|utter mess|onion|onerous task|owl
|8-year-old|11|18,000-mile walk|80th birthday|FBI agent|SOS|LP|e-mail|RAF pilot|urban area
|Urdu poem|urchin|island|A4 sheet|hors d'oeuvre|us soldier|élite school|unimportant detail"""
A = """university|European|one-way street|ukulele|utensil|unicorn|uniform|union|unit|unique chance
|useful thing|user|utopia|US soldier|UFO|UNESCO site|unilateral act|unanimous vote|Ukrainian
|Uruguayan|urologist|uranium mine|ewe|eulogy|once-over|honey|house|T-shirt|U-turn|NATO base|100
|180-page book|DJ|yo-yo|Ouija board|Ugandan|UK visit|utility|ubiquitous sign|euro|usual day|one
|unicycle|Uighur|history|Unitarian|hotel|1,800 miles|§ sign"""
ITALIAN = """il tè verde|lo zaino|lo psicologo|lo yogurt|lo iodio|lo swing|l'hotel|lo pneumatico
|il whisky|lo xilofono|lo sci|l'ananas|lo shampoo|lo gnomo|lo czar|il jazz|l'euro|il suono|lo yen
|l'8 marzo|il 25 aprile|l'11 settembre|l'11000 lire|il DVD|l'SMS|l'UFO|l'Iran|lo tsunami|il pane
|l'«Otello»|il sasso|lo stivale|il … silenzio"""
ITALIAN_FEMININE = """l'acqua|la iena|la psiche|l'amica|la sedia|l'élite|la zia|l'Aia|l'hostess
|la scuola|l'ypsilon"""
ITALIAN_PLURAL = (
    "gli gnocchi|gli dei|i cani|gli uomini|gli spaghetti|gli Stati Uniti|gli zii|i sassi"
)


def rows(text: str) -> list[str]:
    return [row.strip() for row in text.split("|")]


def italian(**fields: str) -> NameForms:
    return LANGUAGES["it"].name_forms(fields)


def english(**fields: str) -> NameForms:
    return LANGUAGES["en"].name_forms(fields)


@pytest.mark.parametrize("words", rows(AN))
def test_an_stands_before_vowel_sounds(words: str) -> None:
    assert with_article(words) == f"an {words}"


@pytest.mark.parametrize("words", rows(A))
def test_a_stands_before_consonant_sounds(words: str) -> None:
    assert with_article(words) == f"a {words}"


def test_words_without_letters_take_a() -> None:
    assert with_article("…") == "a …"


def test_an_english_plural_has_one_only_through_its_bare_form() -> None:
    dogs = english(name="dogs", n="p", bare="dog")
    assert dict(dogs.forms) == {"": "dogs", "bare": "dog", "one": "a dog"}
    assert dogs.plural
    assert "one" not in english(name="gnocchi", n="p").forms


def test_uncounted_english_names_have_no_one() -> None:
    assert "one" not in english(name="tennis", count="no").forms
    assert "one" not in english(name="the Moon").forms


def test_an_author_may_write_one() -> None:
    assert (
        english(name="trousers", n="p", one="a pair of trousers").forms["one"].startswith("a pair")
    )


def words_of(text: str) -> tuple[str, str]:
    return text, text.split("'", 1)[1] if text.startswith("l'") else text.split(" ", 1)[1]


@pytest.mark.parametrize(("whole", "name"), [words_of(row) for row in rows(ITALIAN)])
def test_italian_masculine_articles(whole: str, name: str) -> None:
    assert italian(name=name, g="m").forms[""] == whole


@pytest.mark.parametrize(("whole", "name"), [words_of(row) for row in rows(ITALIAN_FEMININE)])
def test_italian_feminine_articles(whole: str, name: str) -> None:
    assert italian(name=name, g="f").forms[""] == whole


@pytest.mark.parametrize(("whole", "name"), [words_of(row) for row in rows(ITALIAN_PLURAL)])
def test_italian_plural_articles(whole: str, name: str) -> None:
    assert italian(name=name, g="m", n="p").forms[""] == whole


@pytest.mark.parametrize(
    ("fields", "forms"),
    [
        ({"name": "zaino", "g": "m"}, "dello allo dallo nello sullo con_lo uno"),
        ({"name": "tè", "g": "m"}, "del al dal nel sul con_il un"),
        ({"name": "pizza", "g": "f"}, "della alla dalla nella sulla con_la una"),
        ({"name": "gnocchi", "g": "m", "n": "p", "sg": "gnocco"},
         "degli agli dagli negli sugli con_gli uno"),
        ({"name": "cani", "g": "m", "n": "p", "sg": "cane"}, "dei ai dai nei sui con_i un"),
        ({"name": "mele", "g": "f", "n": "p", "sg": "mela"},
         "delle alle dalle nelle sulle con_le una"),
    ],
)  # fmt: skip
def test_italian_prepositions_melt_with_the_article(fields: dict[str, str], forms: str) -> None:
    found = italian(**fields).forms
    names = [found[form] for form in ("di", "a", "da", "in", "su", "con", "un")]
    assert [name.rsplit(" ", 1)[0].replace(" ", "_") for name in names] == forms.split()


def test_elided_articles_touch_the_name() -> None:
    water = italian(name="acqua", g="f").forms
    assert (water["di"], water["con"], water["un"]) == ("dell'acqua", "con l'acqua", "un'acqua")


def test_a_city_takes_no_article() -> None:
    rome = italian(name="Roma", g="f", art="none").forms
    assert (rome[""], rome["di"], rome["dove"]) == ("Roma", "di Roma", "a Roma")
    assert italian(name="Ancona", g="f", art="none").forms["dove"] == "ad Ancona"


def test_italian_proper_and_uncounted_names_have_no_un() -> None:
    assert "un" not in italian(name="Colosseo", g="m").forms
    assert "un" not in italian(name="Roma", g="f", art="none").forms
    assert "un" not in italian(name="calcio", g="m", count="no").forms
    assert italian(name="Vespe", g="f", n="p", sg="Vespa").forms["un"] == "una Vespa"


def test_a_plural_without_singular_has_neither_sg_nor_un() -> None:
    forms = italian(name="lasagne", g="f", n="p")
    assert not {"sg", "un", "dove"} & set(forms.forms)
    assert forms.plural
    assert forms.feminine


def test_the_article_an_author_writes_goes_into_every_form() -> None:
    iowa = italian(name="iowa", g="m", il="lo iowa", dove="in Iowa").forms
    assert (iowa[""], iowa["di"], iowa["un"]) == ("lo iowa", "dello iowa", "uno iowa")
    hans = italian(name="Hans", g="m", il="l'Hans").forms
    assert hans["a"] == "all'Hans"


def test_a_name_written_whole_keeps_the_articles_of_the_rules() -> None:
    forms = italian(name="Aia", g="f", il="Den Haag", di="di Den Haag").forms
    assert (forms[""], forms["di"], forms["a"]) == ("Den Haag", "di Den Haag", "all'Aia")


def test_japanese_names_are_polite_first() -> None:
    sushi = LANGUAGES["ja"].name_forms({"name": "寿司", "polite": "お寿司", "kana": "すし"})
    assert dict(sushi.forms) == {"": "お寿司", "bare": "寿司", "kana": "すし"}
    piano = LANGUAGES["ja"].name_forms({"name": "ピアノ"})
    assert dict(piano.forms) == {"": "ピアノ", "bare": "ピアノ", "kana": "ピアノ"}


@pytest.mark.parametrize(
    ("language", "fields", "field"),
    [
        ("en", {}, "name"),
        ("en", {"name": "dog", "colour": "brown"}, "colour"),
        ("en", {"name": "dog", "n": "many"}, "n"),
        ("en", {"name": "dog", "count": "maybe"}, "count"),
        ("en", {"name": " dog"}, "name"),
        ("en", {"name": "dog", "bare": ""}, "bare"),
        ("en", {"name": "$dog"}, "name"),
        ("en", {"name": "d" * 121}, "name"),
        ("it", {"name": "cane"}, "g"),
        ("it", {"name": "cane", "g": "x"}, "g"),
        ("it", {"name": "cane", "g": "m", "art": "il"}, "art"),
        ("ja", {"name": "犬", "n": "p"}, "n"),
    ],
)
def test_a_wrong_field_is_named(language: str, fields: dict[str, str], field: str) -> None:
    with pytest.raises(FormError) as error:
        LANGUAGES[language].name_forms(fields)
    assert error.value.field == field
    assert error.value.hint in str(error.value)


NAMES = some.text(some.characters(categories=["L", "N", "P"]), min_size=1, max_size=20).filter(
    lambda text: not set(text) & set("{}|$")
)


@given(NAMES, some.sampled_from("mf"), some.sampled_from("sp"))
def test_italian_forms_contain_the_name_and_are_known(name: str, gender: str, number: str) -> None:
    forms = italian(name=name, g=gender, n=number).forms
    assert all(text.endswith(name) for text in forms.values())
    assert set(forms) <= LANGUAGES["it"].form_names | {""}


@given(NAMES)
def test_english_forms_contain_the_name_and_are_known(name: str) -> None:
    forms = english(name=name).forms
    assert all(text.endswith(name) for text in forms.values())
    assert set(forms) <= LANGUAGES["en"].form_names | {""}
