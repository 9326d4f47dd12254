"""The pages of the authoring admin at the full size: queries, time, and the first look.

python benchmarks/admin_pages.py [--topics 3000] [--sentences 25000] [--folder FOLDER] [--only WORD]

It loads the content files into a database of its own and lets it grow: topics like those that are
there, sentences in three languages. With --folder the database is kept there and used again.
"""

import argparse
import os
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import cycle, islice
from pathlib import Path
from random import Random
from statistics import median
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from django.test import Client

ROOT = Path(__file__).resolve().parent.parent
ROUNDS = 7
MOST_QUERIES, MOST_MS = 25, 150
#: Name of the page, view, what it shows (a key, or the number of a row), what is asked for.
PAGES = (
    ("start", "index", "", ""),
    ("topic list", "dialogue_topic_changelist", "", ""),
    ("topic page, GreenTea", "dialogue_topic_change", "topic:GreenTea", ""),
    ("topic page, a branch", "dialogue_topic_change", "topic:FoodAndDrink", ""),
    ("what the robot says", "topic_said", "topic:GreenTea", "?part=1"),
    ("sentence list", "dialogue_frame_changelist", "", ""),
    ("sentence page", "dialogue_frame_change", "sentence of:FoodAndDrink", ""),
    ("tree", "tree", "", ""),
    ("tree, opened", "tree", "", "?open=GreenTea"),
    ("branch of the tree", "tree_below", "FoodAndDrink", ""),
    ("search in the tree", "tree_found", "", "?q=tea"),
    ("move a topic", "tree_move", "GreenTea", "?to=Animal"),
    ("move a branch", "tree_move", "FoodAndDrink", "?to=Animal"),
    ("coverage", "coverage", "", ""),
    ("checks", "checks", "", ""),
    ("publish", "publish", "", ""),
    ("publish, the changes", "publish", "", "?whole=1"),
    ("releases", "releases", "", ""),
    ("a release", "release", "release:", ""),
    ("intents list", "plans_intent_changelist", "", ""),
    ("intent page, need_help", "plans_intent_change", "intent:need_help", ""),
    ("try a sentence", "intent_try", "", "?sentence=play+my+way&language=en"),
    ("chat", "chat", "", ""),
    ("conversations", "conversations", "", ""),
    ("history", "audit", "", ""),
)
TEXTS = {
    "en": "I like $hasName very much, you know.",
    "it": "Mi {piace|piacciono} proprio tanto $hasName.",
    "ja": "私は$hasNameが本当に好きです。",
}


@dataclass(frozen=True, slots=True)
class Look:
    """One page: its name and address."""

    name: str
    address: str


def main() -> None:
    """Print a table."""
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--topics", type=int, default=3000)
    arguments.add_argument("--sentences", type=int, default=25_000)
    arguments.add_argument("--folder", type=Path)
    arguments.add_argument("--only", default="")
    chosen = arguments.parse_args()
    with _folder(chosen.folder) as folder:
        _start(folder)
        grow(chosen.topics, chosen.sentences)
        measure(chosen.only)


@contextmanager
def _folder(kept: Path | None) -> Iterator[Path]:
    if kept:
        kept.mkdir(parents=True, exist_ok=True)
        yield kept.resolve()
        return
    with tempfile.TemporaryDirectory() as folder:
        yield Path(folder)


def _start(folder: Path) -> None:
    os.environ |= {"CAIR_VAR": str(folder), "DJANGO_SETTINGS_MODULE": "cair_site.settings"}
    for name in ("DATABASE_URL", "CAIR_DEBUG"):
        os.environ.pop(name, None)
    sys.path.insert(0, str(ROOT))
    import django
    from django.conf import settings

    plain = "django.contrib.staticfiles.storage.StaticFilesStorage"
    settings.STORAGES = {**settings.STORAGES, "staticfiles": {"BACKEND": plain}}
    django.setup()
    from django.core.management import call_command

    call_command("migrate", verbosity=0)


def grow(topics: int, sentences: int) -> None:
    """Load the content where nothing is there yet, and let it grow to this size."""
    from dialogue.models import Frame, Publication, Topic
    from dialogue.publishing import publish
    from ontology_io.files.folder import read_folder
    from ontology_io.store import write_base

    if not Topic.objects.exists():
        write_base(read_folder(ROOT / "content").base)
    made = _more_topics(topics - Topic.objects.count())
    made += _more_sentences(sentences - Frame.objects.filter(topic__isnull=False).count())
    if made or not Publication.objects.exists():
        from authoring.checks.findings import check_now
        from dialogue.draft import touch_draft

        touch_draft()
        check_now()
        publish(note="As large as it gets")
    count = Frame.objects.filter(topic__isnull=False).count()
    print(f"{Topic.objects.count()} topics, {count} sentences a language\n")


def _more_topics(missing: int) -> int:
    """Add topics beside others, called like them, with keywords and likeliness."""
    from dialogue.models import Culture, KeywordSet, Topic, TopicInstance, TopicName

    if missing <= 0:
        return 0
    dice = Random(1)
    likes = list(
        Topic.objects.filter(children=None, parent__isnull=False).prefetch_related("names")
    )
    chosen = [dice.choice(likes) for _place in range(missing)]
    made = _store(
        Topic(key=f"{like.key}X{place}", parent_id=like.parent_id, position=5000 + place)
        for place, like in enumerate(chosen)
    )
    _store(
        TopicName(topic=topic, language=row.language, name=f"{row.name} {place}", fields=row.fields)
        for place, (topic, like) in enumerate(zip(made, chosen, strict=True))
        for row in like.names.all()
    )
    _store(
        KeywordSet(topic=topic, language=code, first=f"word{topic.pk}|other{topic.pk}")
        for topic in made
        for code in TEXTS
    )
    cultures = list(Culture.objects.all())
    _store(
        TopicInstance(topic=topic, culture=culture, likeliness=f"{dice.randrange(11) / 10:.1f}")
        for topic in made
        for culture in cultures
    )
    return len(made)


def _more_sentences(missing: int) -> int:
    """Add sentences, evenly over all topics and the types."""
    from dialogue.models import Frame, Sentence, Topic

    if missing <= 0:
        return 0
    rows = cycle(Topic.objects.values_list("pk", "key"))
    made = _store(
        Frame(key=f"{key}.{kind}{5000 + place}", topic_id=number, type=kind, position=5000 + place)
        for place, ((number, key), kind) in enumerate(
            zip(islice(rows, missing), cycle("qpnwc"), strict=False)
        )
    )
    _store(
        Sentence(frame=frame, language=code, text=TEXTS[code]) for frame in made for code in TEXTS
    )
    return len(made)


def _store(rows: Iterator[Any]) -> list[Any]:
    stored: list[Any] = []
    while some := list(islice(rows, 500)):
        stored += type(some[0]).objects.bulk_create(some)
    return stored


def _looks() -> Iterator[Look]:
    from django.urls import reverse

    for name, view, key, asked in PAGES:
        args = [_number(*key.split(":")) if ":" in key else key] if key else []
        yield Look(name, reverse(f"admin:{view}", args=args) + asked)


def _number(kind: str, key: str) -> int:
    """Return the number of a row of a kind by its key; that of the last release without one."""
    from dialogue.models import Frame, Publication, Topic
    from plans.models import Intent

    if kind == "release":
        return Publication.objects.values_list("pk", flat=True).latest("pk")
    if kind == "sentence of":
        return Frame.objects.filter(topic__key=key).earliest("pk").pk
    rows = Topic.objects if kind == "topic" else Intent.objects
    return rows.get(key=key).pk


def measure(only: str) -> None:
    """Measure each page as a publisher sees it."""
    from django.contrib.auth.models import Group, User
    from django.test import Client

    person, _new = User.objects.get_or_create(username="measured", defaults={"is_staff": True})
    person.groups.add(Group.objects.get(name="publisher"))
    client = Client()
    client.force_login(person)
    client.get("/admin/")  # What a worker reads once: templates, addresses, languages.
    print("| page | queries | median | | first look after a change | |")
    print("| --- | ---: | ---: | --- | ---: | --- |")
    for look in _looks():
        if only in look.name:
            _measure(client, look)


def _measure(client: "Client", look: Look) -> None:
    from django.db import connection
    from django.test.utils import CaptureQueriesContext

    _timed(client, look)
    _change()
    first = _timed(client, look)
    usual = median(_timed(client, look) for _round in range(ROUNDS))
    with CaptureQueriesContext(connection) as queries:
        _timed(client, look)
    met = _met(len(queries) <= MOST_QUERIES and usual <= MOST_MS)
    print(
        f"| {look.name} | {len(queries)} | {usual:.0f} ms | {met} "
        f"| {first:.0f} ms | {_met(first <= MOST_MS)} |",
        flush=True,
    )


def _met(holds: bool) -> str:
    return "met" if holds else "not met"


def _timed(client: "Client", look: Look) -> float:
    before = time.process_time()
    answer = client.get(look.address)
    taken = time.process_time() - before
    assert answer.status_code == 200, (look, answer.status_code)
    return taken * 1000


def _change() -> None:
    """Change one sentence, as an expert would."""
    from dialogue.models import Sentence

    row = Sentence.objects.filter(frame__topic__isnull=False, language="en").earliest("pk")
    row.text = row.text[:-2] if row.text.endswith("  ") else f"{row.text} "
    row.save()


if __name__ == "__main__":
    main()
