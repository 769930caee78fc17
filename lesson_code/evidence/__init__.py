"""Compare claims with measurements."""

from lesson_code.evidence.check import CheckFailedError, check

__all__ = ["CheckFailedError", "check"]
