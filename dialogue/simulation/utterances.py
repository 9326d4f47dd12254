"""What people say in simulated talks: lines written without a look at keywords or triggers."""

from importlib.resources import files

from dialogue.simulation.talks import Utterances

TOPICAL = "*"


def read_utterances(language: str) -> Utterances:
    """Return the utterances of a language: `* ` before those that name something to talk about.

    Lines with # are remarks: whose voice follows.
    """
    text = files(__package__).joinpath(f"utterances_{language}.txt").read_text(encoding="utf-8")
    lines = [line.strip() for line in text.splitlines()]
    lines = [line for line in lines if line and not line.startswith("#")]
    return Utterances(
        topical=tuple(line[1:].strip() for line in lines if line.startswith(TOPICAL)),
        chat=tuple(line for line in lines if not line.startswith(TOPICAL)),
    )
