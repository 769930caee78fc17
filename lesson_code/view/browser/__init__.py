"""Output and interaction in a notebook or a page."""
