"""Simulated talks: the same again from a seed; what is measured of them is what happened."""

from io import StringIO
from pathlib import Path

import pytest
from django.core.management import CommandError, call_command

from dialogue.engine.content import Content
from dialogue.engine.manager import Reply
from dialogue.engine.state import DialogueState
from dialogue.simulation.bars import BARS, Bar, Figure, Tally, figures, measured
from dialogue.simulation.sample import sample
from dialogue.simulation.talks import Cast, Exchange, Utterances, talk
from dialogue.simulation.users import USERS, Said
from dialogue.simulation.utterances import read_utterances
from languages.known import LANGUAGES

CAST = Cast("passive", "IT", "it", 3)


def spoken(content: Content, cast: Cast, turns: int = 12) -> list[tuple[str, str]]:
    return [(one.said.text, one.spoken) for one in talk(content, cast, turns)]


def exchange(content: Content, frame: str, topic: str, kind: str = "c", **more: object) -> Exchange:
    """Return a turn that said one frame about a topic."""
    number = next(line.number for line in content.tree.lines.values() if line.key == frame)
    node = content.tree.by_key[topic]
    state = DialogueState("en", "EN", topic=node.number)
    values: dict[str, object] = {
        "said": Said("Hm."),
        "reply": Reply(state, frame, kind, topic),
        "spoken": frame,
        "before": node.number,
        "frames": (number,),
        "led": False,
        "matched": False,
        "pools": frozenset[str](),
    }
    return Exchange(**{**values, **more})  # type: ignore[arg-type]


@pytest.mark.parametrize("user", [*USERS])
@pytest.mark.parametrize("language", [*LANGUAGES])
def test_the_same_seed_gives_the_same_talk(shipped: Content, user: str, language: str) -> None:
    cast = Cast(user, "JP", language, 5)
    assert spoken(shipped, cast) == spoken(shipped, cast)
    assert all(words for _said, words in spoken(shipped, cast))


def test_another_seed_gives_another_talk(shipped: Content) -> None:
    other = Cast(CAST.user, CAST.culture, CAST.language, CAST.seed + 1)
    assert spoken(shipped, CAST) != spoken(shipped, other)


def test_a_sentence_told_twice_about_a_topic_is_counted(shipped: Content) -> None:
    once = exchange(shipped, "Animal.c1", "Dog")
    tally = measured(shipped, [once, exchange(shipped, "Animal.c2", "Dog"), once])
    assert (tally.sums["identical"], tally.cases["identical"]) == (1, 3)
    assert tally.sums["soon"] == tally.sums["late"] == 1


def test_a_frame_comes_again_late_but_not_soon(shipped: Content) -> None:
    others = [exchange(shipped, "acknowledge.1", "Dog") for _ in range(25)]
    again = exchange(shipped, "Animal.c1", "Cat")
    tally = measured(shipped, [exchange(shipped, "Animal.c1", "Dog"), *others, again])
    assert (tally.sums["soon"], tally.sums["late"], tally.sums["identical"]) == (0, 1, 0)


def test_the_ways_of_changing_the_topic_are_told_apart(shipped: Content) -> None:
    nodes = shipped.tree.by_key
    dog = nodes["Dog"]
    link = next(number for number in dog.links if shipped.tree.nodes[number].branch != dog.branch)
    linked = shipped.tree.nodes[link].key
    far = shipped.tree.by_key["Opera"].key
    moves = [
        exchange(shipped, "Animal.c1", "Cat", before=dog.number),
        exchange(shipped, "Animal.c1", linked, before=dog.number),
        exchange(shipped, "Animal.c1", far, before=dog.number, pools=frozenset({"change"})),
        exchange(shipped, "Animal.c1", far, before=dog.number, led=True),
    ]
    tally = measured(shipped, moves)
    assert [tally.sums[way] for way in ("near", "link", "far")] == [1, 1, 1]
    assert tally.value("announced") == 1


def test_questions_in_a_row_are_counted(shipped: Content) -> None:
    kinds = ("q", "w", "g", "c", "q")
    tally = measured(shipped, [exchange(shipped, "Animal.c1", "Dog", kind) for kind in kinds])
    assert tally.value("questions") == 0.8
    assert tally.sums["three"] == 1
    assert tally.value("proposals") == 0.2


def test_what_was_avoided_and_comes_back_by_itself_is_counted(shipped: Content) -> None:
    dog, cat = shipped.tree.by_key["Dog"], shipped.tree.by_key["Cat"]
    away = exchange(shipped, "Animal.c1", "Cat", said=Said("No dogs.", avoided=dog))
    back = exchange(shipped, "Animal.c1", "Dog", before=cat.number)
    assert measured(shipped, [away, back]).value("entered") == 1
    wanted = exchange(shipped, "Animal.c1", "Dog", before=cat.number, led=True)
    assert not measured(shipped, [away, wanted]).sums["entered"]


def test_a_figure_names_the_cell_that_is_farthest_from_its_bar() -> None:
    good, bad = Tally(), Tally()
    good.add("questions", 1, 4)
    bad.add("questions", 3, 4)
    cells = {("yes", "EN", "en"): good, ("no", "IT", "it"): bad, ("talkative", "EN", "en"): bad}
    (one,) = figures(cells)
    assert (one.bar.measure, one.value, one.worst, one.met) == ("questions", 0.5, "no IT it", True)


def test_a_bar_bounds_from_both_sides() -> None:
    bar = Bar("D3", "", "", least=0.03, most=0.08)
    assert [bar.met(value) for value in (0.02, 0.03, 0.08, 0.09)] == [False, True, True, False]
    assert Figure(bar, 0.05, "", 0.05).met
    assert {one.id for one in BARS} == {"D1", "D2", "D3", "D4"}


@pytest.mark.parametrize("language", [*LANGUAGES])
def test_there_are_utterances_to_try(language: str) -> None:
    found = read_utterances(language)
    assert isinstance(found, Utterances)
    assert len(found.topical) >= 60
    assert len(found.chat) >= 30


def test_the_command_prints_the_bars_and_saves_the_talks(
    published: Content, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    module = "dialogue.management.commands.simulate_talks"
    monkeypatch.setattr(f"{module}.load", lambda: published)
    out = StringIO()
    asked = {"turns": 6, "seeds": 1, "cultures": ["EN", "IN"], "users": ["yes"], "save": tmp_path}
    call_command("simulate_talks", stdout=out, languages=["en"], **asked)
    assert "2 talks of 6 turns" in out.getvalue()
    assert "| D3 | turns that end with a question | ≤ 0.6 |" in out.getvalue()
    saved = (tmp_path / "yes-IN-en-1.txt").read_text()
    assert saved.startswith("en IN 1\n\nuser: ")
    assert saved.count("agent: ") == 6


def test_the_command_refuses_what_it_does_not_know(
    published: Content, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("dialogue.management.commands.simulate_talks.load", lambda: published)
    with pytest.raises(CommandError, match="The cultures are EN, IT, JP, IN"):
        call_command("simulate_talks", cultures=["XX"])
    with pytest.raises(CommandError, match="Seeds are numbers from 1"):
        call_command("simulate_talks", seeds=0)


@pytest.mark.parametrize("language", [*LANGUAGES])
def test_a_sample_has_sentences_of_every_class(shipped: Content, language: str) -> None:
    found = list(sample(shipped, language, 300, 3))
    assert found == list(sample(shipped, language, 300, 3))
    assert found != list(sample(shipped, language, 300, 4))
    nodes = shipped.tree.by_key
    assert len({nodes[one.topic].parent for one in found}) >= 70
    assert {one.culture for one in found} == set(shipped.cultures)
    assert not [one for one in found if set("{}$|") & set(one.text)]
