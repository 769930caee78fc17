"""Scenes that claims are tried on, by what is known or asked of them."""
