"""What is written and what is missing, in numbers and charts."""
