"""A whole turn through the site, in process: middlewares, view, state, plan, dialogue, answer.

python benchmarks/turn.py [--folder content]
"""

import argparse
import os
import time
from pathlib import Path

import django
import msgspec
from django.test import Client

from dialogue.engine.content import Content, build_content
from ontology_io.files.folder import read_folder

SENTENCES = ("yes", "no", "I do not know", "my sister liked it", "I love dogs")
TURNS = 400


def cost(client: Client, state: str) -> float:
    """Return the least CPU microseconds of a turn over five rounds."""
    least = float("inf")
    bodies = [
        msgspec.json.encode({"client_sentence": sentence, "dialogue_state": state})
        for sentence in SENTENCES
    ]
    for _ in range(5):
        before = time.process_time_ns()
        for turn in range(TURNS):
            body = bodies[turn % len(bodies)]
            answer = client.post("/api/v1/hub/", body, content_type="application/json")
        least = min(least, (time.process_time_ns() - before) / 1000 / TURNS)
        assert answer.status_code == 200, answer.content
    return least


def main() -> None:
    """Print the table of docs/figures.md."""
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--folder", default="content", type=Path)
    base = read_folder(arguments.parse_args().folder).base
    content = build_content(base.knowledge, base.library, 1)
    serve(content)
    from benchmarks.tree import cover  # Django is set up only now
    from dialogue.turns import write_state

    topics = len(content.tree.nodes)
    client = Client()
    print(
        f"| topics covered of {topics} | body, characters | CPU of a turn |\n| ---: | ---: | ---: |"
    )
    first = 0.0
    for covered in (0, topics // 3, 2 * topics // 3, topics - 1):
        state = write_state(cover(content, covered))
        figure = cost(client, state)
        first = first or figure
        print(f"| {covered} | {len(state)} | {figure:.0f} µs, {figure / first:.2f} × |")


def serve(content: Content) -> None:
    """Set Django up and serve this content, without looking for anything newer."""
    os.environ.setdefault("DJANGO_SETTINGS_MODULE", "cair_site.settings")
    os.environ.setdefault("CAIR_POLL_SECONDS", "3600")
    django.setup()
    from dialogue import publishing  # Django is set up only now

    publishing.serve(content)


if __name__ == "__main__":
    main()
