"""Right answers written in unusual ways, one file a chapter: the checks must pass them all."""
