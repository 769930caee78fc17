"""Everything visible: figures, live figures, the pygame window."""
