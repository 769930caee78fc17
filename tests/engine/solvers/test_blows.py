"""Scenes in which contacts pass blows alone: what is elastic and smooth keeps its energy."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from tiers import share

from lesson_code import Body, Circle, Material, Polygon, Scene, Segment, simulate
from lesson_code.engine.core.mixing import MixingRule
from lesson_code.engine.effects.question import Question
from lesson_code.engine.solvers.choice import passes_only_blows
from lesson_code.engine.stepper import EngineStepper
from lesson_code.evidence.hard_cases.bounces import ELASTIC
from lesson_code.evidence.hard_cases.heaps import KINDS, poured
from lesson_code.evidence.hard_cases.measures import free
from lesson_code.evidence.hard_cases.parameters import Draw, seeded

BALL = Body(Circle(1), mass=1.0, position=(0, 2), material=ELASTIC)
FLOOR = Body(Segment((-9, 0), (9, 0)), material=ELASTIC)
DOWN = (0.0, -9.81)


@pytest.mark.parametrize("seed", range(share(18)))
def test_elastic_shapes_that_fall_keep_their_energy_in_every_step(seed: int) -> None:
    """Of any kind and size, in steps of 2 to 30 ms; none passes a wall or the floor.

    Over the walls some do go: thrown by heavier ones.
    """
    draw = Draw(seeded("blows", seed))
    heap, dt = poured(draw, ELASTIC, kinds=KINDS[1:]), draw.log_uniform("dt", 2e-3, 3e-2)
    run = simulate(heap.scene, 2.0, dt=dt, solver="substep")
    assert np.abs(run.energy / run.energy[0] - 1).max() < 1e-11
    x, y = np.moveaxis(run.positions[:, free(heap.scene)], -1, 0)
    top = max(body.shape.start[1] for body in heap.scene.bodies if body.is_static)
    has_been_above = np.maximum.accumulate(y, axis=0) > top
    assert (has_been_above | ((x > 0) & (x < heap.width) & (y > 0))).all()


@pytest.mark.parametrize("seed", range(share(6)))
def test_record_holds_all_blows(seed: int) -> None:
    """What gravity gives and the walls take is the change of momentum, body by body."""
    heap = poured(Draw(seeded("blows recorded", seed)), ELASTIC, kinds=KINDS[1:])
    run = simulate(heap.scene, 1.5, solver="substep")
    hits, masses = run.contacts, heap.scene.columns.mass[:, None]
    received = np.zeros((len(heap.scene.bodies), 2))
    np.add.at(received, hits.body_b, hits.normal_impulse[:, None] * hits.normal)
    np.add.at(received, hits.body_a, -hits.normal_impulse[:, None] * hits.normal)
    pushed = free(heap.scene)
    change = (run.velocities[-1] - run.velocities[0] - 1.5 * np.array(heap.scene.gravity))[pushed]
    most = np.abs(received[pushed]).max()
    np.testing.assert_allclose(masses[pushed] * change, received[pushed], rtol=0, atol=1e-11 * most)


def test_box_that_falls_flat_does_not_begin_to_turn() -> None:
    """Both points of its manifold bounce at once, again and again."""
    box = Body(Polygon.box(2, 1), mass=1.0, position=(0, 3), material=ELASTIC)
    run = simulate(Scene([box, FLOOR], gravity=DOWN), 10.0, solver="substep")
    assert np.abs(run.angles[:, 0]).max() < 1e-9
    late = run.positions[run.times > 8, 0, 1]
    assert late.max() == pytest.approx(3.0, abs=0.01)  # it is seen in frames, not at its highest


def test_crowd_without_gravity_keeps_energy_and_both_momenta() -> None:
    """Boxes that overlap at the start are pushed apart first, which costs nothing."""
    rng = np.random.default_rng(3)
    boxes = [
        Body(
            Polygon.box(1, 0.6),
            mass=float(10 ** rng.uniform(-1, 1)),
            position=(0.9 * (n % 6), 0.9 * (n // 6)),
            angle=float(rng.uniform(0, math.pi)),
            velocity=tuple(rng.normal(0, 2, 2)),
            material=ELASTIC,
        )
        for n in range(36)
    ]
    run = simulate(Scene(boxes), 3.0, solver="substep")
    assert run.kinetic_energy == pytest.approx(run.kinetic_energy[0], rel=1e-11)
    momentum = np.array([body.mass for body in boxes]) @ run.velocities[-1]
    start = np.array([body.mass for body in boxes]) @ run.velocities[0]
    assert momentum == pytest.approx(start, abs=1e-11)


@pytest.mark.parametrize(
    "bodies",
    [
        [replace(BALL, material=Material(0.9, 0.0)), FLOOR],
        [replace(BALL, material=Material(1.0, 0.1)), replace(FLOOR, material=Material(1.0, 0.1))],
        [BALL, replace(FLOOR, velocity=(0.0, 1.0))],
        [replace(BALL, position=(0, 1)), FLOOR],
    ],
    ids=["loses", "rubs", "has a mover", "stands"],
)
def test_springs_stay_where_something_comes_to_rest(bodies: list[Body]) -> None:
    """Or may: then contacts have to carry."""
    assert not passes_only_blows(Question(Scene(bodies, gravity=DOWN)))


def test_ball_that_falls_passes_blows_alone_and_one_without_gravity_too() -> None:
    """Elastic, smooth, and nobody stands."""
    assert passes_only_blows(Question(Scene([BALL, FLOOR], gravity=DOWN)))
    assert passes_only_blows(Question(Scene([replace(BALL, position=(0, 1)), FLOOR])))
    assert not passes_only_blows(Question(Scene([BALL, FLOOR], gravity=DOWN, damping=0.1)))


def test_stepper_by_hand_has_springs() -> None:
    """As in a page: something that takes energy may come. A run knows that nothing does."""
    stepper = EngineStepper(
        Scene([BALL, FLOOR], gravity=DOWN),
        solver="substep",
        dt=1 / 60,
        iterations=1,
        substeps=4,
        combine=MixingRule(),
    )
    assert stepper.needs_no_springs()
    assert not stepper.world.state.only_blows
    stepper.set_gravity((0.0, 0.0))
    assert stepper.needs_no_springs()
