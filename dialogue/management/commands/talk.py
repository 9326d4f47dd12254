"""talk: a conversation in the terminal, or the transcripts told again."""

from argparse import ArgumentParser
from pathlib import Path

from django.core.management.base import BaseCommand, CommandError

from dialogue.engine.content import Content
from dialogue.publishing import NothingPublishedError, NotPublishableError, draft, load
from dialogue.transcripts import retell
from dialogue.turns import UnknownChoiceError, first_turn, take_turn


class Command(BaseCommand):
    help = "Talk with the agent; an empty line ends the talk."

    def add_arguments(self, parser: ArgumentParser) -> None:
        parser.add_argument("--language", default="en")
        parser.add_argument("--culture", default="")
        parser.add_argument("--seed", type=int, default=0)
        parser.add_argument("--explain", action="store_true", help="Show why each reply was said.")
        parser.add_argument("--draft", action="store_true", help="Talk with what is not published.")
        parser.add_argument("--transcripts", type=Path, metavar="FOLDER")

    def handle(self, *args: object, **options: object) -> None:
        try:
            content = draft() if options["draft"] else load()
        except (NotPublishableError, NothingPublishedError) as error:
            raise CommandError(str(error)) from error
        folder = options["transcripts"]
        if isinstance(folder, Path):
            for file in sorted(folder.glob("*.txt")):
                text = file.read_text(encoding="utf-8")
                file.write_text(retell(content, text), encoding="utf-8")
            return
        self._talk(content, options)

    def _talk(self, content: Content, options: dict[str, object]) -> None:
        language, culture = str(options["language"]), str(options["culture"])
        try:
            said = first_turn(content, language, culture, int(str(options["seed"])))
        except UnknownChoiceError as error:
            raise CommandError(f"{error} {error.hint}") from error
        self.stdout.write(f"agent: {said.sentence}")
        while sentence := _heard():
            taken = take_turn(content, said.state, sentence, explain=bool(options["explain"]))
            said = taken.reply
            if taken.plan.plan:
                self.stdout.write(f"plan:  {taken.plan.plan}")
            for step in said.steps:
                self.stdout.write(f"       {step.rule}: {step.text}")
            spoken = " ".join(filter(None, (taken.plan.plan_sentence, said.sentence)))
            self.stdout.write(f"agent: {spoken}")


def _heard() -> str:
    try:
        return input("you:   ").strip()
    except EOFError:
        return ""
