"""Commands of the Dialogue Manager."""
