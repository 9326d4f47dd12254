"""The tree: browsing, searching, moving a topic."""
