"""cair-chat: a talk with a CAIR server in the terminal, with what a robot would do."""
