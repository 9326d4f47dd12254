"""What a turn, a state, loading and memory cost as content and talks grow."""
