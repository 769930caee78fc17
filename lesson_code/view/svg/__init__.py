"""Scenes and runs as SVG."""
