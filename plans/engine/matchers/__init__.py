"""Ways of matching a sentence; known.py lists them."""
