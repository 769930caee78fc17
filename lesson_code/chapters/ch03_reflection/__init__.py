"""Reflection.

Bounce a ball off any wall.
"""
