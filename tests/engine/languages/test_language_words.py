"""Inflections of keywords, and the person's words said back to them."""

import pytest
from hypothesis import given
from hypothesis import strategies as some

from languages.known import LANGUAGES


@pytest.mark.parametrize(
    ("language", "word", "forms"),
    [
        ("en", "dog", "dogs"),
        ("en", "dogs", "dog"),
        ("en", "dance", "dances danced dancing"),
        ("en", "stop", "stops stopped stopping"),
        ("en", "visit", "visited visiting"),
        ("en", "travel", "travelled travelling traveled"),
        ("en", "happy", "happier happiest"),
        ("en", "big", "bigger biggest"),
        ("en", "study", "studies studied studying"),
        ("en", "play", "plays played playing"),
        ("en", "bus", "buses"),
        ("en", "watch", "watches watched watching"),
        ("en", "watches", "watch"),
        ("en", "cherries", "cherry"),
        ("en", "potato", "potatoes"),
        ("en", "tie", "tied tying"),
        ("en", "see", "sees seeing"),
        ("en", "agree", "agreed agreeing"),
        ("en", "child", "children"),
        ("en", "women", "woman"),
        ("it", "gatto", "gatti"),
        ("it", "amica", "amiche"),
        ("it", "arancia", "arance"),
        ("it", "problema", "problemi"),
        ("it", "pianista", "pianisti pianiste"),
        ("it", "zio", "zii"),
        ("it", "fiori", "fiore"),
        ("it", "rosso", "rossa rossi rosse"),
        ("it", "bianco", "bianca bianchi bianche"),
        ("it", "vecchio", "vecchi vecchia vecchie"),
        ("it", "dolce", "dolci"),
        ("it", "goloso", "golosa golosi golose"),
        ("it", "ballare", "ballo balla balliamo ballavo ballato ballando ballerò ballarla"),
        ("it", "giocare", "gioco giochi giocherò giocavo"),
        ("it", "mangiare", "mangio mangi mangerò mangiamo mangiato"),
        ("it", "sciare", "scio scii scierò sciato".replace("scii ", "")),
        ("it", "leggere", "leggo leggi legge leggeva leggendo"),
        ("it", "dormire", "dormo dormi dormito dormiva"),
        ("it", "finire", "finisco finisce"),
        ("it", "alzarsi", "alzo alzare alzarmi"),
        ("ja", "泳ぐ", "泳ぎ 泳い"),
        ("ja", "食べる", "食べて 食べま"),
        ("ja", "走る", "走っ 走り"),
        ("ja", "見る", "見た 見ま"),
        ("ja", "語り合う", "語り合っ"),
        ("ja", "止まる", "止まっ 止まり"),
        ("ja", "楽しい", "楽しく 楽しか"),
        ("ja", "散歩する", "散歩し"),
    ],
)
def test_regular_forms_are_found(language: str, word: str, forms: str) -> None:
    assert {word, *forms.split()} <= LANGUAGES[language].inflections(word)


@pytest.mark.parametrize(
    ("language", "word", "other"),
    [
        ("en", "ham", "hammer"),
        ("en", "news", "new"),
        ("en", "see", "seed"),
        ("en", "glass", "glas"),
        ("it", "caso", "casa"),
        ("it", "porto", "porta"),
        ("it", "solare", "sola"),
        ("it", "cenere", "cena"),
        ("it", "sale", "sala"),
        ("ja", "およぐ", "およ"),
        ("ja", "世界", "世"),
    ],
)
def test_other_words_are_not_forms(language: str, word: str, other: str) -> None:
    assert other not in LANGUAGES[language].inflections(word)


@pytest.mark.parametrize(
    ("language", "word"), [("en", "tv"), ("it", "tè"), ("ja", "犬"), ("it", "bar")]
)
def test_short_and_unchanging_words_stay_alone(language: str, word: str) -> None:
    assert LANGUAGES[language].inflections(word) == {word}


@given(some.text(max_size=12), some.sampled_from(list(LANGUAGES)))
def test_a_word_is_among_its_forms(word: str, language: str) -> None:
    assert word in LANGUAGES[language].inflections(word)


@pytest.mark.parametrize(
    ("language", "words", "returned"),
    [
        ("en", "my wife Margaret", "your wife Margaret"),
        ("en", "My sister and I", "Your sister and you"),
        ("en", "the house I was born in", "the house you were born in"),
        ("en", "what I am, I'm proud of", "what you are, you're proud of"),
        ("en", "I’m afraid of you", "you’re afraid of me"),
        ("en", "our home", "your home"),
        ("en", "Mimi and the island", "Mimi and the island"),
        ("it", "mia moglie Anna", "tua moglie Anna"),
        ("it", "Il mio cane e io sono felici", "Il tuo cane e tu sei felici"),
        ("it", "i miei figli", "i tuoi figli"),
        ("it", "chi m'ama", "chi t'ama"),
        ("ja", "私の妻の春子", "奥様の春子さん"),
        ("ja", "うちの孫ちゃん", "お孫さん"),
        ("ja", "亡くなった主人", "亡くなったご主人"),
        ("ja", "お母さんと母国", "お母さんと母国"),
    ],
)
def test_the_persons_words_are_returned(language: str, words: str, returned: str) -> None:
    assert LANGUAGES[language].their_words(words) == returned
