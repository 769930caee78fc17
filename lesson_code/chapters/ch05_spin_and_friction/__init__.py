"""Spin and friction.

Compute an impact with spin and friction.
"""
