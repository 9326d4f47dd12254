"""Publishing as people see it: one at a time, step by step, with a status all workers can read."""

import logging
import threading
from collections.abc import Collection
from datetime import timedelta

from django.db import IntegrityError, connection, transaction
from django.utils import timezone

from authoring.checks import findings
from authoring.models import PublishRun
from authoring.releases.regressions import Failing, failing_conversations
from dialogue import publishing
from dialogue.engine.content import Content
from dialogue.models import Publication

logger = logging.getLogger(__name__)

#: How a run ends: published, nothing new, errors, conversations to look at, the draft has changed
#: meanwhile, an unforeseen error, its worker is gone.
DONE, SAME, REFUSED, LOOK, CHANGED, FAILED, LOST = ENDS = (
    "done",
    "same",
    "refused",
    "look",
    "changed",
    "failed",
    "lost",
)
#: A run of which nothing is heard for so long has lost its worker.
LOST_AFTER = timedelta(minutes=3)


class BusyError(RuntimeError):
    """Somebody is publishing; `run` says who and since when."""

    def __init__(self, run: PublishRun | None) -> None:
        super().__init__("Somebody is publishing.")
        self.run = run


class _LookFirstError(RuntimeError):
    def __init__(self, failing: list[Failing]) -> None:
        super().__init__("Conversations go another way now.")
        self.failing = failing


def running() -> PublishRun | None:
    """Return the run that is going on; one query."""
    oldest = timezone.now() - LOST_AFTER
    row = PublishRun.objects.select_related("author").filter(running=True).first()
    return row if row and row.beat >= oldest else None


def last_run() -> PublishRun | None:
    """Return the last run that has ended."""
    return PublishRun.objects.select_related("author").filter(running=None).first()


def begin(author: int | None, note: str, draft: int) -> PublishRun:
    """Start a run for the draft of this version. Raises BusyError where another one is going on."""
    oldest = timezone.now() - LOST_AFTER
    PublishRun.objects.filter(running=True, beat__lt=oldest).update(running=None, step=LOST)
    try:
        with transaction.atomic():
            return PublishRun.objects.create(
                running=True, author_id=author, note=note, draft=draft, step=publishing.STEPS[0]
            )
    except IntegrityError as error:
        raise BusyError(running()) from error


class _Watch(publishing.Watch):
    """Writes each step to the run, and stops for conversations that nobody has looked at."""

    def __init__(self, run: PublishRun, seen: Collection[int]) -> None:
        self.run, self.seen = run, seen

    def step(self, name: str) -> None:
        """Write the step; a run that was given up meanwhile ends here."""
        rows = PublishRun.objects.filter(pk=self.run.pk, running=True)
        if not rows.update(step=name, beat=timezone.now()):
            raise publishing.DraftChangedError

    def built(self, content: Content) -> None:
        """Run the regression conversations."""
        failing = failing_conversations(content)
        if not {one.number for one in failing} <= {*self.seen}:
            raise _LookFirstError(failing)


def carry_out(run: PublishRun, seen: Collection[int] = ()) -> PublishRun:
    """Publish, and return how the run ended; `seen` are conversations that may go another way."""
    before = Publication.objects.values_list("pk", flat=True).first()
    problems: list[object] = []
    row = None
    try:
        row = publishing.publish(
            note=run.note, author=run.author_id, expected=run.draft, watch=_Watch(run, seen)
        )
        step = SAME if row.pk == before else DONE
    except publishing.NotPublishableError:
        findings.check_now()
        step = REFUSED
    except _LookFirstError as error:
        step = LOOK
        problems = [[one.number, one.title, one.reason] for one in error.failing]
    except publishing.DraftChangedError:
        step = CHANGED
    except Exception:
        logger.exception("Publishing failed.")
        step = FAILED
    return _end(run, step, problems, row)


def _end(run: PublishRun, step: str, problems: list[object], row: Publication | None) -> PublishRun:
    run.running, run.step, run.problems, run.publication = None, step, problems, row
    run.save(update_fields=["running", "step", "problems", "publication", "beat"])
    return run


def start(run: PublishRun, seen: Collection[int] = ()) -> None:
    """Publish in a thread of its own; the run tells how it goes on."""
    threading.Thread(target=_work, args=(run, seen), name="publishing").start()


def _work(run: PublishRun, seen: Collection[int]) -> None:
    try:
        carry_out(run, seen)
    finally:
        connection.close()
