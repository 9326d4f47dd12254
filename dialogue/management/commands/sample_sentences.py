"""sample_sentences: filled sentences for a blind reading, some of each class."""

from argparse import ArgumentParser

from django.core.management.base import BaseCommand, CommandError

from dialogue.publishing import NothingPublishedError, NotPublishableError, draft, load
from dialogue.simulation.sample import sample
from languages.known import LANGUAGES


class Command(BaseCommand):
    help = "Print filled sentences, stratified by class: number, words, frame, topic, culture."

    def add_arguments(self, parser: ArgumentParser) -> None:
        parser.add_argument("--language", choices=[*LANGUAGES], default="en")
        parser.add_argument("--count", type=int, default=300)
        parser.add_argument("--seed", type=int, default=1)
        parser.add_argument("--draft", action="store_true", help="Of what is not published yet.")

    def handle(self, *args: object, **options: object) -> None:
        try:
            content = draft() if options["draft"] else load()
        except (NotPublishableError, NothingPublishedError) as error:
            raise CommandError(str(error)) from error
        count, seed = int(str(options["count"])), int(str(options["seed"]))
        found = sample(content, str(options["language"]), count, seed)
        for number, one in enumerate(found, 1):
            place = f"{one.frame}\t{one.topic}\t{one.culture}"
            self.stdout.write(f"{number}\t{one.text}\t{place}")
