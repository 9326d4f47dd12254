"""How the phrases of an answer add up: "oh yes, very much" is a strong yes.

What the person says about the topic ("I love it") counts more than "yes" or "no" alone; of two
opinions the last counts. A long sentence without an answer stays UNCLEAR.
"""

from collections.abc import Sequence

from languages.answer_book import OPINIONS, AnswerBook, Heard, Mark, Says, hear
from languages.language import Attitude, Token

A = Attitude
S = Says

_NEAR_BEFORE, _NEAR_AFTER, _GAP = 6, 5, 2

#: What an opinion means: alone, with "very", "a bit", "not", "not very", "really not".
_OPINIONS = {
    S.LOVE: (A.YES_STRONG, A.YES_STRONG, A.YES, A.NOT_REALLY, A.NOT_REALLY, A.NO_STRONG),
    S.LIKE: (A.YES, A.YES_STRONG, A.A_LITTLE, A.NO, A.NOT_REALLY, A.NO_STRONG),
    S.MILD: (A.A_LITTLE,) * 6,
    S.DISLIKE: (A.NO, A.NO_STRONG, A.NOT_REALLY, A.A_LITTLE, A.A_LITTLE, A.NO_STRONG),
    S.HATE: (A.NO_STRONG, A.NO_STRONG, A.NO, A.A_LITTLE, A.A_LITTLE, A.NO_STRONG),
}
_ALONE, _VERY, _SOFT, _NOT, _NOT_VERY, _VERY_NOT = range(6)

#: Without an opinion: the first row whose phrases were all heard decides.
_PARTICLES = (
    ({S.NEVER}, A.NO_STRONG),
    ({S.NO, S.SURE}, A.NO_STRONG),
    ({S.NO, S.BIT}, A.NOT_REALLY),
    ({S.YES, S.MEH}, A.A_LITTLE),
    ({S.MEH}, A.NOT_REALLY),
    ({S.NOT, S.YES}, A.NOT_REALLY),
    ({S.NOT, S.VERY}, A.NOT_REALLY),
    ({S.NOT, S.SURE}, A.NO_STRONG),
    ({S.NOT, S.SOMETIMES}, A.NOT_REALLY),
    ({S.NOT, S.BAD}, A.A_LITTLE),
    ({S.NO}, A.NO),
    ({S.NOT}, A.NO),
    ({S.YES, S.BIT}, A.A_LITTLE),
    ({S.YES, S.SOMETIMES}, A.DEPENDS),
    ({S.YES, S.VERY}, A.YES_STRONG),
    ({S.SURE}, A.YES_STRONG),
    ({S.YES}, A.YES),
    ({S.SOMETIMES}, A.DEPENDS),
    ({S.BIT}, A.A_LITTLE),
    ({S.BAD}, A.NO),
    ({S.GOOD, S.VERY}, A.YES_STRONG),
    ({S.GOOD}, A.YES),
    ({S.VERY}, A.YES_STRONG),
)
_PROPER = frozenset({S.YES, S.NO, S.SURE, S.NEVER, S.MEH})
_WEAK = frozenset({S.VERY, S.BIT, S.GOOD, S.BAD, S.SOMETIMES})
_POSITIVE = frozenset({A.YES_STRONG, A.YES, A.A_LITTLE})
_NEGATIVE = frozenset({A.NO_STRONG, A.NO, A.NOT_REALLY})
_STRONGER = {(A.YES, A.YES_STRONG), (A.NO, A.NO_STRONG)}


def read_answer(sentence: str, tokens: Sequence[Token], book: AnswerBook) -> Attitude:
    """Return what an answer to a yes/no question says; UNCLEAR where it is no answer."""
    heard = hear(sentence, tokens, book)
    if any(mark.says is S.DEPENDS for mark in heard.marks):
        return A.DEPENDS
    particles = _read_particles(heard, book)
    opinions = [mark for mark in heard.marks if _is_own_opinion(mark, heard, book)]
    return _read_opinions(opinions, particles, heard, book) if opinions else particles


def _read_opinions(
    opinions: list[Mark], particles: Attitude, heard: Heard, book: AnswerBook
) -> Attitude:
    first, last = _weigh(opinions[0], heard, book), _weigh(opinions[-1], heard, book)
    if first in _POSITIVE and last in _NEGATIVE and _says_between(S.BUT, opinions, heard):
        return A.DEPENDS
    if _contradict(particles, last) and not _is_about_it(opinions[-1], heard, book):
        return particles
    if last in _POSITIVE and _is_taken_back(opinions[-1], heard):
        return A.A_LITTLE
    if last is A.YES and S.SOMETIMES in _around(opinions[-1], heard)[1]:
        return A.DEPENDS
    return particles if (last, particles) in _STRONGER else last


def _contradict(one: Attitude, other: Attitude) -> bool:
    return (one in _POSITIVE and other in _NEGATIVE) or (one in _NEGATIVE and other in _POSITIVE)


def _says_between(says: Says, opinions: list[Mark], heard: Heard) -> bool:
    start, end = opinions[0].end, opinions[-1].start
    return any(mark.says is says and start <= mark.start < end for mark in heard.marks)


def _is_taken_back(opinion: Mark, heard: Heard) -> bool:
    """Hear "but not too much", "but only sometimes" after an opinion."""
    after = [mark.says for mark in heard.marks if mark.start >= opinion.end]
    softened = S.MEH in after or S.SOMETIMES in after
    return S.BUT in after and softened


def _is_own_opinion(mark: Mark, heard: Heard, book: AnswerBook) -> bool:
    """Say whether it is the person's own opinion: "I like", "love it!"; not "she loves"."""
    if mark.says not in OPINIONS:
        return False
    own_words = book.selves.intersection(heard.words[mark.start : mark.end])
    return not book.selves or bool(own_words) or _has_own_subject(mark, heard, book)


def _has_own_subject(opinion: Mark, heard: Heard, book: AnswerBook) -> bool:
    """Walk back over known words to "I", to somebody else, or to the start of the clause."""
    position = opinion.start
    while position not in heard.breaks:
        position -= 1
        word = heard.words[position]
        if word in book.selves:
            return True
        if word in book.others or position not in heard.known:
            return False
    # "Like my mother said" is no opinion, "like it" is.
    return heard.words[opinion.start] not in book.doubtful or _is_about_it(opinion, heard, book)


def _is_about_it(opinion: Mark, heard: Heard, book: AnswerBook) -> bool:
    """Say whether an opinion is about what was asked: "no, I love it", not "no, I love coffee"."""
    if book.objects_first:
        return _has_own_subject(opinion, heard, book)
    for position in range(opinion.end, len(heard.words)):
        if heard.ends_clause(position) or heard.words[position] in book.pronouns:
            return True
        if position not in heard.known:
            return False
    return True


def _weigh(opinion: Mark, heard: Heard, book: AnswerBook) -> Attitude:
    before, after = _around(opinion, heard)
    if before[-1:] == [S.MEH] and not book.objects_first:
        return _OPINIONS[opinion.says][_NOT_VERY]  # "not particularly fond"; but ちょっと好き
    return _OPINIONS[opinion.says][_modifier(before, after)]


def _around(opinion: Mark, heard: Heard) -> tuple[list[Says], list[Says]]:
    """Return what was said close before and close after an opinion, in its own clause."""
    before: list[Says] = []
    edge = opinion.start
    for mark in reversed([mark for mark in heard.marks if mark.end <= opinion.start]):
        too_far = edge - mark.end > _GAP or opinion.start - mark.end > _NEAR_BEFORE
        if too_far or mark.says is S.BUT or mark.says in OPINIONS:
            break
        before.insert(0, mark.says)
        edge = mark.start
    after: list[Says] = []
    for mark in heard.marks:
        if opinion.end <= mark.start < opinion.end + _NEAR_AFTER:
            if mark.says is S.BUT or mark.says in OPINIONS or mark.says is S.NOT:
                break
            after.append(mark.says)
    return before, after


def _modifier(before: list[Says], after: list[Says]) -> int:
    if S.NOT_NOT in before:
        return _SOFT
    if S.NOT in before:
        return _negated(before, after)
    around = {*before, *after}
    if S.NEVER in around:
        return _VERY_NOT
    if S.BIT in around or S.MEH in around:
        return _SOFT
    return _VERY if S.VERY in around else _ALONE


def _negated(before: list[Says], after: list[Says]) -> int:
    place = before.index(S.NOT)
    if S.VERY in before[:place] or S.NEVER in (*before, *after) or S.BIT in after:
        return _VERY_NOT
    softened = S.VERY in (*before[place:], *after) or S.MEH in before
    return _NOT_VERY if softened else _NOT


def _read_particles(heard: Heard, book: AnswerBook) -> Attitude:
    """Return what "yes", "no", "not really", "a bit" … say where there is no opinion."""
    said = _valid(heard, book)
    for needed, attitude in _PARTICLES:
        if needed <= said:
            return attitude
    return A.UNCLEAR


def _valid(heard: Heard, book: AnswerBook) -> set[Says]:
    slack = _slack(heard, book)
    head = _head(heard)
    if not any(mark.says in _PROPER and not _is_doubtful(mark, heard, book) for mark in head):
        head = []
    said: list[Says] = []
    for mark in heard.marks:
        short = heard.unknown <= slack[mark.says in _WEAK]
        alone = mark.says in _PROPER and _is_alone(mark, heard)
        if (short or alone or mark in head) and not _is_doubtful(mark, heard, book):
            said.append(_echoed(said) if mark.says is S.ECHO else mark.says)
    return _with_the_last_word(said)


def _slack(heard: Heard, book: AnswerBook) -> tuple[int, int]:
    """Return how many unknown words an answer may have; none where others' opinions are told."""
    if any(_is_theirs(mark, heard, book) for mark in heard.marks):
        return -1, -1
    return book.slack, book.slack_of_weak


def _echoed(said: list[Says]) -> Says:
    return S.NO if S.NOT in said else S.YES  # "non lo faccio"


def _is_theirs(mark: Mark, heard: Heard, book: AnswerBook) -> bool:
    opinion_of_others = mark.says in OPINIONS and not _is_own_opinion(mark, heard, book)
    return mark.says is S.THEIRS or opinion_of_others


def _head(heard: Heard) -> list[Mark]:
    """Return the marks at the start of the sentence that follow one another without a gap."""
    head: list[Mark] = []
    for mark in heard.marks:
        if mark.start != (head[-1].end if head else 0):
            break
        head.append(mark)
    return head


def _is_alone(mark: Mark, heard: Heard) -> bool:
    return mark.start in heard.breaks and heard.ends_clause(mark.end)


def _is_doubtful(mark: Mark, heard: Heard, book: AnswerBook) -> bool:
    """Say whether a word such as "si" is hardly a particle: it stands before unknown words."""
    text = "".join(heard.words[mark.start : mark.end])
    if text not in book.doubtful:
        return False
    return not heard.ends_clause(mark.end) and mark.end not in heard.known


def _with_the_last_word(said: list[Says]) -> set[Says]:
    """Return what was said; of "yes" and "no" only the last: "no … yes, I do"."""
    particles = [says for says in said if says in (S.YES, S.NO)]
    return {says for says in said if says not in (S.YES, S.NO)} | set(particles[-1:])
