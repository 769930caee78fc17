"""Pool.

Eight-ball: a cue that gives spin, cushions with friction, six pockets.
"""
