"""The families that the default call is known not to hold: a seed, and what goes wrong there.

Each is a strict expected failure: when its law holds at that seed, its line has to go. The families
that are not in this list are searched by Hypothesis.
"""

from __future__ import annotations

KNOWN_TO_FAIL: dict[str, tuple[int, str]] = {
    "moving-frame": (0, "the bodies of a fast train count as fast, and their steps end elsewhere"),
    "nearly-straight-sides": (
        5001,
        "the contact changes from one half of a side to the other, for ever",
    ),
    "sunk-in-the-floor": (0, "a body that comes out of the floor bounces"),
}
"""By family: the seed of a draw that fails, and the reason."""
