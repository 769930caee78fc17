"""Orders: the slope of a straight line through logarithms."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.evidence.orders import fit_order

ROUNDING = 1e-9
"""Relative: a straight line fitted to a few logarithms."""


@given(st.floats(0.2, 4.0), st.floats(1e-3, 1e3), st.integers(2, 8))
def test_order_of_an_exact_power_is_its_exponent(order: float, factor: float, count: int) -> None:
    """Least squares of the logarithms give back order and factor, and nothing is scattered."""
    steps = [0.1 / 2**n for n in range(count)]
    fit = fit_order(steps, [factor * dt**order for dt in steps])
    assert fit.order == pytest.approx(order, rel=ROUNDING)
    assert fit.factor == pytest.approx(factor, rel=1e-6)
    assert fit.scatter == pytest.approx(1.0, abs=1e-6)
    assert (fit.finest, fit.coarsest) == (steps[-1], steps[0])


def test_order_of_scattered_errors_is_the_slope_of_the_middle() -> None:
    """Errors alternately twice and half of dt: the order is 1, and a point lies off by 2."""
    steps = [0.4, 0.2, 0.1, 0.05, 0.025, 0.0125]
    factors = [2, 0.5, 0.5, 2, 2, 0.5]  # its own slope over ln dt is small
    fit = fit_order(steps, [f * dt for f, dt in zip(factors, steps, strict=True)])
    x = np.log(steps) - np.mean(np.log(steps))
    slope = float((x * np.log(factors)).sum() / (x * x).sum())
    assert fit.order == pytest.approx(1 + slope, rel=ROUNDING)
    assert fit.scatter == pytest.approx(2, rel=0.05)


@pytest.mark.parametrize(
    ("steps", "errors"),
    [([0.1], [1.0]), ([0.1, 0.1], [1.0, 2.0]), ([0.1, 0.2], [1.0, 0.0]), ([0.1, 0.2], [1.0])],
)
def test_order_of_what_is_no_line_is_refused(steps: list[float], errors: list[float]) -> None:
    """Two different steps, and errors whose logarithm there is."""
    with pytest.raises(ValueError, match="steps"):
        fit_order(steps, errors)
