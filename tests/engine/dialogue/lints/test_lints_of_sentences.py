"""G2-G5, S1, P1, K2: each has a sentence or a name that provokes it; the good ones none."""

import msgspec
import pytest

from dialogue.engine.concepts import Frame, Knowledge
from dialogue.engine.content import build_content
from dialogue.engine.lints.corpus import filled_pools, filled_sentences
from dialogue.engine.lints.filled import average_length, lint_average, lint_filled
from dialogue.engine.lints.found import lint_names
from dialogue.engine.lints.grammar_en import lint_english_articles, lint_english_names
from dialogue.engine.lints.grammar_it import lint_italian_articles, lint_italian_names
from dialogue.engine.lints.particles import lint_particles
from dialogue.engine.lints.remarks import Remark
from languages.known import LANGUAGES
from plans.engine.intents import Library
from tests.engine.dialogue.lints.good import KNOWLEDGE, changed, corpus, found_by_one_word, saying
from tests.engine.dialogue.world import KNOWLEDGE as WORLDS_KNOWLEDGE
from tests.engine.dialogue.world import WORLD

TOMATOES = LANGUAGES["en"].name_forms({"name": "tomatoes", "n": "p", "bare": "tomato"})
MUSIC = LANGUAGES["en"].name_forms({"name": "music", "count": "no"})
ACQUA = LANGUAGES["it"].name_forms({"name": "acqua", "g": "f"})
ZAINI = LANGUAGES["it"].name_forms({"name": "zaini", "g": "m", "n": "p", "sg": "zaino"})


def remarks(knowledge: Knowledge, language: str) -> list[Remark]:
    read = corpus(knowledge)
    filled = (*filled_sentences(read, language), *filled_pools(read, language))
    return list(lint_filled(read, language, filled))


def pool(name: str, language: str, text: str) -> list[Remark]:
    frame = Frame(key=f"{name}.1", type=name, texts={language: text})
    return remarks(msgspec.structs.replace(KNOWLEDGE, pools={name: (frame,)}), language)


@pytest.mark.parametrize("language", ["en", "it", "ja"])
def test_good_sentences_have_no_remark(language):
    assert remarks(KNOWLEDGE, language) == []
    assert list(lint_average(language, filled_sentences(corpus(), language))) == []


@pytest.mark.parametrize(
    ("language", "code", "type_", "text"),
    [
        ("en", "G3", "c", "There is a the $hasName."),
        ("en", "G3", "c", "It is a owl of $hasName."),
        ("en", "G5", "q", "I like $hasName."),
        ("en", "P1", "c", "When I was a child I had $hasName."),
        ("en", "S1", "c", "One " + "very " * 17 + "good $hasName."),
        ("it", "G2", "c", "Ecco il zaino con $hasName."),
        ("it", "G2", "c", "Sono contento di il $hasName.bare."),
        ("it", "G5", "c", "Ti va $hasName?"),
        ("it", "P1", "w", "Sei mai andato a cercare $hasName?"),
        ("ja", "G4", "c", "$hasNameをは、いただきます。"),
        ("ja", "G4", "q", "あなたは$hasNameがお好きですか？"),
    ],
)
def test_a_sentence_provokes_its_remark_once_with_the_topics(language, code, type_, text):
    texts = {"en": "", "it": "", "ja": "", language: text}
    found = remarks(saying("HotDrink", type_, *texts.values()), language)
    (remark,) = [one for one in found if one.code == code]
    assert (remark.where, remark.language) == (f"HotDrink.{type_}9", language)
    assert remark.message.endswith("Said of HotDrink, Tea, Milk and 4 more.")
    assert not remark.finding().error
    assert remark.finding().message.endswith(f"({language}).")


def test_of_long_sentences_the_longest_is_shown():
    long = "So " + "very " * 15 + "much $hasName."
    (remark,) = remarks(saying("HotDrink", "c", long), "en")
    assert "much hot drinks." in remark.message
    assert remark.message.endswith("The sentence has 19 words. Said of HotDrink, GreenTea.")


def test_a_hard_subject_is_spoken_of_calmly_and_health_without_advice():
    gentle = changed("HotDrink", saying("HotDrink", "c", "How lovely, $hasName."), gentle=True)
    assert ("P1", "HotDrink.c9") in {(one.code, one.where) for one in remarks(gentle, "en")}
    assert remarks(saying("HotDrink", "c", "How lovely, $hasName."), "en") == []
    advice = saying("HotDrink", "c", "You should have $hasName.")
    assert remarks(advice, "en") == []
    health = msgspec.structs.replace(
        advice,
        topics=tuple(
            msgspec.structs.replace(
                one,
                key=one.key.replace("Drink", "Health") if one.key == "Drink" else one.key,
                is_a="Health" if one.is_a == "Drink" else one.is_a,
            )
            for one in advice.topics
        ),
    )
    assert [one.code for one in remarks(health, "en")] == ["P1"]


def test_tales_of_a_pool_may_be_long_and_ask_but_greetings_may_not():
    assert (
        pool("joke", "en", "Who is there? An owl. Who? " + "And so on." + " And so on." * 9) == []
    )
    assert {
        one.code for one in pool("start", "en", "Who? " + "And so on." + " And so on." * 9)
    } == {"S1"}
    assert {one.code for one in pool("joke", "en", "When I was a child, I sang.")} == {"P1"}
    assert pool("end", "ja", "では、また。") == []
    assert [one.code for one in pool("end", "ja", "あなたもお元気で。")] == ["G4"]


@pytest.mark.parametrize(
    ("template", "name"),
    [
        ("I know a $hasName.", MUSIC),
        ("$hasName is red.", TOMATOES),
        ("Why? Are $hasName loud?", MUSIC),
        ("I like these $hasName.", MUSIC),
    ],
)
def test_g3_what_does_not_agree_with_an_english_name(template, name):
    assert [one.code for one in lint_english_names(template, name)] == ["G3"]


@pytest.mark.parametrize(
    "template",
    [
        "I know a $hasName lesson.",
        "The smell of $hasName is red.",
        "$hasName {is|are} red.",
        "They say that $hasName grow.",
        "I know $hasName.one.",
    ],
)
def test_g3_what_agrees_with_every_english_name(template):
    assert lint_english_names(template, MUSIC) == lint_english_names(template, TOMATOES) == ()


def test_g3_a_and_an_go_by_sound():
    assert list(lint_english_articles("An hour, a university, an X-ray, an s, a dog's owl.")) == []
    assert len(list(lint_english_articles("A hour and an university."))) == 2


@pytest.mark.parametrize(
    ("template", "name"),
    [
        ("Ecco il $hasName.bare.", ACQUA),
        ("Ecco la $hasName.bare.", ACQUA),
        ("Vorrei un $hasName.sg.", ZAINI),
        ("Parlo dei $hasName.bare.", ZAINI),
        ("Ti piace $hasName?", ZAINI),
        ("Ti piacciono $hasName?", ACQUA),
        ("$hasName è bello.", ACQUA),
        ("Ah, $hasName sono vecchi.", ACQUA),
    ],
)
def test_g2_what_does_not_agree_with_an_italian_name(template, name):
    assert {one.code for one in lint_italian_names(template, name)} == {"G2"}


@pytest.mark.parametrize(
    ("template", "name"),
    [
        ("Ecco l'$hasName.bare.", ACQUA),
        ("Quell'$hasName.bare fa bene.", ACQUA),
        ("Vorrei uno $hasName.sg.", ZAINI),
        ("Parlo degli $hasName.bare.", ZAINI),
        ("Ti {piace|piacciono} $hasName?", ZAINI),
        ("Il sapore $hasName.di è buono.", ZAINI),
        ("$hasName è bella.", ACQUA),
    ],
)
def test_g2_what_agrees_with_an_italian_name(template, name):
    assert list(lint_italian_names(template, name)) == []


def test_g2_italian_articles_go_by_sound():
    wrong = "Il zaino del acqua, un studente alla amica degli cani."
    assert len(list(lint_italian_articles(wrong))) == 5
    right = "Lo zaino dell'acqua, uno studente all'amica dei cani, a una a una, un'ora, il whisky."
    assert list(lint_italian_articles(right)) == []


@pytest.mark.parametrize("text", ["$hasNameがを、", "$toNameのは、", "$hasName.bareをに、"])
def test_g4_particles_that_do_not_meet(text):
    assert [one.code for one in lint_particles(text)] == ["G4"]


@pytest.mark.parametrize(
    "text",
    [
        "$hasNameには、",
        "$hasNameとの思い出",
        "$hasNameがとても",
        "$hasNameをもらったら",
        "$hasNameはかごに",
        "をは、",
    ],
)
def test_g4_particles_that_do_meet(text):
    assert lint_particles(text) == ()


def test_s1_sentences_are_too_long_on_average():
    long = saying("HotDrink", "c", "So " + "very " * 12 + "much $hasName.")
    only = tuple(
        one for one in filled_sentences(corpus(long), "en") if one.line.key == "HotDrink.c9"
    )
    assert [one.code for one in lint_average("en", only)] == ["S1"]
    assert average_length("en", ()) == 0


def test_k2_every_topic_is_found_by_its_name_unless_another_takes_it():
    good = found_by_one_word()
    assert list(lint_names(build_content(good, Library()))) == []
    hidden = changed("Milk", good, keywords={"en": (("cow",), ("*",))})
    stolen = build_content(
        changed("Tea", hidden, keywords={"en": (("milk", "tea"), ("*",))}), Library()
    )
    (remark,) = [one for one in lint_names(stolen) if one.language == "en"]
    assert (remark.code, remark.where) == ("K2", "Milk")
    assert "leads to Tea" in remark.message


def test_k2_goes_the_way_of_a_talk_through_the_intents():
    lost = {one.where for one in lint_names(WORLD) if one.language == "en"}
    assert "Coffee" not in lost
    assert len(lost) < len(WORLDS_KNOWLEDGE.topics) / 2
