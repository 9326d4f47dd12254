"""How well and how fast intents are matched, beside hassil on identical templates."""
