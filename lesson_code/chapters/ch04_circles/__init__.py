"""Circles.

Let discs of any mass meet at any angle.
"""
