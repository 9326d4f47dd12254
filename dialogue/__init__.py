"""The Dialogue Manager: it decides what the agent says next."""
