"""The machine of one trigger: what it keeps is bounded, what it reads is not changed by that."""

from collections.abc import Iterator
from random import Random

from plans.engine.alignment import Alignment, Errors, align
from plans.engine.automaton import EMPTY, OTHER, Automaton, Draft, bits, either


def machine_of_many_sets() -> Automaton:
    """Return `{x} a (any) (any) …`: after each word another set of positions is possible."""
    draft = Draft()
    whole = draft.join(draft.add_free("x"), draft.chain(("a",)))
    for _ in range(14):
        whole = draft.join(whole, either([draft.chain(("a",)), draft.chain(("b",))]))
    return Automaton(draft, whole)


def test_a_full_machine_reads_as_an_empty_one() -> None:
    chance = Random(1)
    used = machine_of_many_sets()
    for _ in range(400):
        words = tuple(chance.choice("ab") for _ in range(40))
        others = (OTHER,) * 40
        assert used.read(words, others) == machine_of_many_sets().read(words, others)
    assert used.full


def test_an_empty_draft_reads_only_what_was_joined() -> None:
    draft = Draft()
    whole = draft.join(EMPTY, draft.chain(("play", "it")))
    machine = Automaton(draft, whole)
    assert machine.read(("play", "it"), (OTHER, OTHER)) == [0, 1]
    assert machine.read(("play",), (OTHER,)) is None


def few_words() -> Automaton:
    """Return `play [the] song {x} now`."""
    draft = Draft()
    the = either([draft.chain(("the",)), EMPTY])
    whole = draft.join(draft.chain(("play",)), the)
    whole = draft.join(whole, draft.chain(("song",)))
    whole = draft.join(whole, draft.add_free("x"))
    return Automaton(draft, draft.join(whole, draft.chain(("now",))))


def aligned(sentence: str, errors: Errors) -> Alignment | None:
    words = tuple(sentence.split())
    return align(few_words(), words, (OTHER,) * len(words), errors)


def test_a_sentence_that_fits_is_aligned_without_errors() -> None:
    found = aligned("play the song a b now", Errors(most=2, extra=True, wrong=True, missing=True))
    assert found is not None
    assert (found.extra, found.wrong, found.missing) == ((), (), ())
    assert list(found.path) == few_words().read(
        ("play", "the", "song", "a", "b", "now"), (OTHER,) * 6
    )


def test_each_kind_of_error_is_found_in_its_place() -> None:
    extra = aligned("well play the song a now", Errors(most=1, extra=True))
    wrong = aligned("play the tune a now", Errors(most=1, wrong=True))
    missing = aligned("play the song a", Errors(most=1, missing=True))
    empty = aligned("play song now", Errors(most=1, empty=True))
    assert extra is not None
    assert extra.extra == (0,)
    assert wrong is not None
    assert wrong.wrong == (2,)
    assert missing is not None
    assert [few_words().words[position] for position in missing.missing] == ["now"]
    assert empty is not None
    assert [few_words().slots[position] for position in empty.missing] == ["x"]


def test_more_errors_than_allowed_are_refused() -> None:
    assert aligned("well well play the song a now", Errors(most=1, extra=True)) is None
    assert aligned("play the tune a now", Errors(most=2, extra=True)) is None
    assert aligned("play the song a", Errors(most=0)) is None


def test_any_sentence_is_aligned_or_refused_consistently() -> None:
    chance = Random(2)
    every = Errors(most=3, extra=True, wrong=True, missing=True, empty=True)
    words = ["play", "the", "song", "now", "x", "y"]
    for _ in range(2_000):
        sentence = " ".join(chance.choice(words) for _ in range(chance.randint(0, 7)))
        found = aligned(sentence, every)
        if found is not None:
            assert len(found.path) == len(sentence.split())
            assert len(found.extra) + len(found.wrong) + len(found.missing) <= 3


def with_missing(machine: Automaton, reached: dict[int, int], errors: Errors) -> dict[int, int]:
    """Return the positions reached, and those behind literal words that are left out."""
    literal, waiting = set(bits(machine.literal)), list(reached)
    for position in waiting if errors.missing else ():
        for after in bits(machine.ahead[1 << position]):
            used = reached[position] + 1
            if after in literal and used < reached.get(after, used + 1):
                reached[after] = used
                waiting.append(after)
    return reached


def ways_on(
    machine: Automaton, read: set[int], position: int, errors: Errors
) -> Iterator[tuple[int, int]]:
    """Yield where a word leads from a position, and how many errors that is."""
    after, literal = set(bits(machine.ahead[1 << position])), set(bits(machine.literal))
    yield from ((each, 0) for each in after & read)
    if errors.wrong:
        yield from ((each, 1) for each in after & literal)
    if errors.extra and not machine.free >> position & 1:
        yield position, 1


def fewest_errors(machine: Automaton, words: tuple[str, ...], errors: Errors) -> int | None:
    """Return what `align` must find, looked for position by position."""
    reached = with_missing(machine, {machine.start.bit_length() - 1: 0}, errors)
    for word in words:
        read = set(bits(machine.reads[machine.kinds.get(word, OTHER)]))
        found: dict[int, int] = {}
        for position, used in reached.items():
            for after, more in ways_on(machine, read, position, errors):
                found[after] = min(found.get(after, used + more), used + more)
        reached = with_missing(machine, found, errors)
    ends = [used for position, used in reached.items() if machine.accept >> position & 1]
    return min((used for used in ends if used <= errors.most), default=None)


def test_the_reading_found_has_the_fewest_errors() -> None:
    chance = Random(5)
    kinds = [
        Errors(most=most, extra=extra, wrong=wrong, missing=missing)
        for most in (1, 3)
        for extra in (False, True)
        for wrong in (False, True)
        for missing in (False, True)
    ]
    machine, found = few_words(), 0
    for _ in range(3_000):
        some = ("play", "the", "song", "now", "a", "b")
        words = tuple(chance.choices(some, weights=(3, 2, 3, 3, 1, 1), k=chance.randint(1, 7)))
        errors = chance.choice(kinds)
        reading = align(machine, words, (OTHER,) * len(words), errors)
        wanted = fewest_errors(machine, words, errors)
        if reading is None:
            assert wanted is None, (words, errors)
        else:
            found += 1
            used = len(reading.extra) + len(reading.wrong) + len(reading.missing)
            assert used == wanted, (words, errors)
    assert 300 < found < 2_700


def test_what_a_machine_remembers_is_bounded() -> None:
    machine = machine_of_many_sets()
    masks = [mask << 1 | 1 for mask in range(3_000)]
    fresh = machine_of_many_sets()
    assert [machine.ahead[mask] for mask in masks] == [
        fresh.ahead[mask] for mask in reversed(masks)
    ][::-1]
    assert len(machine.ahead) <= 1_000
