"""What an import would change in the draft, compared once a worker."""

import threading
from collections import OrderedDict

from authoring.ontology.imports import Run
from authoring.releases.release_notes import notes
from authoring.releases.releases import LARGE, Comparison, draft_snapshot
from dialogue.draft import draft_version
from dialogue.garbage import collected_later
from dialogue.models import Frame
from dialogue.snapshot import Snapshot
from ontology_io.import_runs import plan_of
from ontology_io.models import ImportRun

MOST_KEPT = 4
Key = tuple[int, str, int]
_kept: OrderedDict[Key, Comparison] = OrderedDict()
_lock = threading.Lock()


def changes(run: Run) -> Comparison:
    """Return what a run that is ready would change. Raises NotReadyError."""
    key = _key(run)
    with _lock:
        if key not in _kept:
            _kept[key] = _compared(run)
            while len(_kept) > MOST_KEPT:
                _kept.popitem(last=False)
        return _kept[key]


def takes_long(run: Run) -> bool:
    """Say whether the draft is large and this worker has not compared it yet."""
    return _key(run) not in _kept and Frame.objects.count() > LARGE


def _key(run: Run) -> Key:
    return run.number, run.started.isoformat(), draft_version()


@collected_later()
def _compared(run: Run) -> Comparison:
    plan = plan_of(ImportRun.objects.get(pk=run.number))
    new = Snapshot(knowledge=plan.base.knowledge, library=plan.base.library)
    old = draft_snapshot()
    cultures = {one.code: one for one in (*old.knowledge.cultures, *new.knowledge.cultures)}
    return Comparison(notes(old, new), tuple(cultures.values()))
