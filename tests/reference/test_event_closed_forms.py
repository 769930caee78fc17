"""What is known of bodies that fly freely: by hand, by counting, by exact arithmetic, in limits."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction

import numpy as np
import pytest

from lesson_code.reference.event_closed_forms import (
    CLOSEST_PACKING,
    block_collisions,
    blocks_at,
    escape_fraction,
    hard_disc_collision_rate,
    hard_disc_compressibility,
    missed_by_samples,
)

ROUNDING = 1e-14
"""A few roundings of numbers of size 1."""

PI = "31415926"

SERIES = (2.0, 3.128018, 4.257855, 5.336897, 6.362592)
"""Z = 1 + 2 eta + 3.128 eta^2 + ...: what is known of hard discs without any approximation;
Clisby and McCoy, J. Stat. Phys. 122 (2006), 15: the virial coefficients B2 to B6."""

SERIES_AGREES = 0.003
"""Henderson's formula is chosen to be simple: 3.125 stands for 3.128, and so on."""


def let_fly(speed: float, dt: float, radius: float, thickness: float, start: float) -> bool:
    """Return whether a ball that starts at `start` < 0 gets past a wall round 0, step by step."""
    x = start
    while x < radius + thickness:
        if -(radius + thickness / 2) < x < 0:
            return False
        x += speed * dt
    return True


@pytest.mark.parametrize("speed", [4.0, 9.0, 10.0, 18.0, 100.0])
def test_escape_fraction_is_what_counting_gives(speed: float) -> None:
    """Balls of 0.1 m at all phases of a step of 1/60 s, against a wall of 0.1 m."""
    phases = (np.arange(1000) + 0.5) / 1000 * speed / 60
    passed = np.mean([let_fly(speed, 1 / 60, 0.1, 0.1, -1 - phase) for phase in phases])
    assert passed == pytest.approx(escape_fraction(speed, 1 / 60, 0.1, 0.1), abs=1 / 1000)


def test_escape_fraction_by_hand() -> None:
    """R + th/2 = 0.15 m on a way of 0.5 m; on one of 0.15 m nothing passes; without size all."""
    assert escape_fraction(50, 0.01, 0.1, 0.1) == pytest.approx(0.7, abs=ROUNDING)
    assert escape_fraction(15, 0.01, 0.1, 0.1) == pytest.approx(0, abs=ROUNDING)
    assert escape_fraction(1, 0.01, 0.1, 0.1) == 0
    assert escape_fraction(1, 0.01, 0, 0) == 1


@pytest.mark.parametrize("spacing", [0.02, 0.5, 1.0, 1.9, 2.0, 2.1, 7.0])
def test_missed_by_samples_is_the_mean_over_all_distances(spacing: float) -> None:
    """A chord of length L is missed with the chance 1 - L/s; summed over 200,000 distances."""
    aside = (np.arange(200_000) + 0.5) / 200_000
    chord = 2 * np.sqrt(1 - aside**2)
    missed = np.maximum(0, 1 - chord / spacing).mean()
    assert missed_by_samples(spacing, 1.0) == pytest.approx(missed, abs=1e-6)
    assert missed_by_samples(3 * spacing, 3.0) == pytest.approx(missed, abs=1e-6)


def test_missed_by_samples_of_close_samples_is_a_sixth_of_a_square() -> None:
    """k^2/6 + k^4/20 + ...: half the spacing, a quarter of the misses."""
    for k in (0.01, 0.03, 0.1):
        assert missed_by_samples(2 * k, 1.0) == pytest.approx(k**2 / 6, abs=k**4)


def counted_exactly(ratio: int) -> int:
    """Return the collisions of two blocks and a wall, in fractions."""
    inner, outer, count = Fraction(0), Fraction(-1), 0
    while inner > outer:
        centre = (inner + ratio * outer) / (1 + ratio)
        inner, outer, count = 2 * centre - inner, 2 * centre - outer, count + 1
        if inner < 0:
            inner, count = -inner, count + 1
    return count


@pytest.mark.parametrize("ratio", [*range(1, 40), 99, 100, 101, 400, 9_999, 10_000, 10_001])
def test_block_collisions_is_what_exact_counting_gives(ratio: int) -> None:
    """Ratios 1 and 3 are limits: the last collision leaves both blocks equally fast."""
    assert block_collisions(ratio) == counted_exactly(ratio)


@pytest.mark.parametrize("digits", range(8))
def test_block_collisions_of_powers_of_100_are_digits_of_pi(digits: int) -> None:
    """3, 31, 314, 3141, ... up to 31,415,926."""
    assert block_collisions(100**digits) == int(PI[: digits + 1])


def test_block_collisions_of_a_light_block_that_comes() -> None:
    """It bounces back and leaves the heavy one, slow, to the wall: 2 with the hit there."""
    assert block_collisions(0.01) == counted_exactly_light() == 2


def counted_exactly_light() -> int:
    """Return the count for a block at the wall that is a hundred times as heavy."""
    inner, outer = Fraction(-2, 101), Fraction(99, 101)
    assert 100 * inner + outer == -1
    assert -inner < outer  # after the wall it does not catch up
    return 2


def blocks_in_fractions(time: float, ratio: int, inner: float, outer: float) -> tuple[float, float]:
    """Return the places of two blocks, from collision to collision without any rounding."""
    x1, x2, v1, v2 = Fraction(inner), Fraction(outer), Fraction(0), Fraction(-1)
    left = Fraction(time)
    while True:
        to_wall = -x1 / v1 if v1 < 0 else left
        to_block = (x2 - x1) / (v1 - v2) if v1 > v2 else left
        step = min(to_wall, to_block, left)
        x1, x2, left = x1 + v1 * step, x2 + v2 * step, left - step
        if left == 0:
            return float(x1), float(x2)
        if to_wall <= to_block:
            v1 = -v1
        else:
            centre = (v1 + ratio * v2) / (1 + ratio)
            v1, v2 = 2 * centre - v1, 2 * centre - v2


@pytest.mark.parametrize("ratio", [1, 2, 7, 100])
@pytest.mark.parametrize("time", [0.0, 0.5, 1.5, 2.25, 3.0, 5.0, 40.0])
def test_blocks_are_where_collisions_in_fractions_leave_them(ratio: int, time: float) -> None:
    """A point that flies straight through mirrored wedges, against one collision after another."""
    there = blocks_in_fractions(time, ratio, 1.0, 2.0)
    rounding = 100 * ROUNDING * max(1.0, time)
    assert blocks_at(time, ratio, 1.0, 2.0) == pytest.approx(there, abs=rounding)


def test_compressibility_of_a_thin_gas_is_that_of_its_series() -> None:
    """At small eta all known virial coefficients agree to what the formula leaves out."""
    for eta in (0.01, 0.05, 0.1, 0.2):
        series = 1 + sum(b * eta**n for n, b in enumerate(SERIES, start=1))
        assert hard_disc_compressibility(eta) == pytest.approx(series, rel=SERIES_AGREES)


def test_compressibility_and_chi_agree_through_the_virial() -> None:
    """P A = N T (1 + 2 eta chi): the pressure is made by collisions, to a part in a hundred."""
    for eta in (0.1, 0.2, 0.3):
        rate = hard_disc_collision_rate(eta, 1, 1, 1)
        chi = rate * math.sqrt(math.pi) / (8 * eta)
        assert 1 + 2 * eta * chi == pytest.approx(hard_disc_compressibility(eta), rel=0.01)


def test_collision_rate_has_its_units() -> None:
    """It grows with speed, and falls as discs of the same share grow: times over lengths."""
    rate = hard_disc_collision_rate(0.3, 1, 1, 1)
    assert hard_disc_collision_rate(0.3, 2, 1, 1) == pytest.approx(rate / 2)
    assert hard_disc_collision_rate(0.3, 1, 4, 1) == pytest.approx(rate / 2)
    assert hard_disc_collision_rate(0.3, 1, 1, 4) == pytest.approx(rate * 2)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: escape_fraction(0, 1, 1, 1), "speed must be > 0"),
        (lambda: escape_fraction(1, math.inf, 1, 1), "dt must be > 0 and finite"),
        (lambda: escape_fraction(1, 1, -1, 1), "radius must be >= 0"),
        (lambda: escape_fraction(1, 1, 1, math.nan), "thickness must be >= 0"),
        (lambda: missed_by_samples(0, 1), "spacing must be > 0"),
        (lambda: missed_by_samples(1, 0), "reach must be > 0"),
        (lambda: block_collisions(0), "mass_ratio must be > 0"),
        (lambda: blocks_at(1, 0, 1, 2), "mass_ratio must be > 0"),
        (lambda: blocks_at(-1, 1, 1, 2), "time must be >= 0"),
        (lambda: blocks_at(1, 1, 2, 1), "inner must be <= outer"),
        (lambda: hard_disc_compressibility(CLOSEST_PACKING), "covered must be >= 0 and < 0.9069"),
        (lambda: hard_disc_collision_rate(-0.1, 1, 1, 1), "covered must be >= 0"),
        (lambda: hard_disc_collision_rate(0.1, 0, 1, 1), "diameter must be > 0"),
        (lambda: hard_disc_collision_rate(0.1, 1, 1, -1), "energy must be >= 0"),
    ],
)
def test_closed_forms_refuse_what_is_out_of_range(call: Callable[[], object], words: str) -> None:
    """The error names the argument and the rule."""
    with pytest.raises(ValueError, match=words):
        call()
