"""Settings from the environment: a wrong value stops the start and says its name."""

import os
import re
import secrets
import tempfile
from collections.abc import Sequence
from ipaddress import IPv4Network, IPv6Network, ip_network
from pathlib import Path
from urllib.parse import urlsplit

from django.core.exceptions import ImproperlyConfigured

_IRI = re.compile(
    r"[A-Za-z][A-Za-z0-9+.-]*:(?:[A-Za-z0-9._~:/?@!$&'()*+,;=-]|%[0-9A-Fa-f]{2}){1,200}"
)
_TAKEN_IRIS = (
    "urn:cair:vocab",
    "http://www.w3.org/",
    "http://caressesrobot.org/ontology",
    "http://www.lesfleursdunormal.fr/",
)


def text(name: str, default: str = "") -> str:
    """Return a variable; `NAME_FILE` may name a file that holds it (for secrets)."""
    path = os.environ.get(f"{name}_FILE")
    if path:
        try:
            return Path(path).read_text(encoding="utf-8").strip()
        except OSError as error:
            raise ImproperlyConfigured(f"{name}_FILE: cannot read {path}: {error}.") from error
    return os.environ.get(name, default).strip()


def number(name: str, default: int, *, least: int = 0, most: int = 2**40) -> int:
    """Return a whole number within limits."""
    value = text(name, str(default))
    if not value.isdecimal() or not least <= int(value) <= most:
        raise ImproperlyConfigured(f"{name} is {value!r}; give a whole number {least}..{most}.")
    return int(value)


def flag(name: str, *, default: bool = False) -> bool:
    """Return a yes or no."""
    value = text(name, "yes" if default else "no").lower()
    if value not in {"yes", "no", "true", "false", "1", "0"}:
        raise ImproperlyConfigured(f"{name} is {value!r}; give yes or no.")
    return value in {"yes", "true", "1"}


def choice(name: str, known: Sequence[str]) -> str:
    """Return one of the known words, the first where nothing is set."""
    value = text(name, known[0]).upper()
    if value not in known:
        raise ImproperlyConfigured(f"{name} is {value!r}; give one of {', '.join(known)}.")
    return value


def words(name: str, default: str = "") -> list[str]:
    """Return a comma-separated list."""
    return [word.strip() for word in text(name, default).split(",") if word.strip()]


def networks(name: str) -> list[IPv4Network | IPv6Network]:
    """Return a comma-separated list of addresses and networks: 10.0.0.0/8, 127.0.0.1."""
    try:
        return [ip_network(word) for word in words(name)]
    except ValueError as error:
        raise ImproperlyConfigured(f"{name}: {error}; give e.g. 127.0.0.1,10.0.0.0/8.") from error


def ontology_iri(name: str, default: str) -> str:
    """Return an absolute IRI that names an ontology: its contents are this IRI, # and a name."""
    value = text(name, default)
    parts = urlsplit(value)
    whole = _IRI.fullmatch(value) and (parts.netloc or parts.scheme not in {"http", "https"})
    if not whole or value.endswith(("/", ":")):
        raise ImproperlyConfigured(
            f"{name} is {value!r}; give an absolute IRI without # and without / at its end, "
            "e.g. https://cair.example/kb or urn:example:kb."
        )
    if value.startswith(_TAKEN_IRIS):
        raise ImproperlyConfigured(f"{name} is {value!r}, which names a vocabulary; give your own.")
    return value


def secret(name: str, var: Path) -> str:
    """Return a secret from the environment, else one made once and kept in `var` for its owner."""
    given = text(name)
    if given:
        return given
    path = var / name.lower()
    try:
        var.mkdir(parents=True, exist_ok=True, mode=0o700)
        if not path.exists():
            _write_once(path, secrets.token_urlsafe(48))
    except OSError as error:
        raise ImproperlyConfigured(
            f"{name} is not set and {var} cannot be written: {error}. Set {name} or CAIR_VAR."
        ) from error
    return path.read_text(encoding="ascii")


def _write_once(path: Path, content: str) -> None:
    """Write a file of its owner alone, whole or not at all; the first of several writers wins."""
    number, name = tempfile.mkstemp(dir=path.parent)
    try:
        with open(number, "w", encoding="ascii") as file:
            file.write(content)
        os.link(name, path)
    except FileExistsError:
        pass
    finally:
        os.unlink(name)
