"""Seams: a floor of many pieces is as smooth as one, and walls, steps and trestles are not."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from lesson_code import Body, Circle, Material, Polygon, Scene, Segment, simulate
from lesson_code.engine.core.constants import INTERNAL_EDGE_TOLERANCE
from lesson_code.engine.core.mixing import MixingRule
from lesson_code.engine.stepper import EngineStepper

KEPT = 1e-9
"""m/s: a disc or box without friction that slides for 4 s over up to 40 seams at up to 10 m/s."""

TURNED = 1e-12
"""m/s and rad/s, up and round: nothing but rounding."""

Floor = Callable[[], list[Body]]


def of_segments() -> list[Body]:
    """Return a floor of segments of 1 m, end to end."""
    return [Body(Segment((k, 0), (k + 1, 0))) for k in range(-3, 90)]


def of_blocks() -> list[Body]:
    """Return a floor of blocks, side by side."""
    return [Body(Polygon.box(1, 1), position=(k + 0.5, -0.5)) for k in range(-3, 90)]


def of_steps() -> list[Body]:
    """Return a floor of blocks whose sides reach below their neighbours'."""
    depths = [1.0, 0.3, 2.0]
    return [
        Body(Polygon.box(1, depths[k % 3]), position=(k + 0.5, -depths[k % 3] / 2))
        for k in range(-3, 90)
    ]


def of_rods() -> list[Body]:
    """Return a floor of rods with round ends, 20 cm thick, their middle lines end to end."""
    return [Body(Segment((k, -0.1), (k + 1, -0.1), radius=0.1)) for k in range(-3, 90)]


SUNK = 1e-4
"""m: how deep a slider is put into the floor. One that only touches lands first, and not always
with all points of a rounded face at once."""


SLIDERS = {
    "disc": (Circle(0.5), 0.5),
    "small disc": (Circle(0.1), 0.1),
    "box": (Polygon.box(1, 1), 0.5),
    "plank": (Polygon.box(2.5, 0.5), 0.25),
}


@pytest.mark.one_in(3)
@pytest.mark.parametrize("floor", [of_segments, of_blocks, of_steps, of_rods])
@pytest.mark.parametrize(("shape", "height"), SLIDERS.values(), ids=SLIDERS)
@pytest.mark.parametrize("speed", [1.0, 5.0, 10.0])
def test_slider_on_a_smooth_floor_keeps_its_speed(
    floor: Floor, shape: Any, height: float, speed: float
) -> None:
    """No friction, no slope: v is what it was, to 1e-9, and nothing goes up or round."""
    body = Body(shape, mass=1, position=(0.3, height - SUNK), velocity=(speed, 0))
    scene = Scene([*floor(), body], gravity=(0, -10))
    run = simulate(scene, 4.0, solver="direct", sample="end")
    vx, vy = run.velocities[-1, -1]
    assert vx == pytest.approx(speed, abs=KEPT)
    assert vy == pytest.approx(0, abs=TURNED)
    assert run.angular_velocities[-1, -1] == pytest.approx(0, abs=TURNED)


@pytest.mark.parametrize("offset", [0.0, 1e6])
def test_slider_far_from_the_origin_keeps_its_speed(offset: float) -> None:
    """There the pieces' places are rounded to 1e-10 m: still no step."""
    pieces = [
        Body(Polygon.box(1, 1), position=(offset + 0.1 * k + 0.7, offset - 0.5))
        for k in range(0, 200, 10)
    ]
    box = Body(Polygon.box(1, 1), mass=1, position=(offset + 0.9, offset + 0.5), velocity=(4, 0))
    run = simulate(Scene([*pieces, box], gravity=(0, -10)), 3.0, solver="direct", sample="end")
    assert run.velocities[-1, -1, 0] == pytest.approx(4, abs=KEPT)


def contacts(*bodies: Body) -> list[tuple[int, int]]:
    """Return the pairs of bodies whose contacts are kept, one for each point."""
    stepper = EngineStepper(
        Scene(bodies),
        solver="direct",
        dt=1e-9,
        iterations=1,
        substeps=1,
        combine=MixingRule(),
    )
    stepper.advance(1)
    count = stepper.world.state.contact_count
    return [(c.a, c.b) for c in stepper.world.contacts[:count]]


LEFT, RIGHT = Body(Segment((-1, 0), (0, 0))), Body(Segment((0, 0), (1, 0)))


def test_end_of_the_next_piece_is_left_out() -> None:
    """A box at x < 0 has sunk 1 cm, and its front stands 1 mm over the next piece."""
    box = Body(Polygon.box(1, 1), mass=1, position=(-0.499, 0.49))
    assert contacts(LEFT, RIGHT, box) == [(0, 2), (0, 2)]


def test_order_of_the_bodies_means_nothing() -> None:
    """The same, with the box first."""
    box = Body(Polygon.box(1, 1), mass=1, position=(-0.499, 0.49))
    assert contacts(box, RIGHT, LEFT) == [(0, 2), (0, 2)]


def test_corner_under_a_disc_is_left_out() -> None:
    """A disc over the left piece reaches the corner of the right one, too."""
    disc = Body(Circle(0.5), mass=1, position=(-0.01, 0.49))
    assert contacts(LEFT, RIGHT, disc) == [(0, 2)]


@pytest.mark.parametrize("height", [10 * INTERNAL_EDGE_TOLERANCE, 0.1, 2.0])
def test_step_and_wall_are_kept(height: float) -> None:
    """What stands higher than the floor stops a box."""
    wall = Body(Polygon.box(1, 2), position=(0.5, height - 1))
    box = Body(Polygon.box(1, 1), mass=1, position=(-0.499, 0.49))
    assert (1, 2) in contacts(LEFT, wall, box)


def test_rod_that_slides_into_a_wall_is_stopped() -> None:
    """A flat rod meets the wall with its end, at the height of the floor."""
    wall = Body(Segment((0, 0), (0, 1)))
    rod = Body(Segment((-0.5, 0), (0.5, 0), radius=0.02), mass=1, position=(-0.519, 0.019))
    assert (1, 2) in contacts(LEFT, wall, rod)


def test_plank_on_two_trestles_rests_on_both() -> None:
    """Two faces at one height, side by side: both carry."""
    trestles = [Body(Polygon.box(0.2, 1), position=(x, -0.5)) for x in (-1.0, 1.0)]
    plank = Body(Polygon.box(3, 0.2), mass=1, position=(0, 0.09))
    assert contacts(*trestles, plank) == [(0, 2), (0, 2), (1, 2), (1, 2)]


def test_disc_in_a_gap_rests_on_both_edges() -> None:
    """Each edge stands above the plane on which the other would carry the disc."""
    sides = [Body(Polygon.box(1, 1), position=(0.8 * s, -0.5)) for s in (-1, 1)]
    disc = Body(Circle(0.5), mass=1, position=(0, math.sqrt(0.16) - 0.001))
    assert contacts(*sides, disc) == [(0, 2), (1, 2)]


def test_disc_in_a_valley_rests_on_both_sides() -> None:
    """Two faces that rise from one line."""
    sides = [Body(Segment((0, 0), (s, 1))) for s in (-1, 1)]
    disc = Body(Circle(0.2), mass=1, position=(0, 0.2 * math.sqrt(2) - 0.001))
    assert contacts(*sides, disc) == [(0, 2), (1, 2)]


def test_bodies_that_can_be_pushed_are_no_floor() -> None:
    """Two boxes that touch, and one on top of both: all contacts are kept."""
    lower = [Body(Polygon.box(1, 1), mass=1, position=(0.49 * s, -0.5)) for s in (-1, 1)]
    upper = Body(Polygon.box(1, 1), mass=1, position=(0.2, 0.49))
    assert len(contacts(*lower, upper)) == 6


@pytest.mark.parametrize("solver", ["sequential", "direct"])
def test_rolling_disc_with_friction_does_not_feel_seams(solver: str) -> None:
    """Rolling from the start, v = -w r: nothing has a reason to change."""
    pieces = [Body(Segment((k, 0), (k + 1, 0)), material=Material(0.5, 0.8)) for k in range(-1, 20)]
    disc = Body(
        Circle(0.5),
        mass=1,
        position=(0.3, 0.5),
        velocity=(3, 0),
        angular_velocity=-6,
        material=Material(0.5, 0.8),
    )
    run = simulate(Scene([*pieces, disc], gravity=(0, -10)), 5.0, solver=solver, sample="end")
    np.testing.assert_allclose(run.velocities[-1, -1], (3, 0), atol=1e-8)
