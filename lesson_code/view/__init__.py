"""What is seen: figures, interactive figures, the pygame window."""
