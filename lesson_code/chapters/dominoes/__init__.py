"""Dominoes.

A chain that branches, and how fast its wave runs at which spacing.
"""
