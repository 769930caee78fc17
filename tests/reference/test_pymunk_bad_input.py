"""What pymunk does with bad input, and where its Python side answers with an error.

It decides how much ``lesson_code.reference.pymunk_reference`` must check by itself: most of it.
Measured on the installed version, so that an upgrade that changes it fails here.
"""

from __future__ import annotations

import math
import subprocess
import sys

import pymunk
import pytest


def ball_in_a_space(velocity: tuple[float, float]) -> tuple[pymunk.Space, pymunk.Body]:
    """Return a space without gravity, and in it a ball of radius 1 m at the origin."""
    space, body = pymunk.Space(), pymunk.Body(1.0, math.inf)
    body.velocity = velocity
    space.add(body, pymunk.Circle(body, 1.0))
    return space, body


SCENE = """
import math, pymunk
space = pymunk.Space()
body = pymunk.Body(1, 1)
shape = pymunk.Circle(body, 1)
space.add(body, shape)
"""


@pytest.mark.parametrize(
    "statement",
    [
        "shape.friction = -1",
        "shape.friction = math.nan",
        "shape.elasticity = -1",
        "shape.elasticity = math.nan",
        "space.iterations = 0",
        "space.damping = -1",
        "pymunk.Body(-1, 1)",
        "pymunk.Body(math.inf, 1)",
        "pymunk.Body(1, -1)",
    ],
)
def test_bad_input_out_of_range_ends_the_process(statement: str) -> None:
    """The process is aborted: nothing to catch, and whatever it had not saved is lost."""
    run = subprocess.run(
        [sys.executable, "-c", SCENE + statement], capture_output=True, text=True, check=False
    )
    # A Python exception would end it with 1; an abort is a signal, -6, or 134 under a shell.
    assert run.returncode not in (0, 1)
    assert "Aborting due to Chipmunk error" in run.stderr


@pytest.mark.parametrize("mass", [-1.0, 0.0, math.nan, math.inf])
def test_bad_input_mass_of_a_body_in_a_space_is_an_assertion_error(mass: float) -> None:
    """Only once a body is in a space does Python look at its mass before the solver does."""
    space, body = ball_in_a_space((0.0, 0.0))
    assert body in space.bodies
    with pytest.raises(AssertionError, match="mass > 0"):
        body.mass = mass


@pytest.mark.parametrize("attribute", ["position", "velocity"])
def test_bad_input_nan_is_accepted_in_silence(attribute: str) -> None:
    """A nan is stored, stepped and handed back."""
    space, body = ball_in_a_space((0.0, 0.0))
    setattr(body, attribute, (math.nan, 0.0))
    space.step(1 / 60)
    assert math.isnan(body.position.x)


def test_bad_input_negative_step_runs_backwards() -> None:
    """A negative dt is taken: the body moves against its velocity."""
    space, body = ball_in_a_space((0.0, 2.0))
    space.step(-0.125)
    assert body.position.y == -0.25


def test_bad_input_degenerate_shapes_are_accepted() -> None:
    """A segment of no length, a negative radius and a polygon of no area are all taken."""
    body = pymunk.Body(1.0, 1.0)
    assert pymunk.Segment(body, (0.0, 0.0), (0.0, 0.0), 0.0).radius == 0.0
    assert pymunk.Circle(body, -1.0).radius == -1.0
    assert pymunk.Poly(body, [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0)]).area == 0.0


def test_bad_input_concave_polygon_is_replaced_by_its_hull() -> None:
    """An arrowhead loses its notch without a word: its area is 8 m^2 instead of 4."""
    arrowhead = [(0.0, 0.0), (2.0, 2.0), (-2.0, 0.0), (2.0, -2.0)]
    assert pymunk.Poly(pymunk.Body(1.0, 1.0), arrowhead).area == 8.0


def two_free_circles(distance: float) -> tuple[list[pymunk.Body], list[pymunk.Circle]]:
    """Return two circles of radius 1 m outside any space, with their bodies to keep them alive."""
    bodies = [pymunk.Body(1.0, 1.0), pymunk.Body(1.0, 1.0)]
    bodies[1].position = (distance, 0.0)
    return bodies, [pymunk.Circle(body, 1.0) for body in bodies]


@pytest.mark.parametrize("distance", [5.0, 2.0])
def test_shapes_collide_separated_shapes_raise_an_assertion_error(distance: float) -> None:
    """Shapes that do not overlap give no empty answer but an AssertionError."""
    _bodies, (a, b) = two_free_circles(distance)
    a.cache_bb(), b.cache_bb()
    with pytest.raises(AssertionError, match="likely a bug in Pymunk"):
        a.shapes_collide(b)


def test_shapes_collide_uses_the_positions_last_cached() -> None:
    """Before a step or cache_bb() shapes are taken to be at the origin, wherever they are."""
    _bodies, (a, b) = two_free_circles(5.0)
    assert a.shapes_collide(b).points[0].distance == -2.0
