"""Pool.

A cue that gives spin, cushions with friction, six pockets.
"""
