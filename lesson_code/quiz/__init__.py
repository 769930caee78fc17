"""One bank of questions, one checker."""
