"""What templates of the admin may ask for."""
