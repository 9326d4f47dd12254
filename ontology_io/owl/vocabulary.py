"""The terms of the ontology: one row each, with domain and range (docs/ontology.md).

Classes, object properties and data properties carry the facts; annotation properties carry what
belongs to a row rather than to its meaning: its stable id, its place, expert notes.
"""

from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

from dialogue.engine.sentence_types import SENTENCE_TYPES

FORMAT = "1"
VOCABULARY = "urn:cair:vocab#"
#: Namespaces whose terms are read as ours: the predecessor's and that of the published sample.
ALIASES = ("http://caressesrobot.org/ontology#", "https://example.org/cair/vocab#")

RDF = "http://www.w3.org/1999/02/22-rdf-syntax-ns#"
RDFS = "http://www.w3.org/2000/01/rdf-schema#"
OWL = "http://www.w3.org/2002/07/owl#"
XSD = "http://www.w3.org/2001/XMLSchema#"
PLAIN = f"{RDF}PlainLiteral"


class Term(NamedTuple):
    """A term's local name, with its comment; `above` is the class or property it lies below."""

    name: str
    comment: str
    above: str = ""
    domain: str = ""
    range: str = ""
    functional: bool = False


CLASSES = (
    Term("Topic", "Root of the TBox: a subclass is a concept that people can talk about."),
    Term("Culture", "A culture for which the CS-ABox holds individuals."),
    Term("Language", "A language of the texts."),
    Term("User", "A person of the PS-ABox. The server never writes one into an export."),
    Term("DialoguePattern", "An order in which kinds of sentences are used within a topic."),
    Term("Pool", "Sentences that belong to no topic: greetings, transitions."),
    Term("Intent", "Something a person may ask for, recognised by its trigger sentences."),
    Term("Slot", "A parameter that is captured from a trigger sentence."),
    Term("Phrase", "A piece of trigger sentence with a name, used as <name>."),
    Term("ValueList", "Words with one meaning for a slot."),
    Term("CanonicalValue", "One value of a list, with the words that mean it."),
    Term("ActionSequence", "An ordered list of actions."),
    Term("Plan", "Actions for the client.", above="ActionSequence"),
    Term("KBPlan", "Actions on likeliness and on the flow of the talk.", above="ActionSequence"),
    Term("Action", "One step of a plan."),
    Term("Parameter", "One named value of an action."),
)

OBJECT_PROPERTIES = (
    Term("hasTopic", "Another topic this one leads to.", "", "Topic", "Topic"),
    Term(
        "hasSpecific", "From the individual of a culture to that of a person.", "", "Topic", "Topic"
    ),
    Term(
        "hasCulture", "The culture of an individual of the CS-ABox.", "", "Topic", "Culture", True
    ),
    Term("concernsUser", "The person of an individual of the PS-ABox.", "", "Topic", "User", True),
    Term("hasGoal", "An activity that fits a topic.", "", "Topic", "Intent"),
    Term(
        "usesPattern",
        "The order of sentences of a topic and all below it.",
        "",
        "Topic",
        "DialoguePattern",
    ),
    Term("hasDefaultLanguage", "The language usually spoken.", "", "Culture", "Language", True),
    Term("hasSlot", "A parameter of an intent.", "", "Intent", "Slot"),
    Term("hasPlan", "What the client does.", "", "Intent", "Plan", True),
    Term("hasKBPlan", "What happens to the talk itself.", "", "Intent", "KBPlan", True),
    Term("hasAction", "A step of a plan.", "", "ActionSequence", "Action"),
    Term("hasParameter", "A parameter of a step.", "", "Action", "Parameter"),
    Term("hasValue", "A value of a list.", "", "ValueList", "CanonicalValue"),
)

SENTENCES: Mapping[str, str] = MappingProxyType(
    {row.owl_property: row.letter for row in SENTENCE_TYPES.values()}
)
"""Local name of each sub-property of hasSentence → the letter of its type."""

DATA_PROPERTIES = (
    Term("hasChunk", "A piece of text that sentences use as $variable.", "", "Topic", PLAIN),
    Term("hasName", "What a topic is called.", "hasChunk", "", PLAIN),
    Term("hasNameWithArticle", "The name with its article.", "hasChunk", "", PLAIN),
    Term("hasSentence", "Something the agent says about a topic.", "", "Topic", PLAIN),
    *(
        Term(row.owl_property, f"{row.name.capitalize()} ({row.letter}).", "hasSentence", "", PLAIN)
        for row in SENTENCE_TYPES.values()
    ),
    Term("hasLine", "A sentence of a pool.", "", "Pool", PLAIN),
    Term("hasKeyword1", "Words of the first set, apart by |.", "", "Topic", PLAIN),
    Term("hasKeyword2", "Words of the second set, apart by |.", "", "Topic", PLAIN),
    Term("hasLikeliness", "How probable a positive attitude is, 0 to 1.", "", "Topic", "", True),
    Term("hasTrigger", "A trigger sentence.", "", "Intent", PLAIN),
    Term("hasPlanSentence", "What the agent says before the plan.", "", "Intent", PLAIN),
    Term("hasAbility", "What the agent can do, after 'I can'.", "", "Intent", PLAIN),
    Term("hasTest", "A sentence with which the triggers are tested.", "", "Intent", PLAIN),
    Term("hasPriority", "100 first.", "", "Intent", f"{XSD}integer", True),
    Term("hasFamily", "A group of intents.", "", "Intent", f"{XSD}string", True),
    Term("hasSlotName", "Written {name} in triggers.", "", "Slot", f"{XSD}string", True),
    Term("hasSlotKind", "text, topic, number ... or value:list.", "", "Slot", f"{XSD}string", True),
    Term("isRequired", "Asked for where it is missing.", "", "Slot", f"{XSD}boolean", True),
    Term("hasSlotQuestion", "How to ask for it.", "", "Slot", PLAIN),
    Term("hasPattern", "The pattern of a phrase.", "", "Phrase", PLAIN),
    Term("hasWords", "Words with this meaning, apart by |.", "", "CanonicalValue", PLAIN),
    Term("hasActionName", "The name of an action.", "", "Action", f"{XSD}string", True),
    Term("hasParameterName", "The name of a parameter.", "", "Parameter", f"{XSD}string", True),
    Term("hasParameterValue", "Its value.", "", "Parameter", f"{XSD}string", True),
    Term(
        "hasSequence",
        "The order, e.g. q r w c [g] | c q r.",
        "",
        "DialoguePattern",
        f"{XSD}string",
        True,
    ),
    Term("hasOrder", "The place among its neighbours, from 1.", "", "", f"{XSD}integer", True),
    Term("hasCode", "The short code: EN, en, start, louder.", "", "", f"{XSD}string", True),
)

#: Fields of a name (languages/*_names.py) → annotation property, all below nameForm.
NAME_FORMS: Mapping[str, str] = MappingProxyType(
    {
        "n": "nameNumber",
        "count": "nameCount",
        "bare": "nameBare",
        "one": "nameOne",
        "g": "nameGender",
        "sg": "nameSingular",
        "art": "nameArticle",
        "il": "nameIl",
        "un": "nameUn",
        "di": "nameDi",
        "a": "nameA",
        "da": "nameDa",
        "in": "nameIn",
        "su": "nameSu",
        "con": "nameCon",
        "dove": "nameDove",
        "polite": "namePolite",
        "kana": "nameKana",
    }
)

ANNOTATION_PROPERTIES = (
    Term(
        "id",
        "The stable key of a row. Keep it when you rename or change; leave it out for what is new.",
    ),
    Term("order", "The place among its neighbours, from 1."),
    Term("frame", "The sentences of one frame say the same in several languages."),
    Term("stateSlot", "The bit of a frame in the dialogue state. Leave it out for what is new."),
    Term("scope", "self: said at this topic only; below: only below it."),
    Term("onlyCulture", "A culture a sentence is kept for; none means all."),
    Term("activity", "The plan of a proposal with its parameters: playsong title=$hasName."),
    Term("goalIntent", "The intent of a proposal."),
    Term("expects", "What a test must capture, as JSON; without it the sentence must not match."),
    Term("active", "false: the sentence is kept but not said."),
    Term("nameForm", "A form of the name that cannot be derived."),
    *(Term(name, f"The form {key!r} of a name.", "nameForm") for key, name in NAME_FORMS.items()),
    Term("defaultKeyword1", "Keywords of a topic in all cultures, first set, apart by |."),
    Term("defaultKeyword2", "Keywords of a topic in all cultures, second set; * is any."),
    Term("treeParent", "Of several superclasses, the one above it in the Dialogue Tree."),
    Term("linkOrder", "The ids of the topics it leads to, in order."),
    Term("homeCulture", "The culture a topic belongs to."),
    Term("gentle", "true: a hard subject, never proposed."),
    Term("inheritsNo", "Letters of the sentence types not taken from above."),
    Term("highestNumbers", "The highest numbers ever given."),
    Term("formatVersion", "The version of this vocabulary."),
)

#: Classes of which nothing is an instance of two (ActionSequence stands for Plan and KBPlan).
DISJOINT = tuple(row.name for row in CLASSES if not row.above)
