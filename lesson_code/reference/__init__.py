"""Answers that are not ours: closed forms, pymunk and Box2D."""
