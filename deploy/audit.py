"""`make audit`: known vulnerabilities of what we install; skipped where nobody can be asked.

pip-audit calls a package that the service does not know "skipped" and succeeds: where it has
looked at no package at all, nothing was audited, and this says so.
"""

import json
import subprocess
import sys
from typing import Any

UNREACHABLE = ("ConnectionError", "NameResolutionError", "ServiceError", "Timeout", "ProxyError")
SECONDS = 180


def main(requirements: list[str]) -> int:
    """Audit what is installed, or files of requirements; 0 where nothing is known against it."""
    command = [sys.executable, "-m", "pip_audit", "--format", "json", "--progress-spinner", "off"]
    command += ["--no-deps", "--disable-pip"] if requirements else ["--local"]
    for name in requirements:
        command += ["--requirement", name]
    try:
        done = subprocess.run(  # noqa: S603 - our own words
            command, capture_output=True, text=True, check=False, timeout=SECONDS
        )
    except subprocess.TimeoutExpired:
        return _say(f"Audit skipped: no answer within {SECONDS} seconds.", 0)
    return judged(done.stdout, done.stderr)


def judged(printed: str, trouble: str) -> int:
    """Say what pip-audit found, and return how this ends."""
    try:
        found: list[dict[str, Any]] = json.loads(printed)["dependencies"]
    except (ValueError, KeyError):
        last = (trouble.strip().splitlines() or ["no word"])[-1][:300]
        if any(word in trouble for word in UNREACHABLE):
            return _say(f"Audit skipped: the service cannot be reached ({last}).", 0)
        return _say(f"The audit broke: {last}", 2)
    looked_at = [one for one in found if "skip_reason" not in one]
    if not looked_at:
        return _say("Audit skipped: the service knows none of our packages from here.", 0)
    for one in found:
        if "skip_reason" in one:
            _say(f"Not audited: {one['name']}: {one['skip_reason']}", 0)
    bad = [one for one in looked_at if one["vulns"]]
    for one in bad:
        for fault in one["vulns"]:
            mended = ", ".join(fault["fix_versions"]) or "no version yet"
            _say(f"{one['name']} {one['version']}: {fault['id']}, mended in {mended}", 1)
    return _say(f"{len(looked_at)} packages audited, {len(bad)} with known faults.", int(bool(bad)))


def _say(text: str, code: int) -> int:
    sys.stdout.write(f"{text}\n")
    return code


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
