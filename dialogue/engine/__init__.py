"""The pure Dialogue Manager: it knows no Django."""
