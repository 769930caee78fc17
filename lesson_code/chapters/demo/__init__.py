"""The complete demo.

Circles, a triangle and a square in a box: everything of the course at once.
"""
