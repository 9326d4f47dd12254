"""The test chat and the conversations that are kept as tests."""
