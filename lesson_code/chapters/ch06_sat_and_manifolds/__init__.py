"""SAT and manifolds.

Find where polygons touch, and stack them.
"""
