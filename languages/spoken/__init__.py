"""Numbers, lengths of time, clock times and days as people say them, one file per language."""
