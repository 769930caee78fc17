"""Lemke's method: problems worked by hand, and random ones against their own conditions."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.engine.solvers.lemke import lemke

ROUNDING = 1e-9
"""Of numbers of some units, after up to 100 exchanges."""

BY_HAND = {
    "nothing to do": ([[1.0]], [2.0], [0.0]),
    "one": ([[2.0]], [-3.0], [1.5]),
    "both": ([[2.0, 1.0], [1.0, 2.0]], [-3.0, -3.0], [1.0, 1.0]),
    "the second would pull": ([[2.0, 1.0], [1.0, 2.0]], [-4.0, -1.0], [2.0, 0.0]),
    "not symmetric": ([[1.0, 2.0], [0.0, 1.0]], [-1.0, -1.0], [0.0, 1.0]),
}


@pytest.mark.parametrize(("matrix", "q", "z"), BY_HAND.values(), ids=BY_HAND)
def test_answer_worked_by_hand_is_found(
    matrix: list[list[float]], q: list[float], z: list[float]
) -> None:
    """One or two linear equations, or none."""
    found = lemke(np.array(matrix), np.array(q))
    assert found is not None
    np.testing.assert_allclose(found, z, atol=ROUNDING)


@given(seed=st.integers(0, 10**9), n=st.integers(1, 25))
def test_answer_of_a_strictly_copositive_problem_always_exists(seed: int, n: int) -> None:
    """M = A A^T + S + I/100, S skew: z M z > 0. Then w, z >= 0 and w z = 0."""
    rng = np.random.default_rng(seed)
    a, s = rng.normal(size=(n, n)), rng.normal(size=(n, n))
    matrix, q = a @ a.T + s - s.T + np.eye(n) / 100, rng.normal(size=n)
    z = lemke(matrix, q)
    assert z is not None
    w = q + matrix @ z
    scale = 1 + np.abs(matrix).max() * z.max()
    assert z.min() >= 0
    assert w.min() >= -ROUNDING * scale
    assert np.abs(w * z).max() <= ROUNDING * scale * (1 + z.max())


def test_problem_without_an_answer_has_none() -> None:
    """An equation like w = -1 + 0 z can never be >= 0."""
    assert lemke(np.array([[0.0]]), np.array([-1.0])) is None
