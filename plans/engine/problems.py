"""What is wrong with a library, told so that its author finds the place."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Problem:
    """One problem; `position` counts characters of `text` from 0, -1 where there is no place."""

    where: str
    language: str
    text: str
    position: int
    message: str

    def __str__(self) -> str:
        """Return one line: `playsong (en): Open '{' without '}' at position 5 of 'play {title'`."""
        place = f" at position {self.position}" if self.position >= 0 else ""
        text = f"{place} of {self.text!r}" if self.text else place
        language = f" ({self.language})" if self.language else ""
        return f"{self.where}{language}: {self.message}{text}"


class LibraryError(ValueError):
    """A library that cannot be compiled; `problems` lists everything that is wrong."""

    def __init__(self, problems: tuple[Problem, ...]) -> None:
        super().__init__("\n".join(map(str, problems)))
        self.problems = problems
