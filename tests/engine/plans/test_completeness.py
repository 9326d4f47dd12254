"""What an intent lacks is told, and what nobody uses."""

import msgspec

from plans.engine.completeness import completeness
from plans.engine.intents import Intent, Library, Phrase, PlanSentence, Slot
from plans.engine.plan_text import parse_plan
from plans.engine.remarks import Remark
from tests.engine.plans.lint_worlds import PLAY, intent, stored, world


def lacking(library: Library, code: str) -> list[Remark]:
    return [one for one in completeness(library, languages=("en",)) if one.code == code]


def said(tested: Intent, code: str) -> list[str]:
    return [one.text for one in lacking(world(tested), code)]


def whole() -> Intent:
    triggers = tuple(f"play number {word}" for word in "abcdefgh")
    lines = [*(f"{trigger}" for trigger in triggers), "play a", *(f"{n} -> no" for n in "abc")]
    says = {"en": tuple(PlanSentence(text=text) for text in ("Well.", "Fine.", "Good."))}
    return intent("whole", *triggers, plan_sentences=says, tests=stored(*lines))


def test_a_whole_intent_lacks_nothing() -> None:
    assert [
        one for one in completeness(world(whole()), intents=("whole",)) if one.language == "en"
    ] == []


def test_too_few_of_anything_is_told() -> None:
    assert said(PLAY, "C012") == [
        "2 triggers; there should be 8 to 15.",
        "1 plan sentences; there should be 3 to 5.",
        "3 tests; there should be at least 12.",
    ]


def test_too_many_triggers_are_told_but_not_of_what_is_urgent() -> None:
    many = {"en": tuple(f"play {number}x" for number in range(16))}
    assert said(msgspec.structs.replace(whole(), triggers=many), "C012") == [
        "16 triggers; there should be 8 to 15."
    ]
    assert said(msgspec.structs.replace(whole(), triggers=many, priority=100), "C012") == []


def test_a_quarter_of_the_tests_must_not_match() -> None:
    more = msgspec.structs.replace(
        whole(), tests={"en": (*whole().tests["en"], *stored("play number a")["en"])}
    )
    assert said(more, "C012") == ["3 tests that must not match; there should be at least 4."]


def test_an_intent_without_tests_is_an_error() -> None:
    (remark,) = lacking(world(intent("a", "stop")), "C011")
    assert (remark.text, remark.error) == ("There are no tests.", True)


def test_a_language_that_is_not_written_is_an_error() -> None:
    remarks = [one for one in completeness(world(PLAY)) if one.code == "C011"]
    assert [(one.language, one.error) for one in remarks] == [("it", True), ("ja", True)]
    assert remarks[0].text == "There are triggers in en only."


def test_an_ability_named_in_one_language_only_is_told() -> None:
    both = {"en": ("stop",), "it": ("basta",)}
    tested = msgspec.structs.replace(PLAY, triggers=both, abilities={"en": "play a song"})
    texts = [one.text for one in completeness(world(tested)) if one.language == "it"]
    assert "What the agent can do is not named." in texts


def test_a_required_slot_needs_its_question() -> None:
    title = Slot(name="title", required=True)
    asked = msgspec.structs.replace(title, questions={"en": "Which song?"})
    assert said(intent("a", "play {title}", slots=(asked,)), "C010") == []
    assert said(intent("a", "play {title}", slots=(title,)), "C010") == [
        "The slot title is required, but no question asks for it."
    ]


def test_something_can_always_be_said() -> None:
    needy = (PlanSentence(text="Here is {title}."), PlanSentence(text="Namaste.", only=("IN",)))
    tested = intent("a", "play {title}", plan_sentences={"en": needy})
    assert len(said(tested, "C013")) == 1
    can = {"en": (*needy, PlanSentence(text="Well."))}
    assert said(msgspec.structs.replace(tested, plan_sentences=can), "C013") == []


def test_a_value_that_clients_do_not_understand_is_an_error() -> None:
    tested = intent("a", "talk {level}", plan=parse_plan("#action=volume level={level}"))
    assert said(tested, "C009") == []
    library = world(tested, levels={"louder": ("up",), "deafening": ("deafening",)})
    (remark,) = lacking(library, "C009")
    assert remark.text.startswith("volume takes no level=deafening; it takes high, normal,")


def test_any_value_will_do_where_clients_take_any_word() -> None:
    tested = intent("a", "say it {level}", plan=parse_plan("#action=translate language={level}"))
    assert said(tested, "C009") == []


def test_a_phrase_nobody_uses_is_told() -> None:
    keys = ("used", "unused", "skip_start", "cannot_do", "cannot_alert", "cannot_fly")
    phrases = tuple(Phrase(key=key, texts={"en": "now"}) for key in keys)
    library = Library(intents=(intent("a", "stop <used>", slots=()),), phrases=phrases)
    unused = [one.where for one in lacking(library, "C006")]
    assert unused == ["<unused>", "<cannot_fly>"]


def test_a_value_list_nobody_uses_is_told() -> None:
    unused = lacking(world(intent("a", "stop", slots=())), "C007")
    assert [one.where for one in unused] == ["level"]
    assert lacking(world(PLAY), "C007") == []


def test_one_word_for_two_values_is_an_error() -> None:
    library = world(PLAY, levels={"louder": ("up", "more"), "higher": ("UP!",)})
    (remark,) = lacking(library, "C008")
    assert (remark.where, remark.language, remark.error) == ("level", "en", True)
    assert remark.text == "'up' means higher and louder."


def test_an_action_nobody_can_ask_for_is_told() -> None:
    where = [one.where for one in lacking(world(PLAY), "C014")]
    assert "hug" in where
    assert "playsong" not in where


def test_only_the_intents_that_are_wanted_are_checked() -> None:
    remarks = completeness(world(PLAY, intent("a", "stop")), intents=("a",))
    assert {one.where for one in remarks} == {"a"}
