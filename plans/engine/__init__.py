"""The pure Plan Manager: trigger sentences, matching and plans, without Django."""
