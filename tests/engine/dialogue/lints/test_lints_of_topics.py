"""C1, C2, C3, K1, L1, T1, U1: each has a knowledge base that provokes it; the good one none."""

from collections.abc import Iterable

import msgspec
import pytest

from dialogue.engine.concepts import ROOT, Knowledge
from dialogue.engine.lints.classes import lint_classes, lint_leaves
from dialogue.engine.lints.corpus import filled_sentences
from dialogue.engine.lints.graph import reachable_together
from dialogue.engine.lints.keywords import lint_keywords
from dialogue.engine.lints.ranks import rank_correlation
from dialogue.engine.lints.remarks import Remark
from dialogue.engine.lints.repeats import lint_repeats
from dialogue.engine.lints.shape import leaves_apart, lint_cultures, lint_shape
from tests.engine.dialogue.lints.good import (
    CULTURES,
    KNOWLEDGE,
    changed,
    corpus,
    frames,
    saying,
    topic,
    with_own_lines,
)

CLASS = next(one for one in KNOWLEDGE.topics if one.key == "HotDrink")
BRANCH = KNOWLEDGE.topics[0]


def codes(remarks: Iterable[Remark]) -> set[tuple[str, str]]:
    return {(one.code, one.where) for one in remarks}


def shape(knowledge: Knowledge) -> set[tuple[str, str]]:
    return codes(lint_shape(corpus(knowledge)))


def leaves(knowledge: Knowledge, language: str = "en") -> set[tuple[str, str]]:
    read = corpus(knowledge)
    return codes(lint_leaves(read, language, filled_sentences(read, language)))


def repeats(knowledge: Knowledge, language: str = "en") -> list[Remark]:
    read = corpus(knowledge)
    return list(lint_repeats(read, language, filled_sentences(read, language)))


def keywords(key: str, first: tuple[str, ...], second: tuple[str, ...] = ("*",)) -> list[Remark]:
    knowledge = changed(key, keywords={"en": (first, second)})
    return [one for one in lint_keywords(corpus(knowledge), "en") if one.where != ROOT]


def more(*topics: object) -> Knowledge:
    added = msgspec.convert(topics, tuple[type(BRANCH), ...])  # type: ignore[misc]
    return msgspec.structs.replace(KNOWLEDGE, topics=(*KNOWLEDGE.topics, *added))


def test_the_good_knowledge_base_has_no_remark_about_its_topics():
    assert codes(lint_classes(corpus())) == set()
    assert shape(KNOWLEDGE) == set()
    for language in ("en", "it", "ja"):
        assert leaves(KNOWLEDGE, language) == set()
        assert repeats(KNOWLEDGE, language) == []
        assert list(lint_keywords(corpus(), language)) == []
    assert list(lint_cultures(corpus(with_own_lines()))) == []


def test_a_class_is_what_asks_or_has_leaves_not_a_group_and_no_branch():
    assert [node.key for node in corpus().classes] == ["HotDrink"]
    deeper = [changed("Broth", is_a="Tea"), changed("Warm", frames=frames("Warm", {}))]
    assert [node.key for node in corpus(deeper[0]).classes] == ["HotDrink"]
    assert corpus(deeper[0]).class_of["Broth"].key == "HotDrink"
    assert [node.key for node in corpus(deeper[1]).classes] == ["HotDrink"]


def test_c3_a_class_lacks_a_type_in_one_language_or_in_all():
    without_g = tuple(frame for frame in CLASS.frames if frame.key != "HotDrink.g2")
    (remark,) = lint_classes(corpus(changed("HotDrink", frames=without_g)))
    assert (remark.code, remark.message, remark.language) == ("C3", "It lacks 1g.", "")
    first, *others = CLASS.frames
    silent = msgspec.structs.replace(first, texts={**first.texts, "ja": ""})
    (remark,) = lint_classes(corpus(changed("HotDrink", frames=(silent, *others))))
    assert (remark.message, remark.language) == ("It lacks 1q.", "ja")


def test_c3_a_branch_needs_general_sentences():
    only_one = tuple(frame for frame in BRANCH.frames if frame.key != "Drink.w2")
    assert codes(lint_classes(corpus(changed("Drink", frames=only_one)))) == {("C3", "Drink")}


def test_c3_a_gentle_class_needs_remarks_and_open_questions_only():
    gentle = changed("HotDrink", gentle=True)
    (remark,) = lint_classes(corpus(gentle))
    assert remark.message == "It lacks 2c."


def test_c3_sentences_for_one_culture_do_not_count():
    narrow = tuple(msgspec.structs.replace(one, only=("EN",)) for one in CLASS.frames[:1])
    knowledge = changed("HotDrink", frames=(*narrow, *CLASS.frames[1:]))
    assert codes(lint_classes(corpus(knowledge))) == {("C3", "HotDrink")}


def test_c2_a_leaf_with_too_few_sentences():
    poor = changed("Drink", changed("HotDrink", frames=CLASS.frames[:11]), frames=())
    assert ("C2", "Tea") in leaves(poor)


def test_c2_a_leaf_without_a_type_that_its_pattern_needs():
    knowledge = changed("Tea", pattern=("q r e",))
    assert leaves(knowledge) == {("C2", "Tea")}
    assert leaves(changed("Tea", pattern=("q r [e]",))) == set()


def test_c2_a_gentle_leaf_needs_no_question_that_is_never_asked():
    assert leaves(changed("Tea", gentle=True, pattern=("c w c",))) == set()
    assert leaves(changed("Tea", gentle=True, pattern=("q w c",))) == {("C2", "Tea")}


def test_c1_a_leaf_without_links_keywords_or_likeliness():
    assert shape(changed("Tea", see=("Milk",))) == {("C1", "Tea")}
    assert shape(changed("Tea", keywords={})) == {("C1", "Tea")}
    assert shape(changed("Tea", likeliness={"EN": 0.5})) == {("C1", "Tea")}


def test_t1_a_leaf_too_near_the_root_that_leads_nowhere():
    elm = topic("Elm", ROOT, 20, ("elm", "olmo", "ニレ"))
    assert ("T1", "Elm") in shape(more(elm))


def test_t1_a_class_with_a_single_leaf():
    knowledge = more(
        topic("Cold", "Drink", 20, ("cold", "freddo", "冷たいもの")),
        topic("Iced", "Cold", 21, ("iced", "ghiacciato", "氷"), frames=CLASS.frames),
        topic("Ice", "Iced", 22, ("ice", "ghiaccio", "アイス"), see=("Tea", "Milk")),
    )
    assert ("T1", "Iced") in shape(knowledge)


def test_t1_leaves_that_cannot_be_reached_from_the_others():
    knowledge = more(
        topic("Cold", "Drink", 20, ("cold", "freddo", "冷たいもの"), frames=CLASS.frames),
        topic("Ice", "Cold", 21, ("ice", "ghiaccio", "アイス"), see=("Tea", "Milk")),
        topic("Snow", "Cold", 22, ("snow", "granita", "かき氷"), see=("Tea", "Milk")),
    )
    assert leaves_apart(corpus(knowledge)) == ["Ice", "Snow"]
    assert ("T1", ROOT) in shape(knowledge)
    back = changed("Tea", knowledge, see=("Cold", "Milk"))
    assert leaves_apart(corpus(back)) == []


def test_l1_a_culture_without_a_topic_it_likes_best_and_without_lines():
    told = codes(lint_cultures(corpus()))
    assert told == {("L1", ROOT)}
    nobody = dict.fromkeys(CULTURES, 0.5)
    shared = changed("Coffee", changed("Cocoa", with_own_lines(), likeliness=nobody))
    shared = changed("Broth", changed("Coffee", shared, likeliness=nobody), likeliness=nobody)
    assert ("L1", "Drink") in codes(lint_cultures(corpus(shared)))


def test_l1_two_cultures_that_like_the_same():
    knowledge = with_own_lines()
    for one in KNOWLEDGE.topics:
        likes = {**one.likeliness, "IT": one.likeliness["EN"]}
        knowledge = changed(one.key, knowledge, likeliness=likes)
    told = [one.message for one in lint_cultures(corpus(knowledge))]
    assert "What EN and IT like is ranked alike by 1.00." in told


def test_k1_two_topics_own_one_keyword_also_in_another_order():
    (remark,) = keywords("Milk", ("drink",), ("tea",))
    assert (remark.code, remark.where) == ("K1", "Milk")
    assert "leads to Tea, Milk" in remark.message
    assert keywords("Milk", ("white",), ("tea",)) == []


@pytest.mark.parametrize("word", ["orange", "tv"])
def test_k1_a_word_of_two_meanings_or_a_short_one_stands_alone(word):
    assert [one.where for one in keywords("Milk", (word,))] == ["Milk"]
    assert keywords("Milk", (word,), ("cup",)) == []


def test_k1_a_topic_may_be_found_by_its_own_short_name():
    assert keywords("Tea", ("tea",)) == []
    assert len(keywords("Milk", ("tea",))) == 1


def test_k1_too_many_topics_found_by_one_word():
    knowledge = KNOWLEDGE
    for one in KNOWLEDGE.topics:
        knowledge = changed(one.key, knowledge, keywords={"en": ((f"{one.key} word",), ("*",))})
    (remark,) = lint_keywords(corpus(knowledge), "en")
    assert (remark.where, remark.message[:5]) == (ROOT, "100 %")


def test_u1_the_same_sentence_written_for_two_topics():
    (remark,) = repeats(saying("Drink", "w", "When do you have $hasName?"))
    assert (remark.code, remark.where) == ("U1", "HotDrink.w1")
    assert "is also Drink.w9" in remark.message


def test_u1_a_class_whose_sentences_name_nothing():
    bare = {
        "c3": ("It is warm.", "Fa caldo.", "温かいです。"),
        "c4": ("It is nice.", "È bello.", "いいですね。"),
    }
    told = repeats(changed("HotDrink", frames=(*CLASS.frames, *frames("HotDrink", bare))))
    assert ("U1", "HotDrink") in codes(told)
    assert any("is said of 7 topics" in one.message for one in told)


def test_a_rank_correlation_counts_equal_values_as_equal():
    assert rank_correlation([1, 2, 3], [10, 20, 30]) == pytest.approx(1)
    assert rank_correlation([1, 2, 3], [3, 2, 1]) == pytest.approx(-1)
    assert rank_correlation([1, 1, 1], [1, 2, 3]) == 0
    assert rank_correlation([1, 1, 2, 2], [1, 2, 1, 2]) == pytest.approx(0)


def test_nodes_lie_together_where_each_leads_to_each():
    edges = {1: (2,), 2: (3,), 3: (1, 4), 4: (5,), 5: (4,), 6: (1,)}
    assert reachable_together(edges, edges) == {1, 2, 3}
    assert reachable_together(edges, (4, 5)) == {4, 5}
    long = {number: (number + 1,) for number in range(5000)} | {5000: (0,)}
    assert len(reachable_together(long, long)) == 5001
