"""Claims compared with what was measured."""

from lesson_code.evidence.check import CheckFailedError, check

__all__ = ["CheckFailedError", "check"]
