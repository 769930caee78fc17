"""The tasks of chapter 10: what they expect is what the engine's rules say, and what is drawn."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from random import Random
from typing import Any

import numpy as np
import pytest

from lesson_code.chapters.ch10_only_what_the_scene_needs import tasks
from lesson_code.course.grading.exercises import task_by_id
from lesson_code.course.grading.task import Arguments
from lesson_code.engine.core.mixing import MIXING_RULES
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.engine.effects.choice import choose_effects
from lesson_code.engine.effects.continuous import fastest_way as engine_way
from lesson_code.engine.effects.flights import can_meet
from lesson_code.engine.effects.question import Question
from lesson_code.engine.stepper import EngineStepper
from lesson_code.geometry.shapes import Circle, Polygon, Segment

ROUNDING = 1e-12
"""The numbers below are of order 1 to 100, and each is the result of a dozen operations."""

STREAMS = [Random(seed) for seed in range(100)]  # noqa: S311 - not for secrets

most_friction = task_by_id("10.1").expected
effects_called_for = task_by_id("10.2").expected
fastest_way = task_by_id("10.3").expected
box_of_flight = task_by_id("10.4").expected
bodies_asleep = task_by_id("10.5").expected


def drawn(cases: Callable[[Random], Iterable[Arguments]]) -> list[Arguments]:
    """Return what a criterion draws, over many seeds."""
    return [arguments for stream in STREAMS for arguments in cases(stream)]


def body_of(place: int, inverse_mass: float, corners: float, e: float, mu: float, w: float) -> Body:
    """Return a row of task 10.2 as a body of the engine."""
    return Body(
        Polygon.box(1, 1) if corners else Circle(0.5),
        mass=1 / inverse_mass if inverse_mass else None,
        position=(3.0 * place, 0.0),
        angular_velocity=w,
        material=Material(e, mu),
    )


# What is expected


def test_friction_expected_is_worked_by_hand() -> None:
    """0.4 and 0.9 make 0.6; a floor of 1.6 with them 1.2; two floors nothing."""
    assert most_friction((1.0, 2.0), (0.4, 0.9)) == pytest.approx(0.6, abs=ROUNDING)
    assert most_friction((1.0, 2.0, 0.0), (0.4, 0.9, 1.6)) == pytest.approx(1.2, abs=ROUNDING)
    assert most_friction((0.0, 0.0), (0.4, 0.9)) == 0.0


def test_plan_expected_is_that_of_the_engine() -> None:
    """Whatever is drawn: the same four effects as in the plan of such a scene."""
    names = ("friction", "gravity", "restitution", "rotation")
    cases = (tasks.rough_or_smooth, tasks.bouncing_or_not, tasks.turning_or_not, tasks.whole_plans)
    for bodies, gravity in [given for some in cases for given in drawn(some)[:30]]:
        scene = Scene([body_of(n, *row) for n, row in enumerate(bodies)], gravity=gravity)
        choices = choose_effects(Question(scene, combine=MIXING_RULES["workbook"]))
        planned = [c.name for c in choices if c.used and c.name in names]
        assert effects_called_for(bodies, gravity) == sorted(planned)


def test_fastest_way_expected_is_that_of_all_the_energy() -> None:
    """3 kg at 2 m/s have 6 J, with which 0.75 kg has 4 m/s; and the engine's rule says the same."""
    masses, velocities = (3.0, 0.75), ((2.0, 0.0), (0.0, 0.0))
    assert fastest_way(masses, velocities, 0.1) == pytest.approx(0.4, abs=ROUNDING)
    for masses, velocities, dt in drawn(tasks.unequal_discs)[:30]:
        discs = [
            Body(Circle(1), mass=m, velocity=v, position=(3 * n, 0))
            for n, (m, v) in enumerate(zip(masses, velocities, strict=True))
        ]
        way, _ = engine_way(Scene(discs), dt)
        assert fastest_way(masses, velocities, dt) == pytest.approx(way, rel=ROUNDING)


def test_box_expected_holds_the_flight_and_no_less() -> None:
    """Sampled finely, no point of the disc is outside, and each side is reached."""
    flights = (
        tasks.straight_flights,
        tasks.turning_points_inside,
        tasks.turning_points_outside,
    )
    fine = 1e-5  # of some metres: 2,001 samples of a parabola miss its top by less
    for cases in flights:
        for x, v, radius, g, duration in drawn(cases)[:40]:
            t = np.linspace(0, duration, 2001)[:, None]
            path = np.array(x) + np.array(v) * t + np.array(g) * t * t / 2
            low, high = path.min(axis=0) - radius, path.max(axis=0) + radius
            right = (low[0], high[0], low[1], high[1])
            np.testing.assert_allclose(box_of_flight(x, v, radius, g, duration), right, atol=fine)


def test_box_expected_is_the_one_that_the_engine_compares() -> None:
    """A ball thrown up by 1.8 m: a disc there is met if it is low enough, by the engine's rule."""
    x, v, radius, g, duration = (0.0, 0.0), (0.0, 6.0), 0.5, (0.0, -10.0), 1.0
    _, _, _, high = box_of_flight(x, v, radius, g, duration)
    assert high == pytest.approx(2.3, abs=ROUNDING)
    ball = Body(Circle(radius), mass=1.0, position=x, velocity=v)
    for gap, meets in ((-0.01, True), (0.01, False)):
        plate = Body(Circle(0.1), position=(0, high + 0.1 + gap))
        assert can_meet(Scene([ball, plate], gravity=g), duration, dt=1e-9) is meets


def test_sleep_expected_is_what_the_engine_lets_sleep() -> None:
    """Two discs at rest on a floor and one that rolls: after three seconds the engine says so."""
    rough = Material(0.0, 0.5)
    floor = Body(Segment((-50, 0), (50, 0)), material=rough)
    discs = [
        Body(Circle(0.5), mass=1.0, position=(x, 0.4999), velocity=(v, 0), material=rough)
        for x, v in ((-3.0, 0.0), (0.0, 0.0), (3.0, 1.0))
    ]
    stepper = EngineStepper(
        Scene([floor, *discs], gravity=(0, -10)),
        solver="sequential",
        dt=1 / 60,
        iterations=10,
        substeps=1,
        combine=MIXING_RULES["workbook"],
        duration=3.0,
    )
    stepper.advance(180)
    asleep = [n for n, body in enumerate(stepper.world.bodies) if body.is_asleep]
    touches = np.zeros((4, 4))
    touches[0, 1:] = touches[1:, 0] = 1
    assert asleep == bodies_asleep((0.0, 1.0, 1.0, 1.0), (1, 1, 1, 0), touches) == [1, 2]


# What is drawn


@pytest.mark.parametrize("name", ["friction", "restitution", "rotation"])
def test_drawn_plans_have_both_answers_for_each_effect(name: str) -> None:
    """Who always says yes, or always no, earns nothing."""
    cases: dict[str, Any] = {
        "friction": tasks.rough_or_smooth,
        "restitution": tasks.bouncing_or_not,
        "rotation": tasks.turning_or_not,
    }
    for stream in STREAMS:
        answers = {name in effects_called_for(*given) for given in cases[name](stream)}
        assert answers == {True, False}


def test_drawn_whole_plans_differ() -> None:
    """Each seed draws at least three different plans, with and without gravity."""
    for stream in STREAMS:
        plans = {tuple(effects_called_for(*given)) for given in tasks.whole_plans(stream)}
        assert len(plans) >= 3
        assert {"gravity" in plan for plan in plans} == {True, False}


def test_drawn_piles_sleep_in_part() -> None:
    """In each criterion somebody sleeps, and in each some still body is kept awake."""
    for cases in (tasks.one_pile, tasks.piles_on_one_floor, tasks.long_chains):
        for stream in STREAMS:
            kept = slept = 0
            for inverse_masses, still, touches in cases(stream):
                asleep = bodies_asleep(inverse_masses, still, touches)
                slept += len(asleep)
                kept += sum(still) - 1 - len(asleep)  # the floor is still, and never asleep
            assert slept > 0
            assert kept > 0


def test_drawn_flights_turn_where_they_should() -> None:
    """Within the time in one criterion, and not within it in the other."""

    def turns(given: Arguments) -> bool:
        _, v, _, g, duration = given
        return any(a != 0 and 0 < -s / a < duration for s, a in zip(v, g, strict=True))

    assert all(map(turns, drawn(tasks.turning_points_inside)))
    assert not any(map(turns, drawn(tasks.turning_points_outside)))


# What is said


def test_messages_say_why() -> None:
    """Each says in numbers what the answer hangs on."""
    said = tasks.pairs_that_can_meet(((1.0, 0.0, 0.0), (0.4, 0.9, 0.1)), None)
    assert said == "Pairs of which one can be pushed: 0 and 1: 0.6, 0 and 2: 0.2."
    said = tasks.energy_of_all(((3.0, 0.75), ((2.0, 0.0), (0.0, 0.0)), 0.1), None)
    assert said == "All bodies together have 6 J; the lightest has 0.75 kg."
    flight: Arguments = ((0.0, 0.0), (1.0, 5.0), 0.5, (0.0, -10.0), 2.0)
    assert tasks.turning_times(flight, None) == (
        "It turns back at: 0.5 s; the flight lasts from 0 to 2.0 s."
    )
    assert "never" in tasks.turning_times((*flight[:3], (0.0, 0.0), 2.0), None)
    touches = ((0, 1, 1), (1, 0, 1), (1, 1, 0))
    said = tasks.islands_in_words(((0.0, 1.0, 1.0), (1, 1, 0), touches), None)
    assert said == "Moving: 2. Touching, the floor left out: 1-2."
    assert math.isclose(most_friction((1.0, 0.0, 0.0), (0.4, 0.9, 0.1)), 0.6)
