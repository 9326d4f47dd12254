"""Every finding about topics and pools has a knowledge base that provokes it."""

import msgspec
import pytest

from dialogue.engine.build import build_tree
from dialogue.engine.checks import LONGEST_KEY, check_knowledge
from dialogue.engine.concepts import ROOT, Frame, Knowledge
from dialogue.engine.findings import Finding
from tests.engine.dialogue.world import KNOWLEDGE, changed

TEA_NAMES = KNOWLEDGE.topics[2].names
EVERYWHERE = {"en": "Tea!", "it": "Tè!", "ja": "お茶！"}


def found(knowledge: Knowledge) -> list[tuple[str, str]]:
    return [(finding.code, finding.where) for finding in check_knowledge(knowledge)]


def tea(**fields: object) -> list[tuple[str, str]]:
    return found(changed("Tea", **fields))


def with_tea_saying(**fields: object) -> Knowledge:
    frame = {"key": "Tea.x1", "type": "c", "texts": EVERYWHERE, **fields}
    return changed("Tea", frames=(msgspec.convert(frame, Frame),))


def tea_says(**fields: object) -> list[tuple[str, str]]:
    return found(with_tea_saying(**fields))


def pool(name: str, **texts: str) -> list[tuple[str, str]]:
    frame = Frame(key=f"{name}.1", type=name, texts={**EVERYWHERE, **texts}, number=9000)
    return found(msgspec.structs.replace(KNOWLEDGE, pools={**KNOWLEDGE.pools, name: (frame,)}))


def test_the_small_world_has_no_findings():
    assert check_knowledge(KNOWLEDGE) == []


def test_d001_two_topics_of_one_name():
    twice = msgspec.structs.replace(KNOWLEDGE, topics=(*KNOWLEDGE.topics, KNOWLEDGE.topics[2]))
    assert ("D001", ROOT) in found(twice)


def test_d002_an_unknown_parent():
    assert tea(is_a="Nowhere") == [("D002", "Tea")]


def test_d003_a_circle():
    assert tea(is_a="GreenTea") == [("D003", "Tea"), ("D003", "GreenTea")]


def test_d004_an_unknown_topic_to_take_sentences_from():
    assert tea(also=("Nowhere",)) == [("D004", "Tea")]
    assert tea(also=("Music",)) == []


def test_d005_an_unknown_link():
    assert tea(see=("Nowhere",)) == [("D005", "Tea")]


@pytest.mark.parametrize("see", [("Tea",), ("Milk", "Milk")])
def test_d006_a_link_to_itself_or_twice(see):
    assert tea(see=see) == [("D006", "Tea")]


@pytest.mark.parametrize("key", [ROOT, "T" * (LONGEST_KEY + 1)])
def test_d007_a_name_that_cannot_be_used(key):
    assert ("D007", key) in found(changed("Gardening", key=key))


@pytest.mark.parametrize("fields", [{"of": "XX"}, {"likeliness": {"XX": 0.5}}])
def test_d008_an_unknown_culture(fields):
    assert tea(**fields) == [("D008", "Tea")]
    assert tea(of="EN") == []


@pytest.mark.parametrize("value", [-0.1, 1.1, float("nan")])
def test_d009_a_likeliness_out_of_range(value):
    assert tea(likeliness={"EN": value}) == [("D009", "Tea")]


def test_d010_a_missing_name():
    assert tea(names={"en": TEA_NAMES["en"], "it": TEA_NAMES["it"]}) == [("D010", "Tea")]


def test_d011_a_wrong_name():
    assert tea(names={**TEA_NAMES, "it": {"name": "tè"}}) == [("D011", "Tea")]


@pytest.mark.parametrize("pattern", ["q x", "", "c " * 16])
def test_d012_a_pattern_that_cannot_be_read(pattern):
    assert tea(pattern=(pattern,)) == [("D012", "Tea")]


def test_d013_a_type_to_stop_that_does_not_exist():
    assert tea(stop="qxy") == [("D013", "Tea")]
    finding = check_knowledge(changed("Tea", stop="yx"))[0]
    assert finding.message == "It stops the types x y, which do not exist."


def test_d014_an_unknown_type():
    assert tea_says(type="x") == [("D014", "Tea.x1")]


@pytest.mark.parametrize("text", [None, "", " "])
def test_d015_a_missing_sentence(text):
    texts = {"en": "Tea!", "it": "Tè!", "ja": text}
    some = {code: one for code, one in texts.items() if one is not None}
    assert tea_says(texts=some) == [("D015", "Tea.x1")]
    (gap,) = check_knowledge(with_tea_saying(texts=some))
    assert not gap.error
    assert "ja" in gap.message


def test_d015_a_sentence_that_nobody_hears_is_an_error():
    mute = check_knowledge(with_tea_saying(texts={"en": " "}))
    assert [(one.code, one.error) for one in mute] == [("D015", True)] * 3


def test_d016_a_sentence_for_an_unknown_culture():
    assert tea_says(only=("XX",)) == [("D016", "Tea.x1")]
    assert tea_says(only=("JP",)) == []


def test_d017_a_proposal_without_its_activity():
    assert tea_says(type="g") == [("D017", "Tea.x1")]


@pytest.mark.parametrize("do", ["playsong title", "playsong title=$", "play-song"])
def test_d018_an_activity_that_cannot_be_read(do):
    assert tea_says(type="g", do=do) == [("D018", "Tea.x1")]


def test_d019_an_empty_pool():
    empty = msgspec.structs.replace(KNOWLEDGE, pools={**KNOWLEDGE.pools, "end": ()})
    assert found(empty) == [("D019", "end")]


def test_d019_a_pool_without_a_word_in_one_language():
    assert pool("end", ja="") == [("D019", "end"), ("D015", "end.1")]


def test_d020_an_unknown_pool():
    assert pool("jokes") == [("D020", "jokes")]


def test_d021_a_sentence_that_cannot_be_read():
    assert tea_says(texts={**EVERYWHERE, "en": "{"}) == [("D021", "Tea.x1")]
    assert pool("end", it="$") == [("D021", "end.1")]


def test_d021_a_text_in_an_unknown_language_is_passed_over():
    assert tea_says(texts={**EVERYWHERE, "fr": "{"}) == []


@pytest.mark.parametrize(
    ("fields", "topics"),
    [
        ({"texts": {**EVERYWHERE, "en": "Drink $unit."}}, ["Tea", "GreenTea"]),
        ({"texts": {**EVERYWHERE, "en": "Drink $toName."}}, ["Tea", "GreenTea"]),
        ({"type": "t", "texts": {**EVERYWHERE, "en": "$hasName, then $toName."}}, []),
        ({"type": "g", "do": "wave where=$unit"}, 3 * ["Tea"] + 3 * ["GreenTea"]),
        ({"type": "g", "do": "wave where=$hasName"}, []),
        ({"scope": "self", "texts": {**EVERYWHERE, "en": "Drink $unit."}}, ["Tea"]),
    ],
)
def test_d022_a_sentence_that_cannot_be_said_of_a_topic(fields, topics):
    assert tea_says(**fields) == [("D022", topic) for topic in topics]


def test_d023_a_pool_sentence_with_words_the_pool_does_not_know():
    assert pool("end", en="Goodbye, $toName.") == [("D023", "end.1")]
    assert pool("opener", en="And $toName?", ja="$hasName") == [("D023", "opener.1")]


def test_d024_a_pool_sentence_with_a_form_that_a_topic_lacks():
    """English: the name "drinks" is made plural here, so it has no `.one`."""
    plural = {"en": {"name": "drinks", "n": "p"}, **{c: TEA_NAMES[c] for c in ("it", "ja")}}
    knowledge = changed("Drinks", names=plural)
    frame = Frame(key="opener.1", type="opener", texts={**EVERYWHERE, "en": "Ah, $toName.one!"})
    pools = {**knowledge.pools, "opener": (frame,)}
    assert found(msgspec.structs.replace(knowledge, pools=pools)) == [("D024", "opener.1")]
    assert pool("opener", en="Ah, $toName.bare!") == []


@pytest.mark.parametrize("words", [(("!!",), ("*",)), (("tea",), ("^", "…"))])
def test_d027_a_keyword_without_letters(words):
    assert tea(keywords={"en": words, "fr": (("!",), ())}) == [("D027", "Tea")]


def test_all_findings_come_at_once():
    codes = {code for code, _ in tea(is_a="Nowhere", pattern=("x",), stop="x", see=("Tea",))}
    assert codes == {"D002", "D006", "D012", "D013"}


def test_what_has_no_error_can_be_built():
    assert len(build_tree(KNOWLEDGE).nodes) == len(KNOWLEDGE.topics)


def test_a_finding_is_a_line_for_experts():
    finding = Finding("D006", "Tea", "It links to itself.", "Remove the link.")
    assert str(finding) == "D006 Tea: It links to itself. Hint: Remove the link."
    assert finding.with_place({}) == str(finding)
    assert finding.with_place({"Tea": ("food.yaml", 7)}) == f"food.yaml:7: {finding}"
