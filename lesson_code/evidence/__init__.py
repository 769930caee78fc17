"""Compare claims with measurements."""

from lesson_code.evidence.check import CheckFailedError, check, check_bound

__all__ = ["CheckFailedError", "check", "check_bound"]
