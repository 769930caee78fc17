"""Restitution.

Predict how high and how long a ball bounces.
"""
