"""Everything visible: figures, interactive figures, the pygame window."""
