"""Notebooks made from their sources, student copies, runs under nbval."""
