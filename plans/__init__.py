"""The Plan Manager: it finds what the person asked for."""
