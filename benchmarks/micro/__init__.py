"""What each part of a turn costs, as a ratio to a fixed piece of work measured beside it."""
