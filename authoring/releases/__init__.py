"""Publishing the draft, and what a release changed."""
