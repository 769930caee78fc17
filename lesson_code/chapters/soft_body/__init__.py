"""Soft body.

Rings of masses and springs that deform where they collide.
"""
