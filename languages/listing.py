"""Lists of names as people say them."""


def listed(names: tuple[str, ...], comma: str, last: str) -> str:
    """Return the names joined, the last one by its own word: "tea, milk or Rome"."""
    if len(names) < 2:
        return "".join(names)
    return f"{comma.join(names[:-1])}{last}{names[-1]}"
