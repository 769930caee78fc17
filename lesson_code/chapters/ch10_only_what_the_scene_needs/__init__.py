"""Only what the scene needs."""
