"""simulate_talks: talks with simulated people, the bars of conversation, and transcripts."""

import time
from argparse import ArgumentParser
from collections.abc import Iterator, Mapping
from itertools import product
from pathlib import Path

from django.core.management.base import BaseCommand, CommandError

from dialogue.engine.content import Content
from dialogue.publishing import NothingPublishedError, NotPublishableError, draft, load
from dialogue.simulation.bars import Figure, Tally, figures, measured
from dialogue.simulation.talks import Cast, Exchange, Utterances, talk
from dialogue.simulation.users import USERS
from dialogue.simulation.utterances import read_utterances
from dialogue.transcripts import USER
from languages.known import LANGUAGES


class Command(BaseCommand):
    help = "Simulate talks and print how they meet the bars; the same seeds give the same talks."

    def add_arguments(self, parser: ArgumentParser) -> None:
        parser.add_argument("--turns", type=int, default=100)
        parser.add_argument("--seeds", type=int, default=2, help="Talks of each kind (default 2).")
        parser.add_argument("--first-seed", type=int, default=1)
        parser.add_argument("--users", nargs="+", choices=[*USERS], default=[*USERS])
        parser.add_argument("--cultures", nargs="+", default=[])
        parser.add_argument("--languages", nargs="+", choices=[*LANGUAGES], default=[*LANGUAGES])
        parser.add_argument("--save", type=Path, metavar="FOLDER", help="Write transcripts there.")
        parser.add_argument("--draft", action="store_true", help="Talk with what is not published.")
        parser.add_argument("--strict", action="store_true", help="Fail where a bar is not met.")

    def handle(self, *args: object, **options: object) -> None:
        try:
            content = draft() if options["draft"] else load()
        except (NotPublishableError, NothingPublishedError) as error:
            raise CommandError(str(error)) from error
        casts = list(_casts(content, options))
        turns = int(str(options["turns"]))
        tallies: dict[tuple[str, str, str], Tally] = {}
        began = time.process_time()
        for cast, exchanges in _talks(content, casts, turns):
            cell = (cast.user, cast.culture, cast.language)
            tallies.setdefault(cell, Tally()).join(measured(content, exchanges))
            if isinstance(options["save"], Path):
                _save(options["save"], cast, exchanges)
        spent = time.process_time() - began
        self.stdout.write(f"{len(casts)} talks of {turns} turns, {spent:.1f} s of CPU.")
        found = list(figures(tallies))
        for line in table(found):
            self.stdout.write(line)
        short = [figure for figure in found if not figure.met]
        if short and options["strict"]:
            raise CommandError(f"{len(short)} bars are not met.")


def _casts(content: Content, options: Mapping[str, object]) -> Iterator[Cast]:
    users, languages = options["users"], options["languages"]
    cultures = options["cultures"] or content.cultures
    first, count = int(str(options["first_seed"])), int(str(options["seeds"]))
    if not isinstance(users, list | tuple) or not isinstance(languages, list | tuple):
        raise CommandError("Name users and languages.")
    if not isinstance(cultures, list | tuple) or set(cultures) - set(content.cultures):
        raise CommandError(f"The cultures are {', '.join(content.cultures)}.")
    if first < 1 or count < 1:
        raise CommandError("Seeds are numbers from 1.")
    for user, culture, language in product(users, cultures, languages):
        for seed in range(first, first + count):
            yield Cast(user, culture, language, seed)


def _talks(
    content: Content, casts: list[Cast], turns: int
) -> Iterator[tuple[Cast, list[Exchange]]]:
    utterances: Mapping[str, Utterances] = {code: read_utterances(code) for code in LANGUAGES}
    for cast in casts:
        yield cast, list(talk(content, cast, turns, utterances))


def table(found: list[Figure]) -> Iterator[str]:
    """Yield the bars as a Markdown table."""
    yield "| bar | what | target | all talks | farthest | met |"
    yield "| --- | --- | --- | --- | --- | --- |"
    for one in found:
        bar = one.bar
        target = " and ".join(
            f"{sign} {limit:g}"
            for sign, limit in (("≥", bar.least), ("≤", bar.most))
            if limit is not None
        )
        yield (
            f"| {bar.id} | {bar.text} | {target} | {one.value:.3f} "
            f"| {one.worst_value:.3f} ({one.worst}) | {'yes' if one.met else '**no**'} |"
        )


def _save(folder: Path, cast: Cast, exchanges: list[Exchange]) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    lines = [f"{cast.language} {cast.culture} {cast.seed}", ""]
    for one in exchanges:
        lines += [f"{USER}{one.said.text}", f"agent: {one.spoken}"]
    name = f"{cast.user}-{cast.culture}-{cast.language}-{cast.seed}.txt"
    (folder / name).write_text("\n".join(lines) + "\n", encoding="utf-8")
