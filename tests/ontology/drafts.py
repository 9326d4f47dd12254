"""Fixtures of tests that write the draft: an empty one, and one with the small content."""

from pathlib import Path

import pytest
from django.apps import apps
from django.db import connection, transaction

from ontology_io.files.folder import Folder, read_folder
from ontology_io.store import write_base
from tests.ontology.small_content import write_files


@pytest.fixture
def small_folder(tmp_path: Path) -> Path:
    """Return a folder with the small content."""
    folder = tmp_path / "content"
    folder.mkdir()
    return write_files(folder)


@pytest.fixture
def empty_draft(db: None) -> None:
    """Empty the tables (another test may have loaded the shipped content for its whole session)."""
    tables = [
        model._meta.db_table
        for app in ("dialogue", "plans")
        for model in apps.get_app_config(app).get_models(include_auto_created=True)
    ]
    # Within one transaction, so that the order of the tables does not matter.
    with transaction.atomic(), connection.cursor() as cursor:
        cursor.execute("PRAGMA defer_foreign_keys = ON")
        for table in tables:
            cursor.execute(f'DELETE FROM "{table}"')  # noqa: S608 - names of our own tables
            cursor.execute("DELETE FROM sqlite_sequence WHERE name = %s", [table])


@pytest.fixture
def small_draft(empty_draft: None, small_folder: Path) -> Folder:
    """Load the small content into the draft; return what was read."""
    folder = read_folder(small_folder)
    write_base(folder.base, folder.last)
    return folder
