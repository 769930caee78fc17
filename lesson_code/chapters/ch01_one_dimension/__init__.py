"""One dimension.

Compute any collision on a line.
"""
