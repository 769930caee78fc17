"""Spin and friction."""
