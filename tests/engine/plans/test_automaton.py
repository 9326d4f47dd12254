"""The machine of one trigger: what it keeps is bounded, what it reads is not changed by that."""

from random import Random

from plans.engine.automaton import EMPTY, OTHER, Automaton, Draft, either


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
