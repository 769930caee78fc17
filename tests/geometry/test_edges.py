"""One edge: direction, outward normal and closest point, by hand and at the ends of float range."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.geometry.edges import closest_on_edge, direction, outward_normal

UNIT = 4e-16
"""A direction is rounded four times, by 1e-16 each."""

component = st.floats(-1e300, 1e300)


@pytest.mark.parametrize(
    ("vector", "length", "unit"),
    [
        pytest.param((3.0, 4.0), 5.0, (0.6, 0.8), id="3-4-5"),
        pytest.param((-5.0, 12.0), 13.0, (-5 / 13, 12 / 13), id="5-12-13"),
        pytest.param((0.0, -49.0), 49.0, (0.0, -1.0), id="along an axis, exactly unit"),
        pytest.param((3e200, 4e200), 5e200, (0.6, 0.8), id="huge"),
        pytest.param((3e-200, 4e-200), 5e-200, (0.6, 0.8), id="tiny"),
        pytest.param((3e-161, 4e-161), 5e-161, (0.6, 0.8), id="tiny, its square half lost"),
        pytest.param((0.0, 5e-324), 5e-324, (0.0, 1.0), id="smallest float"),
    ],
)
def test_direction_hand_worked(
    vector: tuple[float, float], length: float, unit: tuple[float, float]
) -> None:
    """Length and direction of Pythagorean triples, also where a square would leave float range."""
    measured = direction(*vector, 1.0, 0.0)
    assert measured[0] == pytest.approx(length, rel=UNIT)
    assert measured[1:] == pytest.approx(unit, abs=UNIT)


def test_direction_of_no_length_is_the_one_asked_for() -> None:
    """A vector of no length has no direction of its own."""
    assert direction(0.0, -0.0, 0.6, 0.8) == (0.0, 0.6, 0.8)


@given(component, component)
def test_direction_any_vector_is_unit(x: float, y: float) -> None:
    """Tiny or huge, the direction has length 1."""
    _, ux, uy = direction(x, y, 0.0, 1.0)
    assert math.hypot(ux, uy) == pytest.approx(1, abs=UNIT)


@pytest.mark.parametrize(
    ("end", "normal"),
    [((2, 0), (0, -1)), ((0, 2), (1, 0)), ((-2, 0), (0, 1)), ((0, -2), (-1, 0))],
    ids=["bottom", "right", "top", "left"],
)
def test_normal_of_counter_clockwise_square_points_out(
    end: tuple[float, float], normal: tuple[float, float]
) -> None:
    """The outside is on the right of an edge; a zero has no minus sign that would be printed."""
    measured = outward_normal(0.0, 0.0, *end)
    assert measured == normal
    assert all(math.copysign(1, n) == 1 for n in measured if n == 0)


@pytest.mark.parametrize(
    ("point", "closest"),
    [
        pytest.param((1, 7), (4, 3), id="foot"),
        pytest.param((-5, -1), (0, 0), id="before the start"),
        pytest.param((99, 50), (8, 6), id="beyond the end"),
        pytest.param((6, -8), (0, 0), id="level with the start"),
        pytest.param((8, 6), (8, 6), id="at the end"),
    ],
)
def test_closest_point_hand_worked(
    point: tuple[float, float], closest: tuple[float, float]
) -> None:
    """On the edge from (0, 0) to (8, 6): the foot, or the very end it lies beyond."""
    measured = closest_on_edge(*point, 0, 0, 8, 6, 0.8, 0.6)
    assert measured == pytest.approx(closest, abs=8 * UNIT)
