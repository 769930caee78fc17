"""The small engine."""
