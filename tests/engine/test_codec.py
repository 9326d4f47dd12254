"""The text of a state: what goes in comes out, and nothing else ever does."""

from base64 import urlsafe_b64decode, urlsafe_b64encode
from random import Random

import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as some

from dialogue.engine import codec, codec_columns
from dialogue.engine.codec import StateError, decode, encode
from dialogue.engine.state import MAX_FRAME, MAX_TOPIC, DialogueState, Pending, union

KEY = b"the key of this year, secret"
OLD_KEY = b"the key of last year, secret"
MRS_SMITH = DialogueState("en", "EN")

numbers = some.integers(0, 2**32 - 1)
topics = some.integers(0, MAX_TOPIC)
words = some.text(some.characters(exclude_categories=["Cs"]), max_size=40)
letters = some.sampled_from("qpnrwcgte")
pendings = some.builds(
    Pending,
    numbers,
    words,
    some.lists(some.tuples(words, some.text("aé茶🎵", max_size=300)), max_size=8).map(tuple),
)
headers = some.builds(
    DialogueState,
    some.sampled_from(["en", "it", "ja", "zh-Hant", "es-419"]),
    some.from_regex(r"\A[A-Z]{2,8}\Z"),
    seed=numbers,
    turn=numbers,
    topic=topics,
    last_type=some.one_of(some.just(""), letters),
    ordering=some.text(letters, max_size=16),
    frames=some.lists(some.integers(0, MAX_FRAME), max_size=32).map(tuple),
    topics=some.lists(some.integers(0, 30) | topics, max_size=16).map(tuple),
    siblings=numbers,
    noes=some.just(0) | numbers,
    questions=some.just(0) | numbers,
    misses=some.just(0) | numbers,
    ended=some.booleans(),
    avoided=some.lists(some.tuples(topics, numbers), max_size=8).map(tuple),
    offer=some.integers(0, MAX_FRAME),
    pending=some.none() | pendings,
)
coverages = some.lists(
    some.tuples(
        some.integers(0, 30) | some.sampled_from([4_000, MAX_TOPIC]),
        some.none() | some.integers(0, 10),
        some.sets(some.integers(0, 127), max_size=4),
    ),
    max_size=12,
)


def covered(state: DialogueState, share: float, size: int, chance: Random) -> DialogueState:
    """Return a state in which about this share of topics 1..size was talked about."""
    talked = [topic for topic in range(1, size + 1) if chance.random() < share]
    levels, used = bytearray(size + 1), (bytearray(size + 1), bytearray(size + 1))
    for topic in talked:
        levels[topic] = chance.choice((0, *range(1, 12)))
        used[0][topic] = chance.choice((1, 5, 130, 255))
        used[1][topic] = chance.choice((0, 0, 0, 7))
    columns = tuple(bytes(column).rstrip(b"\0") for column in used)
    while columns and not columns[-1]:
        columns = columns[:-1]
    fields = {name: getattr(state, name) for name in state.__slots__}
    return DialogueState(**fields | {"levels": bytes(levels).rstrip(b"\0"), "used": columns})


@settings(deadline=None, max_examples=150)
@given(headers, coverages)
def test_every_state_comes_back_as_it_was(state, coverage):
    for topic, tenth, slots in coverage:
        state = state.with_likeliness(topic, None if tenth is None else tenth / 10)
        for slot in slots:
            state = state.with_used(topic, slot)
    assert decode(encode(state, [KEY]), [KEY]) == state


@settings(deadline=None, max_examples=60)
@given(some.sampled_from([0.01, 0.1, 0.5, 0.9, 1.0]), some.integers(1, 3_000), some.integers(0, 99))
def test_every_share_of_topics_comes_back(share, size, seed):
    state = covered(MRS_SMITH, share, size, Random(seed))
    assert decode(encode(state, [KEY]), [KEY]) == state


@given(some.integers(100, 500), some.sampled_from([0.05, 0.2, 0.6, 1.0]), some.integers(0, 99))
def test_the_shorter_layout_is_written(topics, share, seed):
    state = covered(MRS_SMITH, share, round(topics / share), Random(seed))
    columns = (state.levels, *state.used)
    cover = union(columns).rstrip(b"\0")
    count = len(cover) - cover.count(0)
    assume(codec_columns.ROWS_ONLY < count <= codec_columns.MAX_ROWS)
    packed = codec_columns._as_columns(cover, columns, count, state.topics)
    rows = codec_columns._as_rows(cover, columns, state.topics)
    written = codec_columns.body(state.levels, state.used, state.topics)
    assert written == (rows if len(rows) < len(packed) else packed)


def test_masks_of_every_value_come_back():
    masks = bytes(value for value in range(256) for _ in range(9))
    state = DialogueState("en", "EN", levels=bytes((1, 0)) * 3_000 + b"\1", used=(masks + b"\1",))
    assert decode(encode(state, [KEY]), [KEY]) == state


def test_the_largest_state_of_all_comes_back():
    chance = Random(1)
    used = tuple(bytes([*chance.randbytes(MAX_TOPIC), 1]) for _ in range(16))
    state = DialogueState("en", "EN", levels=b"\5" * (MAX_TOPIC + 1), used=used)
    assert decode(encode(state, [KEY]), [KEY], longest=10**7) == state


def test_topics_started_without_any_coverage_come_back():
    state = MRS_SMITH.with_topic_started(7)
    assert decode(encode(state, [KEY]), [KEY]) == state
    text = signed(unsigned(encode(state, [KEY])) + b"\0")
    with pytest.raises(StateError):
        decode(text, [KEY])


def test_zeros_at_the_ends_of_columns_go():
    state = DialogueState("en", "EN", levels=b"\0\3\0\0", used=(b"\0\0", b"\0"))
    assert decode(encode(state, [KEY]), [KEY]) == MRS_SMITH.with_likeliness(1, 0.2)


def test_the_text_is_plain_ascii_for_addresses_and_json():
    text = encode(covered(MRS_SMITH, 0.5, 500, Random(1)), [KEY])
    assert text.isascii()
    assert text.replace("-", "").replace("_", "").isalnum()
    assert decode(text.encode(), [KEY]) == decode(text, [KEY])


def test_a_key_of_last_year_still_reads_and_the_new_one_signs():
    assert decode(encode(MRS_SMITH, [OLD_KEY]), [KEY, OLD_KEY]) == MRS_SMITH
    assert decode(encode(MRS_SMITH, [KEY, OLD_KEY]), [KEY]) == MRS_SMITH


def test_a_key_of_any_length_from_sixteen_bytes_will_do():
    assert decode(encode(MRS_SMITH, [b"k" * 500]), [b"k" * 500]) == MRS_SMITH
    with pytest.raises(ValueError, match="16 bytes or more"):
        encode(MRS_SMITH, [b"short"])


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("", "state.unreadable"),
        ("Mrs Smith likes tea", "state.unreadable"),
        ("お茶", "state.unreadable"),
        ("\ud800", "state.unreadable"),
        ("+/+/" * 20, "state.unreadable"),
        ("A" * 22, "state.unreadable"),
        ("A" * 40, "state.damaged"),
        (encode(MRS_SMITH, [OLD_KEY]), "state.damaged"),
        ("A" * 64_001, "state.too_large"),
    ],
)
def test_what_is_no_state_of_ours_is_refused_with_its_code(text, code):
    with pytest.raises(StateError) as refusal:
        decode(text, [KEY])
    assert refusal.value.code == code
    assert refusal.value.message.startswith("The dialogue state is ")
    assert refusal.value.hint == "Send an empty state to start again."


def signed(data: bytes) -> str:
    """Return bytes as the server itself would have signed them."""
    return urlsafe_b64encode(codec._tag(data, KEY) + data).decode().rstrip("=")


def unsigned(text: str) -> bytes:
    """Return what a text holds after its signature."""
    return urlsafe_b64decode(text + "=" * (-len(text) % 4))[16:]


def test_a_later_version_is_refused_as_such():
    with pytest.raises(StateError) as refusal:
        decode(signed(b"\2" + unsigned(encode(MRS_SMITH, [KEY]))[1:]), [KEY])
    assert refusal.value.code == "state.version"


def test_a_state_that_would_inflate_too_far_is_refused():
    text = encode(DialogueState("en", "EN", levels=b"\5" * 100_000), [KEY])
    assert len(text) < 500
    with pytest.raises(StateError) as refusal:
        decode(text, [KEY], inflated=50_000)
    assert refusal.value.code == "state.too_large"


def test_a_text_cut_short_or_with_one_bit_changed_is_refused():
    text = encode(covered(MRS_SMITH, 0.5, 90, Random(1)), [KEY])
    data = bytearray(urlsafe_b64decode(text + "=" * (-len(text) % 4)))
    for bit in range(8 * len(data)):
        data[bit // 8] ^= 1 << bit % 8
        with pytest.raises(StateError):
            decode(urlsafe_b64encode(data).rstrip(b"="), [KEY])
        data[bit // 8] ^= 1 << bit % 8
    for length in range(len(text)):
        with pytest.raises(StateError):
            decode(text[:length], [KEY])


@given(some.text(max_size=200) | some.binary(max_size=200))
def test_random_text_is_refused(text):
    with pytest.raises(StateError):
        decode(text, [KEY])


def decoded_or_refused(data: bytes) -> None:
    """Assert that bytes signed by the server give a state it could write, or a StateError."""
    try:
        state = decode(signed(data), [KEY], inflated=20_000)
    except StateError:
        return
    assert decode(encode(state, [KEY]), [KEY]) == state


@settings(deadline=None, max_examples=300)
@given(some.binary(max_size=300))
@example(b"\0")
def test_signed_garbage_gives_a_valid_state_or_a_refusal(garbage):
    decoded_or_refused(b"\1" + garbage)
    head = unsigned(encode(MRS_SMITH, [KEY]))[:-2]
    decoded_or_refused(head + garbage)


@settings(deadline=None, max_examples=40)
@given(some.sampled_from([0.02, 0.3, 1.0]), some.integers(0, 10**6))
def test_a_signed_state_with_changed_bytes_gives_a_valid_state_or_a_refusal(share, seed):
    chance = Random(seed)
    head = DialogueState("ja", "JP", 7, 9, 3, "q", "wc", (9, 8, 400), (1, 2), offer=3)
    data = unsigned(encode(covered(head, share, 400, chance), [KEY]))
    for _ in range(20):
        changed = bytearray(data)
        for _ in range(chance.randint(1, 4)):
            changed[chance.randrange(1, len(data))] = chance.randrange(256)
        decoded_or_refused(bytes(changed[: chance.randint(len(data) // 2, 2 * len(data))]))


@pytest.mark.parametrize(
    "fields",
    [
        {"language": "e"},
        {"culture": "E1"},
        {"turn": -1},
        {"topic": MAX_TOPIC + 1},
        {"last_type": "x"},
        {"last_type": "qp"},
        {"ordering": "q" * 17},
        {"frames": (1,) * 33},
        {"frames": (-1,)},
        {"levels": b"\x0c"},
        {"used": (b"\1",) * 17},
        {"pending": Pending(1, "title", (("title", "\ud800"),))},
        {"pending": Pending(1, "title", (("title", "a" * 301),))},
        {"avoided": ((1, 1),) * 9},
    ],
)
def test_a_field_out_of_its_range_is_never_written(fields):
    with pytest.raises(ValueError, match=r"^(?!.*dialogue state is damaged)"):
        encode(DialogueState(**{"language": "en", "culture": "EN"} | fields), [KEY])


@pytest.mark.parametrize(
    ("share", "most"), [(0, 120), (0.018, 320), (0.333, 3_600), (0.667, 5_800), (1.0, 7_400)]
)
def test_a_state_stays_within_its_target_size(share, most):
    chance = Random(5)
    frames = tuple(sorted(chance.randrange(20_000) for _ in range(32 if share else 0)))
    state = covered(DialogueState("en", "EN", turn=300, frames=frames), share, 2_780, chance)
    assert len(encode(state, [KEY])) <= most
