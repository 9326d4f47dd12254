"""Spreadsheets of the draft: out, in, and what a sheet would change before it does."""
