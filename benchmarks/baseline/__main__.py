"""python -m benchmarks.baseline hub|plan|dialogue PORT, with --data, or --plan and --dialogue."""

import argparse
import logging
from pathlib import Path

from flask import Flask

from benchmarks.baseline.data import read
from benchmarks.baseline.services import DialogueManager, Hub, PlanManager, service

PATHS = {
    "hub": "/CAIR_hub",
    "plan": "/CAIR_plan_manager",
    "dialogue": "/CAIR_dialogue_manager",
}


def _application(chosen: argparse.Namespace) -> Flask:
    path = PATHS[chosen.service]
    if chosen.service == "hub":
        return service(Hub, path, plan=chosen.plan, dialogue=chosen.dialogue)
    managers = {"plan": PlanManager, "dialogue": DialogueManager}
    return service(managers[chosen.service], path, data=read(chosen.data))


def main() -> None:
    """Serve one of the three services with Flask's development server, a thread a request."""
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("service", choices=PATHS)
    arguments.add_argument("port", type=int)
    arguments.add_argument("--data", type=Path)
    arguments.add_argument("--plan", default="")
    arguments.add_argument("--dialogue", default="")
    chosen = arguments.parse_args()
    logging.getLogger("werkzeug").setLevel(logging.ERROR)
    _application(chosen).run(host="127.0.0.1", port=chosen.port, threaded=True)


if __name__ == "__main__":
    main()
