"""The small engine.

Put an engine together from your own functions, and test it.
"""
