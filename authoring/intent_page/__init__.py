"""The page of an intent: its form, what is checked while it is written, trying sentences."""
