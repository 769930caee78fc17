"""pymunk's unfinished answer for a box that lands flat, predicted to the last digits."""

from __future__ import annotations

import pymunk
import pytest

from lesson_code.reference.impact_closed_forms import flat_landing

TINY_STEP = 1e-15
"""s: the box moves before it lands, and need not be raised for it."""

DEPTH = 1e-9
"""m of overlap, without which pymunk sees no contact."""

ROUNDING = 1e-14
"""m/s and rad/s; measured: 4.4e-16."""


def by_pymunk(width: float, height: float, e: float, iterations: int) -> tuple[float, float]:
    """Return v' and abs(w') of a box that lands flat at 1 m/s, after one step of pymunk's."""
    space = pymunk.Space()
    space.iterations = iterations
    box = pymunk.Body(1.0, (width**2 + height**2) / 12)
    box.position, box.velocity = (0.0, height / 2 - DEPTH), (0.0, -1.0)
    shape = pymunk.Poly.create_box(box, (width, height))
    floor = pymunk.Segment(space.static_body, (-50.0, -1.0), (50.0, -1.0), 1.0)
    shape.elasticity, floor.elasticity = e, 1.0
    space.add(box, shape, floor)
    space.step(TINY_STEP)
    return box.velocity[1], abs(box.angular_velocity)


@pytest.mark.parametrize(("width", "height"), [(1, 1), (10, 1), (1, 4), (1, 10), (1, 30)])
@pytest.mark.parametrize("iterations", [1, 2, 10, 100])
def test_flat_landing_after_pymunks_iterations_is_predicted(
    width: float, height: float, iterations: int
) -> None:
    """Its 10 iterations leave a box of 1 x 10 with 0.028 rad/s, and one of 1 x 30 with 0.0088.

    Which corner it visits first, and with it the sign of w', is its own affair.
    """
    v, w = flat_landing(width, height, 1.0, 0.5, iterations)
    expected = pytest.approx((v, abs(w)), abs=ROUNDING)
    assert by_pymunk(width, height, 0.5, iterations) == expected
