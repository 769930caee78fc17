"""Cushion-bounce billiards.

One ball, four cushions, a bumper at 45 degrees.
"""
