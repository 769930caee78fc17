"""The tasks, one file a chapter: criteria, seeded inputs, and the expected answers."""
