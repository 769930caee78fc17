"""Restitution."""
