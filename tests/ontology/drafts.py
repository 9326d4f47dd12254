"""Fixtures of tests that write the draft: an empty one, and one with the small content."""

from pathlib import Path

import pytest

from ontology_io.files.folder import Folder, read_folder
from ontology_io.store import write_base
from tests.ontology.emptying import empty_apps
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
    empty_apps("dialogue", "plans")


@pytest.fixture
def small_draft(empty_draft: None, small_folder: Path) -> Folder:
    """Load the small content into the draft; return what was read."""
    folder = read_folder(small_folder)
    write_base(folder.base, folder.last)
    return folder
