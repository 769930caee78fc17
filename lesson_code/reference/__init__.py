"""Answers that are not ours: closed forms, and pymunk."""
