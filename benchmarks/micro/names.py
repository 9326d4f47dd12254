"""The names of figures that more than one module knows."""

from benchmarks.micro.works import ECHO_LARGEST, ECHO_SMALLEST, WORKS

FIGURES = "figures"
START = "start to first answer"
START_CPU = "start to first answer, processor"
SHARED = "memory a worker shares"
OWN = "memory a worker has for itself"
WORKER = "memory of a worker, proportional"
MASTER = "memory of the master, proportional"
PROCESSES = (START, START_CPU, SHARED, OWN, WORKER, MASTER)


def all_names() -> tuple[str, ...]:
    """Return the name of every figure there is."""
    return (*WORKS, ECHO_SMALLEST, ECHO_LARGEST, *PROCESSES)
