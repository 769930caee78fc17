"""Hard cases."""
