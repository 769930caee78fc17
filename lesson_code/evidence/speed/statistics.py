"""From measured times to what is said of them: medians, ratios, growth, and equal quality."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from lesson_code.engine.core.constants import SLOP

ALIKE = 1.25
"""Two qualities are alike up to this factor. What is deepest in a gas is a draw of its own: from
one batch to the next it differs by as much."""

OVERLAP_LEFT_ALONE = 1.5 * SLOP
"""Of a body's width: every engine here leaves the slop alone, and what is little deeper."""

ENERGY_LEFT_ALONE = {"drift": 1e-3, "left": 1e-5}
"""Smaller errors in energy are none. What is left in a pile is so little at 0.014 m/s, for bodies
1 m wide."""


LEAST_ORDER = 0.5
"""Errors that fall more slowly with the time step are not extrapolated: chaos has the word."""

MOST_DRIFT = 0.1
"""A gas that has lost more of its energy is another one: it overlaps less, for it hardly moves."""


@dataclass(frozen=True)
class Quality:
    """How well a scene was simulated.

    Attributes
    ----------
    overlap : float
        The deepest overlap, as a share of the smaller body's width, >= 0: median over the ends of
        all batches.
    energy_error : float
        >= 0. "drift": by what share the energy of a gas has changed. "left": kinetic energy in
        a pile, over what would lift it by the smallest width.
    energy_kind : str
        "drift" or "left".
    """

    overlap: float
    energy_error: float
    energy_kind: str


def growth_exponent(sizes: Sequence[float], seconds: Sequence[float]) -> float:
    """Return p where the time grows as size^p: the slope of a line through ln time over ln size.

    Examples
    --------
    Ten times as many bodies take 100 times as long.

    >>> round(growth_exponent([10, 100, 1000], [2.0, 200.0, 20000.0]), 12)
    2.0
    """
    if len(set(sizes)) < 2:
        raise ValueError(f"sizes must be two different ones at least, got {list(sizes)}")
    slope, _ = np.polyfit(np.log(sizes), np.log(seconds), 1)
    return float(slope)


def worse_in(ours: Quality, theirs: Quality) -> tuple[str, ...]:
    """Return in what ours is worse: nothing, "overlap", "energy" or both.

    Examples
    --------
    >>> worse_in(Quality(0.04, 0.01, "drift"), Quality(0.02, 0.01, "drift"))
    ('overlap',)
    """
    left_alone = ENERGY_LEFT_ALONE[ours.energy_kind]
    is_other_gas = theirs.energy_kind == "drift" and theirs.energy_error > MOST_DRIFT
    overlap_left_alone = math.inf if is_other_gas else OVERLAP_LEFT_ALONE
    pairs = {
        "overlap": (ours.overlap, theirs.overlap, overlap_left_alone),
        "energy": (ours.energy_error, theirs.energy_error, left_alone),
    }
    return tuple(
        name for name, (our, their, least) in pairs.items() if not our <= max(ALIKE * their, least)
    )


def step_for_error(steps: Sequence[float], errors: Sequence[float], wanted: float) -> float:
    """Return the time step at which an error would be as small as is wanted, s: extrapolated.

    error = c step^p,   fitted to the measured errors

    It is 0.0 where they hardly fall, p < 1/2: such a line says nothing.

    Examples
    --------
    The error is as large as the step.

    >>> round(step_for_error([0.1, 0.01], [0.1, 0.01], wanted=1e-6), 12)
    1e-06
    """
    order, logarithm = np.polyfit(np.log(steps), np.log(errors), 1)
    return (
        math.exp((math.log(wanted) - float(logarithm)) / float(order))
        if order >= LEAST_ORDER
        else 0.0
    )
