"""Breakout.

Bricks, a paddle that decides the angle, five levels.
"""
