"""The solvers of contacts, one file each, and what they share."""
