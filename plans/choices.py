"""What a client may choose: a language that is spoken, written as "it", "IT" or "it-IT"."""

from collections.abc import Collection

from languages.known import LANGUAGES


class UnknownChoiceError(ValueError):
    """A language or culture that is not there; says which there are."""

    def __init__(self, kind: str, value: str, known: Collection[str]) -> None:
        super().__init__(f"There is no {kind} {value[:20]!r}.")
        self.kind = kind
        self.hint = f"Use one of {', '.join(known)}."


def language_code(tag: str) -> str:
    """Return the code of a language: "it" for "it-IT". Raises UnknownChoiceError."""
    code = tag.strip().lower().replace("_", "-").split("-")[0]
    if code not in LANGUAGES:
        raise UnknownChoiceError("language", code, LANGUAGES)
    return code
