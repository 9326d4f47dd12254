"""Templates of hassil say the same as triggers of ours."""

import pytest

from languages.known import LANGUAGES
from plans.engine.catalogue import compile_catalogue
from plans.engine.hassil.convert import Conversion, convert
from plans.engine.hassil.data import Block, HassilFile, HassilList, ListValue, Template
from plans.engine.hassil.names import key_of
from plans.engine.patterns import DEEPEST, LONGEST, Choice, Sequence, expansions, parse_pattern

RULES = {
    "the": "(the|my)",
    "turn": "(turn|switch)",
    "in": "(in|ne[l |lla ])",
    "set_to": "set <the> {level:value}",
    "loop": "<loop>",
}
LISTS = {
    "name": HassilList(values=(ListValue(Template("lamp[s]"), "lamp"),)),
    "level": HassilList(number=True),
    "level_word": HassilList(values=(ListValue(Template("(max|top)"), "100"),)),
    "message": HassilList(wildcard=True),
}


def converted(*templates: str, code: str = "en", most: int = 10_000) -> Conversion:
    file = HassilFile(
        intents={"HassTest": (Block(tuple(map(Template, templates))),)},
        rules={name: Template(text) for name, text in RULES.items()},
        lists=LISTS,
        skip_words=(Template("please"),),
    )
    return convert(file, LANGUAGES[code], most)


def triggers(*templates: str, code: str = "en") -> tuple[str, ...]:
    conversion = converted(*templates, code=code)
    assert conversion.problems == ()
    compile_catalogue(conversion.library)
    return conversion.library.intents[0].triggers[code]


@pytest.mark.parametrize(
    ("template", "trigger"),
    [
        ("turn on [all] lights", "turn on [all] lights"),
        ("light[s] on", "(light|lights) on"),
        ("on(ly|e)", "(only|one)"),
        ("cancel[ the| my] timer", "cancel [the|my] timer"),
        ("[the ]lamp", "[the] lamp"),
        ("day[ ]light", "(daylight|day light)"),
        ("<turn> on [<the>] lamp", "<turn> on [<the>] lamp"),
        ("(now;<turn> on) lamp", "(now <turn> on|<turn> on now) lamp"),
        ("((a|b)|c) [(d)] x", "(a|b|c) [d] x"),
        ("set {level}[ ]% [°]", "set {level}"),
        ("lamp {level}( |-)hour[s]", "lamp {level} (hour|hours)"),
        ("{message}[s] off", "{message} [s] off"),
        (r"a\[b[s] off\\", "a (b|bs) off"),
        ("off\\", "off"),
        ("on|off", "(on|off)"),
    ],
)
def test_a_template_becomes_a_trigger(template: str, trigger: str) -> None:
    assert triggers(template) == (trigger,)


def test_only_what_touches_a_word_is_written_out() -> None:
    (trigger,) = triggers("<in>[l'] cucina", code="it")
    words = trigger.removeprefix("(").removesuffix(") cucina").split("|")
    assert words == ["in", "inl'", "ne", "nel'", "nel", "nel l'", "nella", "nella l'"]
    catalogue = compile_catalogue(converted("<in>[l'] cucina", code="it").library)
    assert catalogue.match("nella cucina", "it")
    assert not catalogue.match("sulla cucina", "it")


def test_japanese_needs_nothing_written_out() -> None:
    file = HassilFile(
        intents={"A": (Block((Template("{name}[を]消し(て|なさい)"),)),)},
        lists={"name": HassilList(values=(ListValue(Template("照明"), "照明"),))},
    )
    library = convert(file, LANGUAGES["ja"]).library
    assert library.intents[0].triggers["ja"] == ("{name} [を] 消し (て|なさい)",)
    match = compile_catalogue(library).match("照明を消しなさい", "ja")
    assert match
    assert match.parameters == {"name": "照明"}


def test_slots_have_the_kind_of_their_list() -> None:
    conversion = converted("<set_to>", "set {level_word:value}", "say {message}", "get {name}")
    kinds = {slot.name: slot.kind for slot in conversion.library.intents[0].slots}
    assert kinds == {
        "value": "number",
        "level_word": "value:level_word",
        "message": "text",
        "name": "value:name",
    }
    assert conversion.meant["hass_test", "level_word"] == "value"
    match = compile_catalogue(conversion.library).match("please set top", "en")
    assert match
    assert match.parameters == {"level_word": "100"}


def test_a_wording_of_slots_alone_is_not_kept() -> None:
    assert triggers("[turn on] {name} [now]") == ("turn on {name} [now]", "[turn on] {name} now")


def test_brackets_too_deep_are_multiplied_out() -> None:
    (trigger,) = triggers("(a (b [c (d [e (f|g)]|h)]|i)|j) lamp")
    sequence = parse_pattern(trigger)
    assert _depth(sequence) <= DEEPEST
    catalogue = compile_catalogue(converted("(a (b [c (d [e (f|g)]|h)]|i)|j) lamp").library)
    for words in ("a b c d e g lamp", "a b c h lamp", "a b lamp", "a i lamp", "j lamp"):
        assert catalogue.match(words, "en"), words
    assert not catalogue.match("a b c lamp", "en")


def _depth(sequence: Sequence) -> int:
    inner = (
        1 + max(map(_depth, part.options)) for part in sequence.parts if isinstance(part, Choice)
    )
    return max(inner, default=0)


def test_a_template_of_many_wordings_is_cut_into_triggers() -> None:
    choices = " ".join(f"[a{place}|b{place}|c{place}]" for place in range(8))
    found = triggers(f"go {choices}")
    assert len(found) > 1
    sequences = [parse_pattern(trigger) for trigger in found]
    assert all(len(trigger) <= LONGEST for trigger in found)
    assert all(expansions(sequence, {}) <= 10_000 for sequence in sequences)
    assert sum(expansions(sequence, {}) for sequence in sequences) == 4**8


@pytest.mark.parametrize(
    ("template", "position", "message"),
    [
        ("turn (on", 5, "Open '(' without ')'"),
        ("turn [on)", 8, "')' closes '['"),
        ("turn on]", 7, "Closing ']' without an opening one"),
        ("turn {name", 5, "An opening bracket without '}'"),
        ("turn <off> x", 5, "There is no rule 'off'"),
        ("turn <loop>", 5, "In the rule 'loop'"),
        ("(a|b;c)", 4, "'|' and ';' in one pair of brackets"),
        ("{}", 0, "'' is no name of a list"),
        ("(a" * 14 + ")" * 14, 24, "Brackets deeper than 12"),
        ("say {message} {message:other}", 0, "Two free slots without a word between them"),
        ("{message}", 0, "A wording without any word of its own"),
    ],
)
def test_what_cannot_be_said_is_told_with_its_place(
    template: str, position: int, message: str
) -> None:
    conversion = converted(template, "turn on")
    (problem,) = conversion.problems
    assert problem.position == position
    assert problem.message.startswith(message)
    assert conversion.library.intents[0].triggers["en"] == ("turn on",)


def test_words_that_would_have_too_many_forms_are_refused() -> None:
    conversion = converted("(a|b|c|d|e|f|g|h)" * 5)
    assert "forms" in conversion.problems[0].message


def test_names_are_written_as_the_library_writes_them() -> None:
    assert [key_of(name) for name in ("HassTurnOn", "start-time", "2nd")] == [
        "hass_turn_on",
        "start_time",
        "x_2nd",
    ]
