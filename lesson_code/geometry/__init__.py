"""Where shapes touch."""
