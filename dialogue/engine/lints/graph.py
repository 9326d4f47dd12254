"""The largest set of nodes in which each can be reached from each (Kosaraju)."""

from collections.abc import Collection, Mapping


def reachable_together(
    edges: Mapping[int, Collection[int]], counted: Collection[int]
) -> frozenset[int]:
    """Return the strongly connected component that holds most of the counted nodes."""
    backwards: dict[int, list[int]] = {number: [] for number in edges}
    for number, others in edges.items():
        for other in others:
            if other in backwards:
                backwards[other].append(number)
    seen: set[int] = set()
    order: list[int] = []
    for number in edges:
        order += _finished(number, edges, seen)
    seen.clear()
    components = [frozenset(_finished(number, backwards, seen)) for number in reversed(order)]
    wanted = frozenset(counted)
    return max(components, key=lambda component: len(component & wanted), default=frozenset())


def _finished(start: int, edges: Mapping[int, Collection[int]], seen: set[int]) -> list[int]:
    """Return what can be reached and was not seen, each after all that it leads to."""
    if start in seen:
        return []
    seen.add(start)
    done: list[int] = []
    path = [(start, iter(edges[start]))]
    while path:
        number, others = path[-1]
        following = next((other for other in others if other in edges and other not in seen), None)
        if following is None:
            path.pop()
            done.append(number)
        else:
            seen.add(following)
            path.append((following, iter(edges[following])))
    return done
