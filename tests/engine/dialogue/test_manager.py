"""The Dialogue Manager, line by line of Algorithm 1 in the paper."""

from dialogue.engine.content import build_content
from dialogue.engine.manager import start
from tests.engine.dialogue.talk import act, hear, kinds_said, mrs_smith, node, rules
from tests.engine.dialogue.world import (
    KNOWLEDGE,
    LIBRARY,
    NUMBERS,
    WORLD,
    changed,
    without_topics,
)

TEA, MILK = NUMBERS["Tea"], NUMBERS["Milk"]


def asked_about_tea(**fields):
    return mrs_smith("Tea", **{"last_type": "q", "ordering": "rwc", **fields})


def test_a_talk_starts_with_a_greeting_and_a_state():
    reply = start(WORLD, "en", "EN", seed=7)
    assert reply.sentence in ("Hello, $name!", "Good to see you.")
    assert (reply.state.language, reply.state.culture, reply.state.seed) == ("en", "EN", 7)
    assert (reply.sentence_type, reply.topic, reply.state.turn) == ("e", "", 0)


# Lines 2-20: the KBplan.


def test_lines_3_to_20_actions_are_carried_out_in_order():
    actions = act("setlikeliness", topic="tea", value="1.0"), act("jump", topic="tea")
    reply = hear(mrs_smith("Milk"), "I love tea", *actions)
    assert reply.state.likeliness(TEA) == 1.0
    assert reply.topic == "Tea"


def test_line_4_likeliness_alone_does_not_end_the_turn():
    before = mrs_smith("Milk", ordering="c")
    reply = hear(before, "I adore tea so much", act("setlikeliness", topic="tea", value="1.0"))
    assert reply.state.likeliness(TEA) == 1.0
    assert reply.sentence


def test_lines_11_to_14_a_jump_to_a_known_topic_ends_the_turn():
    before = mrs_smith("Milk")
    actions = act("jump", topic="tea", startsentence="p"), act("jump", topic="piano")
    reply = hear(before, "I love tea", *actions)
    assert reply.topic == "Tea"
    assert kinds_said(before, reply)[0] == "p"


def test_line_11_a_jump_to_nothing_goes_on_as_if_there_were_no_plan():
    before = mrs_smith("Tea", ordering="c")
    reply = hear(before, "Well", act("jump", topic=None))
    assert kinds_said(before, reply) == ["c"]


def test_line_16_an_unknown_action_is_passed_over():
    before = mrs_smith("Tea", ordering="c")
    reply = hear(before, "Well", act("dance"), act("more"))
    assert rules(reply)[0] == "kbplan"
    assert kinds_said(before, reply) == ["c"]


# Lines 21-27: keywords.


def test_lines_21_to_27_a_mentioned_topic_begins_with_its_first_type():
    before = mrs_smith("Piano", ordering="wc", last_type="c", siblings=2, noes=1, misses=1)
    reply = hear(before, "The cat wants milk")
    assert reply.topic == "Milk"
    assert kinds_said(before, reply) == ["opener", "q"]
    assert (reply.state.siblings, reply.state.noes, reply.state.misses) == (0, 0, 0)


def test_after_an_open_question_a_mentioned_topic_is_acknowledged():
    before = mrs_smith("Piano", ordering="c", last_type="w")
    reply = hear(before, "The cat wants milk")
    assert kinds_said(before, reply) == ["acknowledge", "opener", "q"]


def test_the_first_words_of_the_person_need_no_acknowledgement():
    begun = start(WORLD, "en", "EN", seed=7)
    assert kinds_said(begun.state, hear(begun.state, "Milk")) == ["opener", "q"]


def test_an_answer_and_a_mentioned_topic_are_both_reacted_to():
    before = asked_about_tea()
    reply = hear(before, "Yes I do, with milk")
    assert kinds_said(before, reply) == ["p", "opener", "q"]
    assert reply.state.likeliness(TEA) == 0.9
    assert reply.topic == "Milk"


def test_an_answer_that_depends_is_followed_by_the_mentioned_topic():
    before = asked_about_tea()
    reply = hear(before, "It depends on the milk")
    assert kinds_said(before, reply) == ["neutral", "opener", "q"]


def test_a_topic_above_or_the_same_is_no_change():
    before = mrs_smith("GreenTea", ordering="c")
    reply = hear(before, "tea")
    assert reply.topic == "GreenTea"
    assert "stay" in rules(reply)


def test_a_gentle_topic_is_begun_without_any_opener():
    before = mrs_smith("Tea", ordering="wc")
    reply = hear(before, "I was at two funerals")
    assert kinds_said(before, reply) == ["c"]
    assert (reply.topic, reply.state.ordering) == ("Funerals", "wc")


def test_keywords_are_ignored_while_the_person_is_listened_to():
    before = mrs_smith("OnYourMind", ordering="wc", last_type="c")
    reply = hear(before, "She liked milk a lot")
    assert (reply.topic, reply.sentence_type) == ("OnYourMind", "w")


def test_after_a_hard_subject_only_the_person_leads_away_from_it():
    """The agent asks whether to stay, stays, and asks again; it proposes nothing."""
    reply, types = hear(mrs_smith("Grief", ordering="c"), "Well"), []
    for _ in range(6):
        before = reply.state
        reply = hear(before, "Hm")
        types.append(kinds_said(before, reply)[-1])
        assert reply.topic == "Grief"
    assert types == ["stay_or_go", "c", "w", "stay_or_go", "c", "w"]


def test_who_is_asked_to_stay_or_go_has_the_initiative():
    asked = hear(mrs_smith("Grief", last_type="w"), "Well")
    assert kinds_said(mrs_smith("Grief"), asked) == ["gentle", "stay_or_go"]
    assert asked.sentence_type == "e"
    assert kinds_said(asked.state, hear(asked.state, "Milk")) == ["gentle", "opener", "q"]
    assert hear(asked.state, "Milk").topic == "Milk"
    assert hear(asked.state, "The funerals").topic == "Funerals"
    changed_to = hear(asked.state, "Something else", act("change"))
    assert not node(changed_to.topic).gentle
    assert kinds_said(asked.state, changed_to)[0] == "change_asked"


# Questions of the person.


def test_a_question_with_a_keyword_is_not_answered_but_the_topic_is_taken_up():
    before = mrs_smith("Piano", ordering="c", last_type="w", siblings=2, noes=1, misses=1)
    reply = hear(before, "Is milk good for cats?")
    assert kinds_said(before, reply) == ["not_understood", "opener", "q"]
    assert reply.topic == "Milk"
    assert (reply.state.siblings, reply.state.noes, reply.state.misses) == (0, 0, 2)


def test_an_answer_that_asks_back_is_an_answer():
    before = asked_about_tea(misses=1)
    reply = hear(before, "Yes, with milk, and you?")
    assert kinds_said(before, reply) == ["p", "opener", "q"]
    assert reply.state.misses == 0


def test_no_answer_at_all_that_asks_is_not_understood():
    before = asked_about_tea()
    reply = hear(before, "Where is the milk?")
    assert kinds_said(before, reply) == ["not_understood", "opener", "q"]
    assert (reply.topic, reply.state.misses) == ("Milk", 1)


def test_who_asks_about_people_is_listened_to():
    before = mrs_smith("Tea", ordering="wc", siblings=2, noes=1, misses=1)
    reply = hear(before, "Where is my husband?")
    assert kinds_said(before, reply) == ["not_understood", "w"]
    assert (reply.topic, reply.state.ordering) == ("OnYourMind", "c")
    assert (reply.state.siblings, reply.state.noes, reply.state.misses) == (0, 0, 2)


def test_who_asks_about_people_again_goes_on_being_listened_to():
    asked = hear(mrs_smith("Tea"), "Where is my husband?")
    reply = hear(asked.state, "Where is my husband?")
    assert kinds_said(asked.state, reply) == ["not_understood", "c"]
    assert reply.topic == "OnYourMind"


def test_who_tells_of_people_hears_of_the_topic():
    before = mrs_smith("Tea", ordering="wc")
    reply = hear(before, "My husband is at home")
    assert kinds_said(before, reply) == ["opener", "q"]
    assert reply.topic == "Husband"


def test_a_hard_subject_wins_while_listening_and_all_others_after_it():
    listening = mrs_smith("OnYourMind", ordering="wc")
    assert hear(listening, "the funerals").topic == "Funerals"
    heard_out = mrs_smith("OnYourMind")
    for slot in range(5):
        heard_out = heard_out.with_used(NUMBERS["OnYourMind"], slot)
    assert hear(heard_out, "She liked milk a lot").topic == "Milk"


def test_a_word_in_passing_does_not_end_a_hard_subject_before_it_is_told():
    reply = hear(mrs_smith("Grief").with_used(NUMBERS["Grief"], 0), "She liked milk a lot")
    assert (reply.topic, reply.sentence_type, reply.state.ordering) == ("Grief", "w", "c")


def test_a_hard_subject_begins_with_what_is_written_first():
    for seed in range(20):
        reply = hear(mrs_smith("Tea", seed=seed), "Grief")
        assert WORLD.tree.lines[reply.state.frames[-1]].key == "Grief.c1"


def test_a_plan_that_was_asked_for_is_no_topic():
    before = asked_about_tea()
    reply = hear(before, "Play the piano for me", plan_matched=True)
    assert reply.topic == "Tea"
    assert kinds_said(before, reply) == ["w"]
    assert reply.state.ordering == "c"


# Lines 28-39: the ordering, the next topic.


def test_lines_34_to_37_the_topic_goes_on_with_its_next_type():
    before = mrs_smith("Tea", ordering="wc")
    reply = hear(before, "Well")
    assert (reply.topic, reply.sentence_type, reply.state.ordering) == ("Tea", "w", "c")


def test_lines_29_to_33_a_completed_topic_is_followed_by_the_next():
    before = mrs_smith("Tea")
    reply = hear(before, "Well")
    assert (reply.topic, reply.sentence_type) == ("GreenTea", "q")


# The answer to a yes/no question.


def test_r_is_p_after_a_yes():
    before = asked_about_tea(noes=1)
    reply = hear(before, "Yes")
    assert kinds_said(before, reply) == ["p", "w"]
    assert (reply.state.ordering, reply.state.noes) == ("c", 0)
    assert reply.state.likeliness(TEA) == 0.9


def test_r_is_n_after_a_first_no_and_a_sibling_follows():
    before = asked_about_tea()
    reply = hear(before, "No")
    assert kinds_said(before, reply)[0] == "n"
    assert reply.topic in ("Milk", "Coffee", "TeaCeremony")
    assert reply.state.likeliness(TEA) == 0.1
    assert reply.state.noes == 1


def test_after_a_no_a_topic_without_a_fitting_remark_is_left_too():
    some = tuple(one for one in KNOWLEDGE.topics[12].frames if one.type != "n")
    content = build_content(changed("Life", frames=some), LIBRARY)
    before = mrs_smith("Gardening", last_type="q", ordering="rwc")
    reply = hear(before, "No", content=content)
    assert reply.topic not in ("Gardening", "")


def test_a_second_no_leads_to_another_branch():
    before = asked_about_tea(noes=1)
    reply = hear(before, "No, I hate it")
    assert kinds_said(before, reply)[0] == "n"
    assert node(reply.topic).branch != NUMBERS["FoodAndDrink"]
    assert (reply.state.noes, reply.state.likeliness(TEA)) == (0, 0.0)


def test_r_is_dropped_after_a_neutral_answer_which_is_acknowledged():
    before = asked_about_tea()
    reply = hear(before, "It depends")
    assert kinds_said(before, reply) == ["neutral", "w"]
    assert reply.state.ordering == "c"


def test_r_is_dropped_after_no_answer_at_all():
    before = asked_about_tea()
    reply = hear(before, "hm")
    assert kinds_said(before, reply) == ["w"]
    assert reply.state.likeliness(TEA) is None


def test_an_answer_about_a_topic_that_is_gone_changes_nothing():
    content = without_topics("Tea", "GreenTea")
    reply = hear(asked_about_tea(), "Yes", content=content)
    assert reply.state.levels == b""
    assert reply.topic not in ("", "Tea")
