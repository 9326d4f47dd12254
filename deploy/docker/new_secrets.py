"""Makes the secrets of a new service, one file each: `python3 deploy/docker/new_secrets.py FOLDER`.

Files that exist stay as they are. Needs nothing but Python's standard library.

The folder is open to its owner alone. The files in it are readable, because Compose shows them to
the users of the containers with the rights that they have here.
"""

import secrets
import sys
from argparse import ArgumentParser
from pathlib import Path

KEYS = ("secret_keys", "state_keys")
IN_COMPOSE = "postgresql://cair:{password}@db:5432/cair"


def write(path: Path, value: str) -> None:
    """Write a secret, where none is."""
    try:
        with path.open("x", encoding="ascii") as file:
            file.write(f"{value}\n")
    except FileExistsError:
        sys.stdout.write(f"{path} stays as it is.\n")
        return
    path.chmod(0o644)
    sys.stdout.write(f"{path} is new.\n")


def add_key(path: Path) -> None:
    """Put a new key last: what it signs is read, the first one signs."""
    _replace(path, [*_keys(path), secrets.token_urlsafe(48)])


def use_key(path: Path) -> None:
    """Put the last key first: it signs from now on."""
    *others, last = _keys(path)
    _replace(path, [last, *others])


def _keys(path: Path) -> list[str]:
    return path.read_text(encoding="ascii").strip().split(",")


def _replace(path: Path, keys: list[str]) -> None:
    """Write in place: Compose shows a container the file that it was given, not one of its name."""
    path.write_text(",".join(keys) + "\n", encoding="ascii")
    sys.stdout.write(f"{path} has {len(keys)} keys.\n")


def main() -> None:
    """Make what is missing."""
    parser = ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--database-url", default="", help="of a PostgreSQL elsewhere")
    parser.add_argument("--add-key", choices=KEYS, help="a new last key, which only reads yet")
    parser.add_argument("--use-key", choices=KEYS, help="let the last key sign: put it first")
    options = parser.parse_args()
    folder: Path = options.folder
    folder.mkdir(parents=True, exist_ok=True)
    folder.chmod(0o700)
    if options.add_key or options.use_key:
        change = add_key if options.add_key else use_key
        change(folder / (options.add_key or options.use_key))
        return
    for name in (*KEYS, "metrics_token"):
        write(folder / name, secrets.token_urlsafe(48))
    if options.database_url:
        write(folder / "database_url", options.database_url)
        return
    write(folder / "postgres_password", secrets.token_urlsafe(32))
    password = (folder / "postgres_password").read_text(encoding="ascii").strip()
    write(folder / "database_url", IN_COMPOSE.format(password=password))


if __name__ == "__main__":
    main()
