"""Who changed what, taking it back, and two people at one row."""
