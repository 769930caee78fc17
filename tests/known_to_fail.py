"""The families that the default call is known not to hold: a seed, and what goes wrong there.

They are not searched by Hypothesis, as all others are. No test says that they fail: where linear
algebra rounds in another way, on another processor, the law may hold at that seed. This shows it:
`workbook measure hard-cases --replay FAMILY:SEED`.
"""

from __future__ import annotations

KNOWN_TO_FAIL: dict[str, tuple[int, str]] = {}
"""By family: the seed of a draw that fails, and the reason."""
