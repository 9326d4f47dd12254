"""Atheris on the readers of strangers' data: `python -m tests.fuzz.coverage_guided codec`.

After the name of a target come libFuzzer's own arguments, `-max_total_time=60` say. What is found
stays in var/fuzz/<target>/ as crash-*, and what was learned as its corpus.
"""

import os
import sys
from pathlib import Path

import atheris
import django

INSTRUMENTED = ["dialogue", "plans", "languages", "ontology_io", "cair_site.messages"]
os.environ.setdefault("DJANGO_SETTINGS_MODULE", "cair_site.settings")
with atheris.instrument_imports(include=INSTRUMENTED):
    django.setup()
    from tests.fuzz import seeds, targets

TARGETS = {
    "state": (targets.state_text, seeds.STATES, ()),
    "codec": (targets.signed_state, seeds.SIGNED, ()),
    "trigger": (targets.trigger, seeds.TRIGGERS, seeds.TRIGGER_WORDS),
    "library": (targets.library, seeds.TRIGGERS, seeds.TRIGGER_WORDS),
    "body": (targets.body, seeds.BODIES, seeds.JSON_WORDS),
    "owl": (targets.owl, seeds.FILES, seeds.XML_WORDS),
}


def main(name: str, arguments: list[str]) -> None:
    """Fuzz one target until libFuzzer's arguments say enough."""
    target, begin, words = TARGETS[name]
    folder = Path(os.environ.get("CAIR_VAR", "var"), "fuzz", name)
    corpus, dictionary = folder / "corpus", folder / "words"
    corpus.mkdir(parents=True, exist_ok=True)
    for number, seed in enumerate(begin):
        (corpus / f"seed{number}").write_bytes(seed)
    escaped = ("".join(f"\\x{byte:02x}" for byte in word.encode()) for word in words)
    dictionary.write_text("".join(f'"{word}"\n' for word in escaped))
    ours = ["-max_len=5000", "-timeout=20", f"-artifact_prefix={folder}/"]
    ours += [f"-dict={dictionary}"] if words else []
    atheris.Setup([sys.argv[0], *ours, *arguments, str(corpus)], target)
    atheris.Fuzz()


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
