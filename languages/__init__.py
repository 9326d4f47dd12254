"""What the service knows about the languages it speaks; no Django, no database, values only."""
