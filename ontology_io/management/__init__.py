"""Commands that bring knowledge in and out."""
