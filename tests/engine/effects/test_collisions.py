"""Whether two bodies can meet: flights that just meet and just miss."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st
from tiers import share

from lesson_code import Body, Circle, Polygon, Scene, Segment, simulate
from lesson_code.engine.effects.flights import can_meet

DT = 0.01

NEARLY = 1e-6
"""Relative: just beyond or just short of a border that takes a few operations to compute."""


def disc(x: float = 0.0, y: float = 0.0, **rest: Any) -> Body:
    """Return a disc of 1 kg and radius 1/2 m."""
    given: dict[str, Any] = {"mass": 1.0, "position": (x, y)}
    return Body(Circle(0.5), **(given | rest))


def meet(*bodies: Body, duration: float, dt: float = DT, **rest: Any) -> bool:
    """Return whether bodies can meet."""
    return can_meet(Scene(bodies, **rest), duration, dt)


@pytest.mark.parametrize(("times", "expected"), [(1 - NEARLY, False), (1 + NEARLY, True)])
def test_disc_that_flies_at_a_wall_meets_it_from_a_time_on(times: float, expected: bool) -> None:
    """2 m at 1 m/s: in 2 s; a step more is reckoned with, for that is where it is seen."""
    wall = Body(Circle(0.5), position=(3, 0))
    ball = disc(velocity=(1, 0))
    assert meet(ball, wall, duration=2 * times - DT) is expected
    assert meet(wall, ball, duration=2 * times - DT) is expected


@pytest.mark.parametrize(("times", "expected"), [(1 - NEARLY, True), (1 + NEARLY, False)])
def test_disc_that_flies_past_misses_by_its_radius(times: float, expected: bool) -> None:
    """The other stands beside its way: at a distance of both radii they touch."""
    other = disc(5, times * 1.0)
    assert meet(disc(velocity=(9, 0)), other, duration=2.0) is expected


@pytest.mark.parametrize(("times", "expected"), [(1 - NEARLY, False), (1 + NEARLY, True)])
def test_disc_that_is_thrown_up_meets_what_hangs_at_the_top_of_its_way(
    times: float, expected: bool
) -> None:
    """The top, v^2 / 2 g, lies within the flight and not at one of its ends."""
    g, v = 10.0, 4.0 * times
    top = 4.0**2 / (2 * g)
    lamp = Body(Circle(0.5), position=(0, top + 1))
    assert meet(disc(velocity=(0, v)), lamp, duration=0.7, gravity=(0, -g)) is expected


@pytest.mark.parametrize(
    ("bodies", "expected"),
    [
        ([], False),
        ([disc()], False),
        ([Body(Circle(1)), Body(Circle(1))], False),
        ([Body(Circle(1)), Body(Circle(1), velocity=(1, 0))], False),
        ([disc(), Body(Circle(0.1))], True),
    ],
    ids=["nobody", "one", "two that stand", "one that stands and one that moves", "in each other"],
)
def test_two_bodies_meet_only_if_one_can_be_pushed(bodies: list[Body], expected: bool) -> None:
    """However long the run."""
    assert meet(*bodies, duration=math.inf) is expected
    assert meet(*bodies, duration=1.0) is expected


def test_run_of_unknown_length_lets_any_two_meet() -> None:
    """Though they fly apart."""
    pair = disc(0, velocity=(-1, 0)), disc(9, velocity=(1, 0))
    assert meet(*pair, duration=math.inf)
    assert not meet(*pair, duration=1e6)


def test_wall_that_moves_reaches_what_stands() -> None:
    """Static bodies feel no gravity, and keep their velocity."""
    bat = Body(Polygon.box(1, 1), position=(-5, 0), velocity=(1, 0))
    assert meet(bat, disc(), duration=4.5)
    assert not meet(bat, disc(), duration=3.0)
    shelf = Body(Segment((-1, 0), (1, 0)), position=(0, -4))
    assert not meet(shelf, disc(), duration=2.0)
    assert meet(shelf, disc(), duration=2.0, gravity=(0, -10))


def test_turning_body_reaches_as_far_as_its_farthest_point() -> None:
    """A rod of 4 m beside a disc at 2 m: lying it does not reach it, turning it does."""
    rod = Body(Segment((-2, 0), (2, 0)), mass=1.0, angular_velocity=1.0)
    assert meet(rod, disc(0, 2.4), duration=2.0)
    assert not meet(rod, disc(0, 2.6), duration=2.0)


def xy(rng: np.random.Generator, most: float) -> tuple[float, float]:
    """Return two numbers, each no larger than so much."""
    return rng.uniform(-most, most), rng.uniform(-most, most)


def drawn(seed: int) -> Scene:
    """Return bodies here and there, some of which meet in a second."""
    rng = np.random.default_rng(seed)
    shapes: list[Any] = [
        Circle(0.5),
        Polygon.box(1.2, 0.4),
        Segment((-0.6, 0), (0.6, 0), radius=0.1),
    ]
    bodies = [
        Body(
            shapes[rng.integers(3)],
            mass=None if rng.random() < 0.3 else rng.uniform(0.5, 2),
            position=xy(rng, 4),
            velocity=xy(rng, 3),
            angular_velocity=rng.uniform(-5, 5),
        )
        for _ in range(3)
    ]
    return Scene(bodies, gravity=(0, rng.choice([0.0, -10.0])), damping=rng.choice([0.0, 1.0]))


@settings(max_examples=share(150), phases=[Phase.explicit, Phase.generate])
@given(st.integers(0, 10**9))
def test_bodies_that_cannot_meet_have_no_contact_in_a_run(seed: int) -> None:
    """The rule may be too careful, but never misses a contact."""
    scene = drawn(seed)
    if can_meet(scene, 0.5, 1 / 60):
        return
    run = simulate(scene, 0.5, solver="sequential", effects={"collisions": True})
    assert len(run.contacts) == 0


def test_scenes_of_that_test_are_of_both_kinds() -> None:
    """At least a fifth of each, or it would show little."""
    found = [can_meet(drawn(seed), 0.5, 1 / 60) for seed in range(100)]
    assert 20 <= sum(found) <= 80
