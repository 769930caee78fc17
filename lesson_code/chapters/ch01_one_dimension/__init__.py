"""One dimension."""
