"""Whole talks: what must hold in every one of them, whoever speaks."""

from collections.abc import Iterator
from random import Random

import pytest

from dialogue.engine.codec import decode, encode
from dialogue.engine.flow import MOST_QUESTIONS
from dialogue.engine.manager import Reply, reply, start
from dialogue.engine.saying import sayable
from dialogue.engine.sentence_types import SENTENCE_TYPES
from dialogue.engine.state import DialogueState
from dialogue.engine.turn import Heard
from plans.engine.manager import Action
from tests.engine.dialogue.talk import act, hear, mrs_smith, turn_in
from tests.engine.dialogue.world import NUMBERS, WORLD, without_topics

KEY = [b"a key of many bytes"]
SENTENCES = {
    "en": "Yes|No|Not really|It depends|A little|I love it|Hm|My sister lives in Bath"
    "|I had milk and green tea|The piano|Why?|My husband is out"
    "|Where is my husband?|Is tea healthy?|There were two funerals|Coffee|I hate it",
    "it": "Sì|No|Dipende|Mah|Adoro questa cosa|Ho bevuto del latte|Il pianoforte|Perché?|Un lutto",
    "ja": "はい|いいえ|うーん|牛乳を飲みました|ピアノ|なぜですか？|大好きです|お葬式がありました",
}
ACTIONS = (
    act("setlikeliness", topic="tea", value="0.9"),
    act("jump", topic="tea", startsentence="p"),
    act("jump", topic="my wife Margaret", startsentence="q"),
    act("jump", topic="submarines", startsentence="n"),
    act("jump", topic="my neighbour", startsentence="n"),
    act("jump", topic="submarines", startsentence="p"),
    act("leave"),
    act("leave", topic="music"),
    act("change"),
    act("more"),
    act("opinion", topic="milk"),
    act("list"),
    act("forget"),
    act("stop"),
)


def heard(chance: Random, language: str) -> Heard:
    """Return what a person says, now and then with the actions of a plan."""
    actions: tuple[Action, ...] = ()
    if chance.random() < 0.2:
        actions = (ACTIONS[chance.randrange(len(ACTIONS))],)
    sentences = SENTENCES[language].split("|")
    return Heard(
        sentences[chance.randrange(len(sentences))],
        actions,
        plan_matched=chance.random() < 0.05,
        plan_said=chance.random() < 0.05,
        urgent=chance.random() < 0.01,
    )


def talk(seed: int, turns: int, language: str = "en", culture: str = "EN") -> Iterator[Reply]:
    """Return the replies of a talk with somebody who says anything."""
    chance = Random(seed)
    answer = start(WORLD, language, culture, seed)
    for _ in range(turns):
        yield answer
        answer = reply(WORLD, answer.state, heard(chance, language))


def remark_exists(state: DialogueState) -> bool:
    turn = turn_in(state)
    return bool(turn.node and sayable(turn, turn.node, "c"))


TALKS = [(seed, *who) for seed in (1, 2) for who in (("en", "EN"), ("it", "IT"), ("ja", "JP"))]


@pytest.mark.parametrize(("seed", "language", "culture"), TALKS)
def test_no_sentence_comes_twice_in_a_row(seed, language, culture):
    before = ""
    for answer in talk(seed, 300, language, culture):
        assert not answer.sentence or answer.sentence != before
        before = answer.sentence


@pytest.mark.parametrize(("seed", "language", "culture"), TALKS)
def test_the_state_can_always_be_encoded(seed, language, culture):
    for answer in talk(seed, 300, language, culture):
        assert decode(encode(answer.state, KEY), KEY) == answer.state


@pytest.mark.parametrize(("seed", "language", "culture"), TALKS)
def test_no_third_question_in_a_row_is_about_a_topic_that_has_a_remark(seed, language, culture):
    """Save where the person asks for a topic: then the count begins anew."""
    for answer in talk(seed, 300, language, culture):
        few = answer.state.questions <= MOST_QUESTIONS
        assert few or answer.sentence_type == "e" or not remark_exists(answer.state)


def test_questions_in_a_row_are_counted_rightly():
    in_a_row, answer = 1, start(WORLD, "en", "EN", 6)
    for _ in range(100):
        answer = hear(answer.state, "Hm")
        asks = SENTENCE_TYPES[answer.sentence_type].asks
        in_a_row = in_a_row + 1 if asks else 0
        assert answer.state.questions == in_a_row
        assert in_a_row <= MOST_QUESTIONS


@pytest.mark.parametrize("seed", range(1, 4))
def test_the_agent_never_begins_to_speak_of_hard_things(seed):
    """Here the person never mentions any."""
    chance, answer = Random(seed), start(WORLD, "en", "EN", seed)
    for _ in range(300):
        sentence = ["Yes", "No", "Hm", "It depends", "Ah, good"][chance.randrange(5)]
        answer = hear(answer.state, sentence)
        assert answer.topic not in ("Grief", "Funerals", "OnYourMind")


@pytest.mark.parametrize(
    ("language", "sentences"),
    [
        ("en", ("Hm", "It was long ago", "Yes", "No")),
        ("it", ("Mah", "Sì", "No")),
        ("ja", ("うーん", "はい", "いいえ")),
    ],
)
@pytest.mark.parametrize("topic", ["Grief", "Funerals", "OnYourMind"])
def test_a_hard_subject_lasts_until_the_person_names_another(topic, language, sentences):
    answer = hear(mrs_smith(topic, language=language), sentences[0])
    for turn in range(30):
        answer = hear(answer.state, sentences[turn % len(sentences)])
        assert answer.topic == topic
        assert answer.sentence_type in ("c", "w", "e")


def test_no_proposal_is_made_while_the_person_is_listened_to():
    for answer in talk(3, 300):
        if answer.sentence_type == "g":
            assert not WORLD.tree.by_key[answer.topic].gentle


def test_the_talk_never_dries_up():
    """There are fewer topics than the state remembers; the oldest come again."""
    answers = list(talk(4, 300))
    assert all(answer.sentence or answer.sentence_type for answer in answers)
    ends = [answer.state.frames[-1] for answer in answers]
    initiative = {line.number for line in WORLD.tree.pools["initiative"]}
    assert sum(number in initiative for number in ends) < 30


@pytest.mark.parametrize("language", ["en", "it", "ja"])
def test_the_same_seed_gives_the_same_talk(language):
    one, other = (
        [(answer.sentence, answer.state) for answer in talk(9, 40, language)] for _ in range(2)
    )
    assert one == other


def test_another_seed_gives_another_talk():
    one, other = ([answer.sentence for answer in talk(seed, 40)] for seed in (1, 2))
    assert one != other


def test_a_state_that_has_been_away_goes_on_with_the_same_talk():
    answer = hear(mrs_smith("Tea", ordering="qrwc"), "Well")
    back = decode(encode(answer.state, KEY), KEY)
    assert hear(back, "Yes").sentence == hear(answer.state, "Yes").sentence


def a_state_of_long_ago() -> DialogueState:
    """Return a state that names a topic, frames, a refusal and an offer no content has."""
    state = mrs_smith(
        ordering="qrwc",
        last_type="q",
        frames=(999_998, 999_999),
        avoided=((5_001, 99),),
        offer=999_999,
    )
    state = state.with_likeliness(5_000, 1.0).with_used(5_000, 99)
    return state.with_topic_started(NUMBERS["Gardening"]).with_topic_started(5_000)


def test_numbers_that_are_gone_are_ignored():
    content = without_topics("Gardening", "Singing")
    answer = hear(a_state_of_long_ago(), "Yes", content=content)
    assert answer.sentence
    assert answer.topic in NUMBERS
    assert decode(encode(answer.state, KEY), KEY) == answer.state


def test_the_explanation_tells_the_rules_in_order():
    answer = hear(mrs_smith("Tea", last_type="q", ordering="rwc"), "Yes, with milk")
    assert [step.rule for step in answer.steps] == [
        "keywords",
        "learn",
        "say",
        "pool",
        "begin",
        "say",
    ]
    assert answer.steps[1].text == "YES to Tea: likeliness 0.9"
    assert answer.steps[0].candidates[0].topic == "Milk"
