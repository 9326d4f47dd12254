"""The engines and the languages work where Django, DRF and owlready2 cannot be imported."""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
IMPORT_ALL = """
import sys
for name in ("django", "rest_framework", "owlready2"):
    sys.modules[name] = None
import importlib, pkgutil
names = []
for package in ("languages", "plans.engine", "dialogue.engine"):
    path = importlib.import_module(package).__path__
    names += [found.name for found in pkgutil.walk_packages(path, package + ".")]
for name in names:
    importlib.import_module(name)
print(len(names))
"""


def test_every_module_of_the_engines_can_be_imported_without_django():
    done = subprocess.run(
        [sys.executable, "-c", IMPORT_ALL],
        cwd=ROOT,
        env={"PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert int(done.stdout) > 60
