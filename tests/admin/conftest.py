"""The draft that the tests of this folder write."""

from tests.ontology.drafts import empty_draft, small_draft, small_folder

__all__ = ["empty_draft", "small_draft", "small_folder"]
