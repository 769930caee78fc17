"""The families that the default call is known not to hold: a seed, and what goes wrong there.

Each is a strict expected failure: when its law holds at that seed, its line has to go. The families
that are not in this list are searched by Hypothesis.
"""

from __future__ import annotations

KNOWN_TO_FAIL: dict[str, tuple[int, str]] = {
    "bodies-in-one-place": (50078, "the ways out of a heap block each other, and an overlap stays"),
}
"""By family: the seed of a draw that fails, and the reason."""
