"""What a reader must find in the export of a knowledge base, made from its records alone."""

from collections.abc import Iterator

import msgspec

from dialogue.engine.concepts import Frame, Topic
from ontology_io.owl.file_records import Individual, OwlCulture, OwlFile, OwlIntent, OwlTopic, Said
from ontology_io.owl.line import in_line
from ontology_io.owl.names import individual_names, pattern_sequence
from ontology_io.owl.read_said import in_order
from ontology_io.owl.write_said import Context, on_individuals
from ontology_io.records import KnowledgeBase
from plans.engine.intents import Intent


def expected(base: KnowledgeBase, highest: dict[str, int]) -> OwlFile:
    """Return the facts of `base` as the reader hands them over."""
    facts = _Expected(base)
    return OwlFile(
        iri="urn:cair:kb",
        topics=tuple(sorted(facts.topics(), key=lambda row: row.key)),
        cultures=tuple(
            OwlCulture(code=row.code, names=row.names, language=row.language, order=place)
            for place, row in enumerate(base.knowledge.cultures, 1)
        ),
        pools={
            code: in_order(
                [s for place, f in enumerate(frames, 1) for s in facts.said(f, place, code)]
            )
            for code, frames in base.knowledge.pools.items()
        },
        intents=tuple(
            OwlIntent(intent=_intent(row), id=f"i{row.number}" if row.number else "", order=place)
            for place, row in enumerate(base.library.intents, 1)
        ),
        phrases=base.library.phrases,
        values=base.library.values,
        highest=highest,
        has_pools=bool(base.knowledge.pools),
        has_lists=bool(base.library.phrases or base.library.values),
    )


def _intent(row: Intent) -> Intent:
    """Return it without number, and without languages in which nothing is said."""
    kept = {
        name: {code: texts for code, texts in getattr(row, name).items() if texts}
        for name in ("triggers", "plan_sentences", "tests")
    }
    return msgspec.structs.replace(row, number=0, **kept)


class _Expected:
    def __init__(self, base: KnowledgeBase) -> None:
        self._base = base
        self._context = Context(base, "urn:cair:kb")
        self._names = individual_names(base.knowledge)
        self._intents = {row.key for row in base.library.intents}

    def topics(self) -> Iterator[OwlTopic]:
        places: dict[str, int] = {}
        for topic in in_line(self._base.knowledge.topics):
            places[topic.is_a] = places.get(topic.is_a, 0) + 1
            yield self._topic(topic, places[topic.is_a])

    def _topic(self, topic: Topic, place: int) -> OwlTopic:
        numbers = {row.key: row.number for row in self._base.knowledge.topics}
        return OwlTopic(
            key=topic.key,
            parents=tuple(sorted((topic.is_a, *topic.also))),
            id=f"t{topic.number}" if topic.number else "",
            tree_parent=topic.is_a if topic.also else "",
            order=place,
            names={code: dict(fields) for code, fields in topic.names.items() if fields},
            keywords={code: sets for code, sets in topic.keywords.items() if any(sets)},
            variables={code: texts for code, texts in topic.variables.items() if texts},
            gentle=topic.gentle,
            stop=topic.stop,
            home=topic.of,
            pattern=pattern_sequence(topic.pattern),
            note=topic.note,
            link_order=tuple(f"t{numbers[key]}" for key in topic.see if numbers.get(key)),
            said=in_order(list(self._all_said(topic))),
            individuals=tuple(self._individuals(topic)),
        )

    def _individuals(self, topic: Topic) -> Iterator[Individual]:
        for code in sorted(topic.likeliness):
            yield Individual(
                name=self._names[topic.key, code],
                culture=code,
                likeliness=topic.likeliness[code],
                links=tuple(sorted(k for k in topic.see if (k, code) in self._names)),
            )

    def _all_said(self, topic: Topic) -> Iterator[Said]:
        for place, frame in enumerate(topic.frames, 1):
            if on_individuals(frame, topic, self._context):
                for code in frame.only:
                    for row in self.said(frame, place, frame.type):
                        yield msgspec.structs.replace(row, only=(), culture=code)
            else:
                yield from self.said(frame, place, frame.type)

    def said(self, frame: Frame, place: int, kind: str) -> Iterator[Said]:
        first = frame.do.split(maxsplit=1)[0] if frame.do.strip() else ""
        for language, text in frame.texts.items():
            yield Said(
                type=kind,
                language=language,
                text=text,
                id=f"f{frame.number}.{language}" if frame.number else "",
                frame=frame.key,
                order=place,
                slot=frame.slot,
                scope=frame.scope,
                activity=frame.do,
                goal=first if first in self._intents else "",
                only=tuple(sorted(frame.only)),
            )
