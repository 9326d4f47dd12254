"""Writes the table of terms in docs/ontology.md: `python -m tests.ontology.ontology_page`."""

import re
from collections.abc import Iterator
from pathlib import Path

from ontology_io.owl.vocabulary import (
    ANNOTATION_PROPERTIES,
    CLASSES,
    DATA_PROPERTIES,
    OBJECT_PROPERTIES,
    PLAIN,
    XSD,
    Term,
)

PAGE = Path(__file__).resolve().parents[2] / "docs/ontology.md"
BETWEEN = re.compile(r"(?<=<!-- terms -->\n).*?(?=<!-- end of terms -->)", re.DOTALL)
KINDS = (
    ("Classes", CLASSES),
    ("Object properties", OBJECT_PROPERTIES),
    ("Data properties", DATA_PROPERTIES),
    ("Annotation properties", ANNOTATION_PROPERTIES),
)
RANGES = {
    PLAIN: "text with a language tag",
    f"{XSD}string": "text",
    f"{XSD}integer": "integer",
    f"{XSD}boolean": "boolean",
}

#: One line a term, as Protégé shows it (Manchester syntax).
EXAMPLES = {
    "Topic": "HotDrink SubClassOf Drinking; … SubClassOf Topic",
    "Culture": "CULTURE_EN Type Culture",
    "Language": "LANGUAGE_EN Type Language",
    "User": "USER_DS Type User",
    "DialoguePattern": "PATTERN_1a2b3c4d Type DialoguePattern",
    "Pool": "POOL_START Type Pool",
    "Intent": "INTENT_playsong Type Intent",
    "Slot": "INTENT_playsong_SLOT_title Type Slot",
    "Phrase": "PHRASE_really Type Phrase",
    "ValueList": "VALUES_volume_level Type ValueList",
    "CanonicalValue": "VALUES_volume_level_1 Type CanonicalValue",
    "ActionSequence": "Plan SubClassOf ActionSequence",
    "Plan": "INTENT_playsong_PLAN Type Plan",
    "KBPlan": "INTENT_appreciation_KBPLAN Type KBPlan",
    "Action": "INTENT_playsong_PLAN_A1 Type Action",
    "Parameter": "INTENT_playsong_PLAN_A1_P1 Type Parameter",
    "hasTopic": "EN_COFFEE hasTopic EN_ESPRESSO",
    "hasSpecific": "EN_COFFEE hasSpecific DS_COFFEE",
    "hasCulture": "EN_COFFEE hasCulture CULTURE_EN",
    "concernsUser": "DS_COFFEE concernsUser USER_DS",
    "hasGoal": "EN_COFFEE hasGoal INTENT_playsong",
    "usesPattern": "HotDrink SubClassOf usesPattern value PATTERN_1a2b3c4d",
    "hasDefaultLanguage": "CULTURE_EN hasDefaultLanguage LANGUAGE_EN",
    "hasSlot": "INTENT_playsong hasSlot INTENT_playsong_SLOT_title",
    "hasPlan": "INTENT_playsong hasPlan INTENT_playsong_PLAN",
    "hasKBPlan": "INTENT_appreciation hasKBPlan INTENT_appreciation_KBPLAN",
    "hasAction": "INTENT_playsong_PLAN hasAction INTENT_playsong_PLAN_A1",
    "hasParameter": "INTENT_playsong_PLAN_A1 hasParameter INTENT_playsong_PLAN_A1_P1",
    "hasValue": "VALUES_volume_level hasValue VALUES_volume_level_1",
    "hasChunk": 'unit SubPropertyOf hasChunk; HotDrink SubClassOf unit value "a cup of"@en',
    "hasName": 'EN_COFFEE hasName "coffee"@en',
    "hasNameWithArticle": 'EN_COFFEE hasNameWithArticle "il caffè"@it',
    "hasSentence": "hasQuestion SubPropertyOf hasSentence",
    "hasQuestion": 'HotDrink SubClassOf hasQuestion value "Do you enjoy drinking $hasName?"@en',
    "hasPositiveSentence": '… hasPositiveSentence value "$hasName {warms|warm} the hands."@en',
    "hasNegativeSentence": '… hasNegativeSentence value "That is all right."@en',
    "hasPositiveAndWait": '… hasPositiveAndWait value "How do you take your coffee?"@en',
    "hasQuestionContextual": 'JP_GREENTEA hasQuestionContextual "A tea stalk …"@en',
    "hasQuestionGoal": '… hasQuestionGoal value "Shall I play a song about $hasName?"@en',
    "hasTransition": '… hasTransition value "$hasName makes me think of $toName."@en',
    "hasInitiative": '… hasInitiative value "What shall we talk about?"@en',
    "hasLine": 'POOL_START hasLine "Hello, $name."@en',
    "hasKeyword1": 'EN_COFFEE hasKeyword1 "coffee|coffees"@en',
    "hasKeyword2": 'EN_COFFEE hasKeyword2 "*"@en',
    "hasLikeliness": "EN_COFFEE hasLikeliness 0.7",
    "hasTrigger": 'INTENT_playsong hasTrigger "sing (me|us) [the song] {title}"@en',
    "hasPlanSentence": 'INTENT_playsong hasPlanSentence "Here comes {title}."@en',
    "hasAbility": 'INTENT_playsong hasAbility "play music"@en',
    "hasTest": 'INTENT_playsong hasTest "Sing me Volare"@en',
    "hasPriority": "INTENT_playsong hasPriority 50",
    "hasFamily": 'INTENT_playsong hasFamily "media"',
    "hasSlotName": 'INTENT_playsong_SLOT_title hasSlotName "title"',
    "hasSlotKind": 'INTENT_playsong_SLOT_title hasSlotKind "text"',
    "isRequired": "INTENT_playsong_SLOT_title isRequired false",
    "hasSlotQuestion": 'INTENT_playsong_SLOT_title hasSlotQuestion "Which song?"@en',
    "hasPattern": 'PHRASE_really hasPattern "really|truly"@en',
    "hasWords": 'VALUES_volume_level_1 hasWords "louder|up"@en',
    "hasActionName": 'INTENT_playsong_PLAN_A1 hasActionName "playsong"',
    "hasParameterName": 'INTENT_playsong_PLAN_A1_P1 hasParameterName "title"',
    "hasParameterValue": 'INTENT_playsong_PLAN_A1_P1 hasParameterValue "{title}"',
    "hasSequence": 'PATTERN_1a2b3c4d hasSequence "q r w c [g] | c q r w [g]"',
    "hasOrder": "INTENT_playsong_PLAN_A1 hasOrder 1",
    "hasCode": 'CULTURE_EN hasCode "EN"',
    "id": 'on GreenTea: "t301"; on a sentence: "f553.en"',
    "order": "on GreenTea: 8; on a sentence: 1",
    "frame": 'on a sentence: "HotDrink.q1"',
    "stateSlot": "on a sentence: 10",
    "scope": 'on a sentence: "below"',
    "onlyCulture": "on a sentence: CULTURE_JP",
    "activity": 'on a proposal: "playsong title=$hasName.bare"',
    "goalIntent": "on a proposal: INTENT_playsong",
    "expects": 'on a test: {"title": "Volare"}',
    "active": "on a sentence: false",
    "nameForm": "nameBare SubPropertyOf nameForm",
    "nameNumber": 'on HotDrink: "p"@en (plural)',
    "nameCount": 'on GreenTea: "no"@en (cannot be counted)',
    "nameBare": 'on HotDrink: "hot drink"@en',
    "nameOne": 'on YoungestSibling: "the youngest child"@en',
    "nameGender": 'on GreenTea: "m"@it',
    "nameSingular": 'on HotDrink: "bevanda calda"@it',
    "nameArticle": 'on Dickens: "none"@it',
    "nameIl": '"il cielo e le stagioni"@it',
    "nameUn": '"un uovo di Pasqua"@it',
    "nameDi": '"di miele e limone"@it',
    "nameA": '"a miele e limone"@it',
    "nameDa": '"da miele e limone"@it',
    "nameIn": '"in miele e limone"@it',
    "nameSu": '"su miele e limone"@it',
    "nameCon": '"con il cielo e le stagioni"@it',
    "nameDove": '"al mare"@it',
    "namePolite": '"お寿司"@ja',
    "nameKana": 'on GreenTea: "りょくちゃ"@ja',
    "defaultKeyword1": 'on GreenTea: "tè verde"@it',
    "defaultKeyword2": 'on GreenTea: "*"@it',
    "treeParent": "on a class with two superclasses: HotDrink",
    "linkOrder": 'on GreenTea: "t302 t275 t560"',
    "homeCulture": "on GreenTea: CULTURE_JP",
    "gentle": "on CareHospital: true",
    "inheritsNo": 'on Husband: "qg"',
    "highestNumbers": 'on the ontology: "topic=990 frame=2468 intent=95"',
    "formatVersion": 'on the ontology: "1"',
}


def terms_table() -> str:
    """Return one table a kind of term, a row each, in the order of the vocabulary."""
    return "\n".join(_tables())


def _tables() -> Iterator[str]:
    for title, terms in KINDS:
        sided = any(_sides(term) for term in terms)
        yield f"### {title}\n"
        yield (
            "| term | from → to | meaning | example |" if sided else "| term | meaning | example |"
        )
        yield "| --- " * (4 if sided else 3) + "|"
        for term in terms:
            name = f"`{term.name}`" + (f" < `{term.above}`" if term.above else "")
            sides = (_sides(term),) if sided else ()
            comment = term.comment.replace("<", "&lt;")
            cells = (name, *sides, comment, f"`{EXAMPLES[term.name]}`")
            yield "| " + " | ".join(cell.replace("|", r"\|") for cell in cells) + " |"
        yield ""


def _sides(term: Term) -> str:
    if not (term.domain or term.range):
        return ""
    to = (
        "decimal 0.0 to 1.0" if term.name == "hasLikeliness" else RANGES.get(term.range, term.range)
    )
    sides = f"{term.domain} → {to}".strip()
    return f"{sides}, one at most" if term.functional else sides


if __name__ == "__main__":
    text = PAGE.read_text(encoding="utf-8")
    PAGE.write_text(BETWEEN.sub(lambda _: terms_table(), text), encoding="utf-8")
