"""Commands of the authoring admin."""
