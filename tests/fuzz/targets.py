# ruff: noqa: PT017 (Atheris calls these too)
"""What must hold of any bytes whatsoever: one function for each reader of strangers' data.

Each returns where its reader gave a documented answer, or refused in the documented way; whatever
else escapes is a finding. Hypothesis and Atheris call the same functions.
"""

from base64 import urlsafe_b64encode
from itertools import pairwise

from cair_site.errors import ERRORS, ApiError
from cair_site.messages import DEFLATE, GZIP, deflated, inflated, parse_json
from dialogue.engine import codec
from dialogue.engine.codec import StateError
from ontology_io.owl.limits import Limits, OwlError
from ontology_io.owl.prescan import scan
from plans.engine.catalogue import LibraryError, compile_catalogue
from plans.engine.intents import Intent, Library, Phrase, Slot, ValueList
from plans.engine.patterns import (
    PatternError,
    Sequence,
    parse_options,
    parse_pattern,
    print_pattern,
)

KEY = b"a key that only these tests know"
LANGUAGES = ("en", "it", "ja")
OWL_LIMITS = Limits(size=100_000, elements=3_000)
_KINDS = {"title": "text", "topic": "topic", "count": "number", "level": "value:level"}
_SLOTS = tuple(Slot(name=name, kind=kind) for name, kind in _KINDS.items())
_LEVELS = {code: {"louder": ("up", "più", "大きく")} for code in LANGUAGES}
_VALUES = ValueList(key="level", values=_LEVELS)


def signed(data: bytes) -> str:
    """Return a state's text as the server itself would have signed these bytes."""
    return urlsafe_b64encode(codec._tag(data, KEY) + data).decode().rstrip("=")


def state_text(data: bytes) -> None:
    """Whatever a client sends as a state is what was written, letter for letter, or refused."""
    try:
        state = codec.decode(data, [KEY])
    except StateError as error:
        assert error.code in ERRORS
    else:
        assert codec.encode(state, [KEY]).encode() == data


def signed_state(data: bytes) -> None:
    """Whatever a key signed, of this version or another: a state, or refused."""
    try:
        state = codec.decode(signed(data or b"\0"), [KEY], inflated=50_000)
    except StateError as error:
        assert error.code in ERRORS
        return
    assert codec.decode(codec.encode(state, [KEY]), [KEY], longest=10**6) == state


def trigger(data: bytes) -> None:
    """A trigger or phrase is read and printed back the same, or refused at a place inside it."""
    text = data.decode("utf-8", "replace")
    for read in (parse_pattern, parse_options):
        try:
            found = read(text)
        except PatternError as error:
            assert 0 <= error.position <= len(text)
        else:
            _reads_back(found)


def _reads_back(found: Sequence) -> None:
    printed = print_pattern(found)
    if len(printed) <= 600:
        assert parse_pattern(printed) == found


def library(data: bytes) -> None:
    """A library with any trigger is compiled or refused with its problems; then it is matched."""
    text, _, sentence = data.decode("utf-8", "replace").partition("\n")
    triggers = dict.fromkeys(LANGUAGES, (text,))
    intent = Intent(number=1, key="wish", triggers=triggers, plan_sentences={}, slots=_SLOTS)
    please = Phrase(key="please", texts=dict.fromkeys(LANGUAGES, text[:9] or "please"))
    try:
        catalogue = compile_catalogue(
            Library(intents=(intent,), values=(_VALUES,), phrases=(please,))
        )
    except LibraryError as error:
        assert error.problems
        return
    for code in LANGUAGES:
        match = catalogue.match(sentence, code)
        assert match is None or match.intent is intent
        catalogue.suggest(sentence, code)


def body(data: bytes) -> None:
    """A body is a JSON object or one of the errors of bodies; what was read goes back the same."""
    try:
        plain, encoding = inflated(data)
        message = parse_json(plain)
    except ApiError as error:
        assert error.code.startswith("body.")
        assert error.status in (400, 413)
        return
    assert isinstance(message, dict)
    if encoding in (DEFLATE, GZIP):
        assert inflated(deflated(plain, encoding)) == (plain, encoding)


def owl(data: bytes) -> None:
    """A file is told to be RDF/XML or OWL/XML, or refused in words with what to do."""
    try:
        kind = scan(data, OWL_LIMITS)
    except OwlError as error:
        assert all(problem.text for problem in error.problems)
        assert len(error.problems) <= OWL_LIMITS.problems + 1
    else:
        assert kind in ("rdfxml", "owlxml")


def plan_of(string: str, actions: list[tuple[str, dict[str, str | None]]]) -> None:
    """Assert what docs/plans.md promises of a plan string."""
    assert string.splitlines() in ([], [string])
    assert string.count("#") == string.count("#action=") == len(actions)
    assert string == string.rstrip()
    assert not any(one.isspace() and two == "#" for one, two in pairwise(string))
