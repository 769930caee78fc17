"""Time of impact.

Find when bodies meet, and go from collision to collision.
"""
