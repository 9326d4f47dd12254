"""What concerns one person is never taken: those individuals are left out, and counted."""

from ontology_io.owl.facts import Facts, Node, Value


def drop_persons(facts: Facts) -> int:
    """Remove the individuals of persons with all that is said about them; return how many."""
    persons = {node for node in facts.typed("User") if not facts.term(node)}
    for node, rows in facts.nodes.items():
        if "concernsUser" in rows:
            persons.add(node)
            persons.update(value for value in rows["concernsUser"] if isinstance(value, int))
        persons.update(value for value in rows.get("hasSpecific", ()) if isinstance(value, int))
    persons = {node for node in persons if not facts.term(node)}
    if persons:
        _drop(facts, persons)
    return len(persons)


def _drop(facts: Facts, persons: set[Node]) -> None:
    for node in _with_axioms(facts, persons):
        facts.nodes.pop(node, None)
        facts.forget(node)
    for rows in facts.nodes.values():
        for key in tuple(rows):
            if any(_person(value, persons) for value in rows[key]):
                rows[key] = tuple(value for value in rows[key] if not _person(value, persons))
                if not rows[key]:
                    del rows[key]


def _with_axioms(facts: Facts, persons: set[Node]) -> set[Node]:
    """Return the persons and the axioms about them."""
    found = set(persons)
    for node, rows in facts.nodes.items():
        about = [*rows.get("owl:annotatedSource", ()), *rows.get("owl:annotatedTarget", ())]
        if any(_person(value, persons) for value in about):
            found.add(node)
    return found


def _person(value: Value, persons: set[Node]) -> bool:
    return isinstance(value, int) and value in persons
