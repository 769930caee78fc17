"""Scenes for testing claims, grouped by what is known about them."""
