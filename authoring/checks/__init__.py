"""What the checks find, in words, with the row to mend."""
