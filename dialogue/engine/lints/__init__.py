"""The quality bars of content that a machine can check: advice, never a reason not to publish."""
