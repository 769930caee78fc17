"""What follows from a run: momentum, angular momentum, energies, penetration, by hand."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from lesson_code import Body, Circle, Polygon, Run, Scene, Segment, simulate

WALL = Body(Segment((-50, -5), (50, -5)), velocity=(3, 0))
# I = m r^2 / 2 = 1
DISC = Body(Circle(1), mass=2, position=(3, 1), velocity=(1, -2), angular_velocity=4)
BOX = Body(Polygon.box(1, 2), mass=6, position=(-3, 0), velocity=(0, 1), inertia=math.inf)

DERIVED = ("momentum", "angular_momentum", "kinetic_energy", "energy", "max_penetration")


def at_once(*bodies: Body, gravity: Any = (0, 0)) -> Run:
    """Return a run without any time."""
    return simulate(Scene(bodies, gravity=gravity), 0.0, solver="sequential")


def test_run_is_shown_in_one_line() -> None:
    """Nobody who looks at a run is shown its arrays."""
    run = simulate(Scene([DISC]), 1.0, solver="sequential")
    plan = "solver: sequential (asked for); plain Python (a small run)"
    assert repr(run) == f"<Run: bodies 1, states 61, impulses 0; {plan}>"


def test_momentum_worked_by_hand_is_found() -> None:
    """2 (1, -2) + 6 (0, 1) = (2, 2); a wall, which nothing can push, does not count."""
    assert at_once(DISC, WALL, BOX).momentum.tolist() == [[2.0, 2.0]]


def test_angular_momentum_worked_by_hand_is_found() -> None:
    """2 (3 x -2 - 1 x 1) + 1 x 4 = -10 for the disc, 6 (-3 x 1) = -18 for the box."""
    assert at_once(DISC, WALL, BOX).angular_momentum.tolist() == [-28.0]


def test_kinetic_energy_worked_by_hand_is_found() -> None:
    """1/2 2 5 + 1/2 1 16 = 13 for the disc; 1/2 6 1 = 3 for the box, which cannot spin."""
    assert at_once(DISC, WALL, BOX).kinetic_energy.tolist() == [16.0]


def test_energy_of_height_worked_by_hand_is_found() -> None:
    """Minus m g . r: 2 x 10 x 1 for the disc at a height of 1 m, nothing for the box at 0."""
    assert at_once(DISC, WALL, BOX, gravity=(0, -10)).energy.tolist() == [36.0]
    assert at_once(DISC, gravity=(2, 0)).energy.tolist() == [13.0 - 2 * 2 * 3]


def test_energy_of_a_body_that_spins_but_never_turns_by_impulses_leaves_its_spin_out() -> None:
    """An infinite moment of inertia has no energy that could be told: it counts as none."""
    spinning = Body(Circle(1), mass=2, angular_velocity=7, inertia=math.inf)
    run = at_once(spinning)
    assert (run.kinetic_energy.tolist(), run.angular_momentum.tolist()) == ([0.0], [0.0])


@pytest.mark.parametrize("bodies", [(), (WALL,)], ids=["no bodies", "a wall alone"])
@pytest.mark.parametrize("name", DERIVED)
def test_sums_over_nothing_that_can_be_pushed_are_zero(name: str, bodies: Any) -> None:
    """One zero for each frame."""
    values = getattr(simulate(Scene(bodies), 0.1, solver="sequential"), name)
    assert values.shape == ((7, 2) if name == "momentum" else (7,))
    assert not values.any()


@pytest.mark.parametrize("bodies", [(), (DISC, BOX)], ids=["no bodies", "two bodies"])
@pytest.mark.parametrize("name", DERIVED)
def test_sums_cannot_be_changed(name: str, bodies: Any) -> None:
    """They are computed once and kept; nobody may spoil them."""
    values = getattr(simulate(Scene(bodies), 0.1, solver="sequential"), name)
    with pytest.raises(ValueError, match="read-only"):
        values[...] = 1


@pytest.mark.parametrize("name", DERIVED)
def test_sums_of_no_frames_are_empty(name: str) -> None:
    """A run of which no state was asked for."""
    values = getattr(simulate(Scene([DISC, BOX]), 0.1, sample=[], solver="sequential"), name)
    assert values.shape == ((0, 2) if name == "momentum" else (0,))


def test_sums_are_computed_only_once() -> None:
    """The second question gets the same array."""
    run = at_once(DISC)
    assert run.energy is run.energy


def test_number_of_impulses_is_the_length_of_the_events() -> None:
    """The discs meet at 1 m/s each, and the one step with an impulse has one point."""
    discs = [Body(Circle(0.5), mass=1, position=(x, 0), velocity=(-x, 0)) for x in (-1, 1)]
    assert len(simulate(Scene(discs), 1.0, solver="sequential").contacts) == 1
    assert len(simulate(Scene(discs), 0.1, solver="sequential").contacts) == 0


def test_runs_are_equal_only_to_themselves() -> None:
    """Arrays have no single answer to whether they are equal."""
    a, b = at_once(DISC), at_once(DISC)
    assert a != b
    np.testing.assert_array_equal(a.positions, b.positions)
