"""The lints of one filled sentence."""

import pytest

from languages.lints import Finding, lint_gentle_sentence, lint_health_sentence, lint_sentence


def codes(found: tuple[Finding, ...]) -> list[str]:
    return [finding.code for finding in found]


@pytest.mark.parametrize(
    ("language", "kind", "sentence"),
    [
        ("en", "q", "Do you like the Queen's crown?"),
        ("en", "p", "How nice! I cannot taste, but I like to hear about it."),
        ("en", "e", "It is your turn, $name."),
        ("en", "c", "Let us leave the lie-in in peace."),
        ("it", "w", "Hai mai visto uno scoiattolo da vicino?"),
        ("it", "c", "Ogni angolo di La Spezia ha una storia."),
        ("ja", "q", "お寿司はお好きですか？"),
        ("ja", "p", "いいですね。話が弾みますね。"),
    ],
)
def test_a_good_sentence_has_no_findings(language: str, kind: str, sentence: str) -> None:
    assert lint_sentence(sentence, kind, language) == ()


@pytest.mark.parametrize(
    ("language", "kind", "sentence", "code"),
    [
        ("en", "q", "You like tea.", "G5"),
        ("en", "p", "Is it good?", "G5"),
        ("en", "c", "Is it? I think so.", "G5"),
        ("en", "p", "", "G5"),
        ("en", "start", "Hello", "G5"),
        ("en", "w", "Is it? Is it really?", "G5"),
        ("ja", "q", "お好きですか?", "G5"),
        ("en", "c", "One " * 19 + "end.", "S1"),
        ("it", "c", "Internazionalizzazione dell'amministrazione straordinaria.", "S1"),
        ("ja", "c", "あ" * 51 + "です。", "S1"),
        ("en", "c", "Tea (hot) is good.", "S1"),
        ("en", "c", "Tea and/or milk.", "S1"),
        ("en", "c", "There are 10000 teas.", "S1"),
        ("en", "c", "Tea, milk, etc.", "S1"),
        ("it", "c", "Tè, latte, ecc.", "S1"),
        ("en", "c", "I like $hasName.", "G1"),
        ("en", "c", "It {is|are} good.", "G1"),
        ("en", "c", "I ate a lot of cake.", "P1"),
        ("en", "c", "When I was a child we had tea.", "P1"),
        ("en", "c", "My mother made tea.", "P1"),
        ("en", "c", "Did the a dog bark!", "G3"),
        ("it", "c", "Ho mangiato molto bene.", "P1"),
        ("it", "c", "Sei stato molto gentile.", "P1"),
        ("it", "c", "Benvenuta!", "P1"),
        ("it", "c", "Parliamo di il tè.", "G2"),
        ("ja", "c", "私はケーキを食べました。", "P1"),
        ("ja", "c", "あなたの番です。", "G4"),
        ("ja", "q", "食べたいですか？", "G4"),
        ("ja", "c", "ﾋﾟｱﾉです。", "G4"),
        ("ja", "c", "これは犬だ。", "G4"),
    ],
)
def test_a_fault_is_found(language: str, kind: str, sentence: str, code: str) -> None:
    assert code in codes(lint_sentence(sentence, kind, language))


def test_errors_come_before_advice() -> None:
    found = lint_sentence("When you were young " + "very " * 16 + "did you (dance)", "q", "en")
    errors = [finding.error for finding in found]
    assert errors == sorted(errors, reverse=True)
    assert {True, False} == set(errors)


def test_health_sentences_give_no_advice() -> None:
    assert codes(lint_health_sentence("You should rest.", "en")) == ["P1"]
    assert lint_health_sentence("Rest can feel good.", "en") == ()


def test_gentle_sentences_are_not_merry() -> None:
    assert codes(lint_gentle_sentence("Che bello!", "it")) == ["P1"]
    assert lint_gentle_sentence("Ti ascolto.", "it") == ()
