"""Two tiers of one test run: the quick one, and the full one, which ``--full`` asks for.

The quick tier makes every kind of check. What it leaves to the full tier says so where it stands:

- a test marked ``full`` runs in the full tier alone;
- of a test marked ``one_in(n)`` the quick tier runs the first case, and every n-th after it;
- what draws ``share(n)`` examples draws a third of them in the quick tier, Hypothesis included.

What is compiled costs the most: 10 to 30 s a program. The quick tier compiles one of each kind.
"""

from __future__ import annotations

from collections import Counter

import pytest

SHARE = 3
"""The quick tier draws one of this many examples."""

_is_full = False


def choose(*, full: bool) -> None:
    """Choose the tier, before any test is imported."""
    global _is_full
    _is_full = full


def share(count: int, one_in: int = SHARE) -> int:
    """Return how many of a number of examples this tier draws: at least one."""
    return count if _is_full else max(count // one_in, 1)


def left_out(items: list[pytest.Item]) -> list[pytest.Item]:
    """Return the tests that this tier leaves to the full one."""
    cases: Counter[str] = Counter()
    left = []
    for item in items:
        test = item.nodeid.partition("[")[0]
        one_in = item.get_closest_marker("one_in")
        is_one = one_in is None or cases[test] % one_in.args[0] == 0
        cases[test] += 1
        if item.get_closest_marker("full") or not is_one:
            left.append(item)
    return [] if _is_full else left
