"""The pygame programs."""
