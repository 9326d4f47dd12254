"""What the tests of the intent page share."""

from collections.abc import Iterator
from typing import Any

import pytest
from django.test import Client
from django.urls import reverse

from authoring.intent_page.draft_library import forget
from plans import models

ADD = "admin:plans_intent_add"
LIST = "admin:plans_intent_changelist"
TRY, ANSWER, CHECK = "admin:intent_try", "admin:intent_answer", "admin:intent_check"
FAILING = "admin:intent_failing"


@pytest.fixture
def nothing_kept() -> Iterator[None]:
    forget()
    yield
    forget()


def song() -> str:
    return reverse("admin:plans_intent_change", args=[models.Intent.objects.get(key="playsong").pk])


def part(prefix: str, rows: list[dict[str, str]]) -> dict[str, str]:
    """Return the rows of a part as the page sends new ones."""
    data = {f"{prefix}-TOTAL_FORMS": str(len(rows)), f"{prefix}-INITIAL_FORMS": "0"}
    for place, row in enumerate(rows):
        data |= {f"{prefix}-{place}-{name}": value for name, value in row.items()}
    return data


def said(language: str, **more: str) -> dict[str, str]:
    return {"language": language, "position": "", **more}


TESTS = (
    ("en", "Water my plants", "match"),
    ("en", "I watered my plants yesterday", "not"),
    ("it", "Annaffia le piante", "match"),
    ("ja", "お花に水をあげて", "match"),
)


def plants(**more: str) -> dict[str, str]:
    """Return the form of "water the plants" as a new author fills it in."""
    return {
        "key": "Water the plants",
        "family": "household",
        "priority": "50",
        "abilities_en": "water the plants",
        "abilities_it": "annaffiare le piante",
        "abilities_ja": "",
        "position": "9",
        **part("slots", []),
        **part(
            "triggers",
            [
                said("en", text="water (the|my) plants"),
                said("en", text=""),
                said("en", text="give the plants some water"),
                said("it", text="(annaffia|innaffia) le [mie] piante"),
                said("ja", text="(植物|お花) に 水 を (あげて|やって)"),
            ],
        ),
        **part(
            "plan_sentences",
            [said(code, text=text) for code, text in (("en", "Good."), ("it", "Bene."))],
        ),
        **part("plan_actions", [{"action": "", "position": ""}]),
        **part("kbplan_actions", []),
        **part(
            "tests",
            [
                said(code, sentence=text, parameters_must=must, parameters_line="")
                for code, text, must in TESTS
            ],
        ),
        **more,
    }


def told(response: Any) -> str:
    return "\n".join(str(one) for one in response.context["messages"])


def check(client: Client, data: dict[str, str], intent: str = "0", **more: str) -> Any:
    response = client.post(reverse(CHECK), {**data, "intent": intent, **more})
    assert response.status_code == 200
    return response.json()


def answer(client: Client, sentence: str, language: str = "en", **more: Any) -> Any:
    data = {"sentence": sentence, "language": language, **more}
    response = client.post(reverse(ANSWER), data)
    assert response.status_code == 200
    return response.json()
