"""Django's backend of PostgreSQL, with two habits of ours."""
