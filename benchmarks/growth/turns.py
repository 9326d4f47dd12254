"""The cost of whole turns in one process, all cases in turn in each round."""

import gc
import json
from collections.abc import Sequence
from functools import cached_property
from pathlib import Path
from typing import NamedTuple
from wsgiref.types import WSGIApplication

from tqdm import tqdm

from benchmarks.micro import site
from benchmarks.micro.reference import cpu_micros
from dialogue.engine.codec import encode
from dialogue.engine.content import Content
from dialogue.engine.state import DialogueState

PATH = "/api/v1/hub/"
KEYS = (site.STATE_KEY.encode(),)
ROUNDS = 40
WARM_UP = 2


class Case(NamedTuple):
    """A turn to measure: content, state, and what is said, each sentence once a round."""

    content: Content
    state: DialogueState
    sentences: Sequence[str]

    @property
    def text(self) -> str:
        """The state as a client keeps it."""
        return encode(self.state, KEYS)

    def bodies(self) -> list[bytes]:
        """Return what is sent."""
        text = self.text
        return [
            json.dumps({"client_sentence": said, "dialogue_state": text}).encode()
            for said in self.sentences
        ]


class Site:
    """The site in this process; `var` is a folder of its own."""

    def __init__(self, var: Path) -> None:
        site.set_up(var)

    @cached_property
    def application(self) -> WSGIApplication:
        """The site as gunicorn sees it."""
        from django.core.management import call_command

        call_command("migrate", verbosity=0, interactive=False)
        from cair_site.wsgi import application

        return application

    def costs(self, cases: Sequence[Case], title: str) -> list[float]:
        """Return the least microseconds of CPU time of a turn of each case."""
        sent = [case.bodies() for case in cases]
        least = [float("inf")] * len(cases)
        application = self.application
        gc.collect()
        gc.freeze()
        for round_ in tqdm(range(WARM_UP + ROUNDS), desc=title, leave=False):
            for place, case in enumerate(cases):
                spent = _round(application, case.content, sent[place])
                if round_ >= WARM_UP:
                    least[place] = min(least[place], spent)
        gc.unfreeze()
        return least


def _round(application: WSGIApplication, content: Content, bodies: list[bytes]) -> float:
    from dialogue import publishing

    publishing.serve(content)
    statuses = set[str]()

    def turns() -> None:
        for body in bodies:
            statuses.add(site.call(application, PATH, body).status)

    spent = cpu_micros(turns) / len(bodies)
    assert statuses == {"200 OK"}, statuses
    return spent
