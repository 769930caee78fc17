"""Dominoes.

A chain that branches: on along the floor, and up onto a shelf.
"""
