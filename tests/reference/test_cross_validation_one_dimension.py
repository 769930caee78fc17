"""Collisions on a line against exact fractions and against pymunk, on large seeded tables.

An error is measured in units of the larger speed before the collision. A velocity after it may
be as small as one likes by cancellation, while the rounding in it comes from the terms that
cancelled, and those are as large as the speeds before; so its own size is no scale for it.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tiers import share

from lesson_code.formulas import (
    collide_1d,
    elastic_1d,
    energy_lost_1d,
    inelastic_1d,
    restitution_1d,
)
from lesson_code.reference.closed_forms import two_body_exact
from lesson_code.reference.pymunk_reference import collide_on_a_line

CASES = share(10_000)
PYMUNK_CASES = share(5_000)

ROUNDING = 1e-12
"""In units of the larger speed. Some ten roundings of 1e-16 each make 1e-15; measured: 1.2e-15
against fractions and 1e-15 against pymunk. The rest is margin for other processors."""

SEED = 20_240_229

Table = dict[str, Any]


def random_collisions(count: int) -> Table:
    """Return approaching pairs: masses 1e-3 to 1e3 log-uniform, velocities up to 100, any e."""
    rng = np.random.default_rng(SEED)
    v1, v2 = np.sort(rng.uniform(-100, 100, (2, count)), axis=0)[::-1]
    return {
        "m1": 10 ** rng.uniform(-3, 3, count),
        "v1": v1,
        "m2": 10 ** rng.uniform(-3, 3, count),
        "v2": v2,
        "restitution": rng.uniform(0, 1, count),
    }


def rows(table: Table) -> list[tuple[float, ...]]:
    """Return the table's cases, each as plain floats in the order m1, v1, m2, v2, e."""
    return list(zip(*(column.tolist() for column in table.values()), strict=True))


def worst(measured: Any, expected: Any, table: Table) -> float:
    """Return the largest error, in units of the larger speed before each collision."""
    scale = np.maximum(np.abs(table["v1"]), np.abs(table["v2"]))
    return float(np.max(np.abs(np.asarray(measured) - np.asarray(expected)) / scale))


def exact(table: Table) -> Any:
    """Return the exact answers, rounded once to float: shape (2, count)."""
    return np.array([[float(v) for v in two_body_exact(*row)] for row in rows(table)]).T


def test_velocities_random_restitution_equal_exact_fractions() -> None:
    """collide_1d solves momentum and restitution: 10,000 cases against Cramer's rule."""
    table = random_collisions(CASES)
    assert worst(collide_1d(**table), exact(table), table) < ROUNDING


@pytest.mark.parametrize(
    ("formula", "restitution"), [(elastic_1d, 1.0), (inelastic_1d, 0.0)], ids=["elastic", "sticks"]
)
def test_velocities_limits_equal_exact_fractions(
    formula: Callable[..., Any], restitution: float
) -> None:
    """elastic_1d is e = 1 and inelastic_1d is e = 0, on the same 10,000 cases."""
    table = random_collisions(CASES) | {"restitution": np.full(CASES, restitution)}
    measured = formula(table["m1"], table["v1"], table["m2"], table["v2"])
    assert worst(measured, exact(table), table) < ROUNDING


def test_velocities_on_fractions_are_exactly_those_of_the_linear_system() -> None:
    """Fed with fractions the same formula gives fractions: no rounding, no difference."""
    for row in rows(random_collisions(1_000)):
        m1, v1, m2, v2, e = (Fraction(number) for number in row)
        assert collide_1d(m1, v1, m2, v2, e) == two_body_exact(m1, v1, m2, v2, e)
        assert elastic_1d(m1, v1, m2, v2) == two_body_exact(m1, v1, m2, v2, 1)
        assert inelastic_1d(m1, v1, m2, v2) == two_body_exact(m1, v1, m2, v2, 0)


positive_fraction = st.fractions(min_value=Fraction(1, 1000), max_value=1000)
any_fraction = st.fractions(min_value=-100, max_value=100)


@settings(derandomize=True)
@given(
    m1=positive_fraction,
    v1=any_fraction,
    m2=positive_fraction,
    v2=any_fraction,
    e=st.fractions(min_value=0, max_value=1),
)
def test_velocities_any_fractions_keep_momentum_and_restitution_exactly(
    m1: Fraction, v1: Fraction, m2: Fraction, v2: Fraction, e: Fraction
) -> None:
    """The two statements that define the collision hold to the last digit (Newton 1687)."""
    v1_after, v2_after = collide_1d(m1, v1, m2, v2, e)
    assert (v1_after, v2_after) == two_body_exact(m1, v1, m2, v2, e)
    assert m1 * v1_after + m2 * v2_after == m1 * v1 + m2 * v2
    assert v2_after - v1_after == e * (v1 - v2)
    if v1 != v2:
        assert restitution_1d(v1, v2, v1_after, v2_after) == e


def test_energy_lost_random_restitution_is_that_of_the_exact_velocities() -> None:
    """Kinetic energy before minus after, in fractions; in units of the most that can be lost."""
    table = random_collisions(CASES)
    lost = np.array([float(energy_lost_exactly(*row)) for row in rows(table)])
    sticking = rows(table | {"restitution": np.zeros(CASES)})
    most = np.array([float(energy_lost_exactly(*row)) for row in sticking])
    assert np.max(np.abs(energy_lost_1d(**table) - lost) / most) < ROUNDING


def energy_lost_exactly(m1: float, v1: float, m2: float, v2: float, e: float) -> Fraction:
    """Return the kinetic energy before minus after, J."""
    v1_after, v2_after = two_body_exact(m1, v1, m2, v2, e)
    first = Fraction(m1) * (Fraction(v1) ** 2 - v1_after**2)
    second = Fraction(m2) * (Fraction(v2) ** 2 - v2_after**2)
    return (first + second) / 2


def pymunk_answers(table: Table) -> Any:
    """Return pymunk's velocities after, shape (2, count)."""
    return np.array([collide_on_a_line(*row) for row in rows(table)]).T


def test_velocities_random_restitution_equal_pymunk() -> None:
    """The solver of pymunk, which knows impulses only, agrees on 5,000 cases."""
    table = random_collisions(PYMUNK_CASES)
    assert worst(collide_1d(**table), pymunk_answers(table), table) < ROUNDING


@pytest.mark.parametrize("immovable", ["m1", "m2"])
def test_velocities_infinite_mass_equal_pymunk_kinematic_body(immovable: str) -> None:
    """An infinite mass is pymunk's kinematic body, which moves but is never pushed."""
    table = random_collisions(PYMUNK_CASES)
    table[immovable] = np.full(PYMUNK_CASES, math.inf)
    assert worst(collide_1d(**table), pymunk_answers(table), table) < ROUNDING


@pytest.mark.parametrize("immovable", ["m1", "m2"])
def test_velocities_growing_mass_tend_to_the_infinite_one(immovable: str) -> None:
    """The exact answer for a mass of 1e30 kg is that of an infinite mass to 1e-27."""
    table = random_collisions(1_000)
    huge = table | {immovable: np.full(1_000, 1e30)}
    infinite = table | {immovable: np.full(1_000, math.inf)}
    assert worst(collide_1d(**infinite), exact(huge), table) < ROUNDING


@pytest.mark.parametrize("ratio", [1e6, 1e12])
def test_velocities_extreme_mass_ratio_equal_pymunk_and_fractions(ratio: float) -> None:
    """One impact between masses 1 : 1e12 is no hard case: all three agree."""
    table = random_collisions(1_000) | {"m1": np.full(1_000, ratio), "m2": np.ones(1_000)}
    measured = collide_1d(**table)
    assert worst(measured, exact(table), table) < ROUNDING
    assert worst(measured, pymunk_answers(table), table) < ROUNDING
