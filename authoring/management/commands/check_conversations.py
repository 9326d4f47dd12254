"""check_conversations: have the regression conversations again and tell which do not hold."""

from argparse import ArgumentParser

from django.core.management.base import BaseCommand, CommandError

from authoring.chat.conversations import Result, run_all
from dialogue.publishing import NothingPublishedError, NotPublishableError, draft, load
from dialogue.snapshot import SnapshotError


class Command(BaseCommand):
    help = "Have all regression conversations again, on the draft or on a release."

    def add_arguments(self, parser: ArgumentParser) -> None:
        where = parser.add_mutually_exclusive_group()
        where.add_argument("--published", action="store_true", help="On the newest release.")
        where.add_argument("--release", type=int, metavar="NUMBER", help="On that release.")
        parser.add_argument("--write", action="store_true", help="Note the results in the admin.")

    def handle(self, *args: object, **options: object) -> None:
        number = options["release"]
        try:
            if isinstance(number, int):
                content = load(number)
            else:
                content = load() if options["published"] else draft()
        except (NotPublishableError, NothingPublishedError, SnapshotError) as error:
            raise CommandError(str(error)) from error
        results = run_all(content, write=bool(options["write"]))
        failed = [one for one in results if not one.passed]
        for one in failed:
            self._tell(one)
        if failed:
            raise CommandError(f"{len(failed)} of {len(results)} conversations do not hold.")
        self.stdout.write(f"All {len(results)} conversations hold.")

    def _tell(self, result: Result) -> None:
        self.stdout.write(f"{result.id} {result.title}: {result.reason}")
        for place, turn in enumerate(result.turns):
            if not turn.passed:
                self.stdout.write(f"  {place}. {turn.heard!r}: {turn.reason}")
                for name, said in (("before", turn.before), ("now", turn.now)):
                    text = " ".join(filter(None, (said.plan, said.plan_sentence, said.sentence)))
                    self.stdout.write(f"     {name}: {text}")
