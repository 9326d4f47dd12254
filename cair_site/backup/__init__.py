"""The content of a database as one file: written from, and brought back into, either kind."""
