"""Where a finding belongs: the row to edit and the branch it stands in."""

from dialogue.engine.tree_order import branches
from dialogue.snapshot import Snapshot
from plans.models import Phrase, ValueList

#: Branch, model of the row, number of the row.
Place = tuple[str, str, int]
NOWHERE: Place = ("", "", 0)


class Places:
    """The places of all keys of a knowledge base; two queries, for phrases and value lists."""

    def __init__(self, snapshot: Snapshot) -> None:
        knowledge, library = snapshot.knowledge, snapshot.library
        branch_of = branches(knowledge.topics)
        self._places: dict[str, Place] = {}
        for key, number in Phrase.objects.values_list("key", "pk"):
            self._places[key] = ("", "plans.phrase", number)
        for key, number in ValueList.objects.values_list("key", "pk"):
            self._places[key] = ("", "plans.valuelist", number)
        for intent in library.intents:
            self._places[intent.key] = ("", "plans.intent", intent.number)
        for frames in knowledge.pools.values():
            for frame in frames:
                self._places[frame.key] = ("", "dialogue.frame", frame.number)
        for topic in knowledge.topics:
            branch = branch_of.get(topic.key, "")
            self._places[topic.key] = (branch, "dialogue.topic", topic.number)
            for frame in topic.frames:
                self._places[frame.key] = (branch, "dialogue.frame", frame.number)

    def of(self, key: str) -> Place:
        """Return the place of a key; a problem of an intent may name its part after a blank."""
        return self._places.get(key) or self._places.get(key.partition(" ")[0], NOWHERE)
