"""What a file or an ontology may hold fits into the database: PostgreSQL refuses what is longer."""

import pytest
from django.db.models import Model

from dialogue.models import KeywordSet, TopicName, Variable
from dialogue.said import Sentence
from ontology_io.files import topics_reader
from ontology_io.owl import resolve_fit
from plans.models import PlanSentence, Trigger


@pytest.mark.parametrize(
    ("longest", "model", "field"),
    [
        (topics_reader.LONGEST_WORDS, KeywordSet, "first"),
        (topics_reader.LONGEST_SENTENCE, Sentence, "text"),
        (topics_reader.LONGEST_VARIABLE, Variable, "text"),
        (resolve_fit.KEYWORDS, KeywordSet, "first"),
        (resolve_fit.KEYWORDS, KeywordSet, "second"),
        (resolve_fit.SENTENCE, Sentence, "text"),
        (resolve_fit.SENTENCE, PlanSentence, "text"),
        (resolve_fit.NAME, TopicName, "name"),
        (resolve_fit.VARIABLE, Variable, "text"),
        (resolve_fit.TRIGGER, Trigger, "text"),
    ],
)
def test_a_text_may_be_as_long_as_its_field(longest: int, model: type[Model], field: str) -> None:
    assert getattr(model._meta.get_field(field), "max_length", None) == longest
