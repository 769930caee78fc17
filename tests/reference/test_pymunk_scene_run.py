"""A scene stepped by pymunk: each convention of ours arrives there as what it means."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from lesson_code import Body, Circle, Material, Polygon, Scene, Segment, simulate
from lesson_code.engine.core.mixing import mixing_rule
from lesson_code.evidence.scenes import rigid_bodies as scenes
from lesson_code.evidence.scenes.discs import row_of_discs
from lesson_code.reference.pymunk_reference import PymunkStepper

ROUNDING = 1e-12
"""Some 60 steps, each with a rounding of 1e-16 of numbers near 1."""


def stepper(scene: Scene, combine: str = "workbook", **settings: Any) -> PymunkStepper:
    """Return pymunk at work on a scene, in steps of 1/60 s."""
    usual = {"dt": 1 / 60, "iterations": 10, "substeps": 1, "combine": mixing_rule(combine)}
    return PymunkStepper(scene, **(usual | settings))


def head_on(first: Material, second: Material) -> Scene:
    """Two equal discs of 1 kg; the first comes from the left at 1 m/s and meets the other."""
    return Scene(
        [
            Body(Circle(1), mass=1.0, velocity=(1, 0), position=(-1.01, 0), material=first),
            Body(Circle(1), mass=1.0, position=(1, 0), material=second),
        ]
    )


@pytest.mark.parametrize(
    ("combine", "restitution"), [("workbook", 0.4), ("pymunk", 0.32), ("box2d", 0.8)]
)
def test_restitution_of_a_pair_is_ours_not_pymunks_product(
    combine: str, restitution: float
) -> None:
    """0.4 and 0.8: the smaller, the product or the larger, as we ask; separation over approach."""
    scene = head_on(Material(0.4), Material(0.8))
    run = simulate(scene, 0.5, solver="pymunk", combine=combine)
    v1, v2 = run.velocities[-1, :, 0]
    assert v2 - v1 == pytest.approx(restitution, abs=ROUNDING)


@pytest.mark.parametrize(
    ("first", "second", "restitution"),
    [
        (Material(0.4), Material(), 0.4),
        (Material(), Material(0.4), 0.4),
        (Material(), Material(), 0.0),
    ],
    ids=["only the first", "only the second", "neither"],
)
def test_restitution_left_to_the_other_body_is_the_other_bodys(
    first: Material, second: Material, restitution: float
) -> None:
    """A coefficient of None takes the other's; where neither says anything it is 0."""
    run = simulate(head_on(first, second), 0.5, solver="pymunk")
    v1, v2 = run.velocities[-1, :, 0]
    assert v2 - v1 == pytest.approx(restitution, abs=ROUNDING)


def test_pymunks_own_product_is_used_without_a_callback() -> None:
    """Where the product is right for all pairs, pymunk is not slowed by a call for each contact."""
    scene = head_on(Material(0.4, 0.5), Material(0.8, 0.5))
    assert not stepper(scene, combine="pymunk").corrects_coefficients
    assert stepper(scene, combine="workbook").corrects_coefficients


def test_run_without_impulses_is_the_same_run() -> None:
    """Nothing is written down, no contact is called for, and not one bit of the run differs."""
    scene = scenes.box_pyramid(4, friction=0.5625)
    kept, lean = stepper(scene), stepper(scene, keep_impulses=False)
    for engine in (kept, lean):
        engine.advance(60)
    assert not lean.corrects_coefficients
    assert kept.states().tobytes() == lean.states().tobytes()
    assert len(kept.events()) > 0
    assert lean.events().shape == (0, 10)
    assert lean.visited == []


def test_advance_makes_many_steps_in_one_call() -> None:
    """And leaves the bodies where as many single steps do."""
    at_once, singly = stepper(scenes.box_stack(3)), stepper(scenes.box_stack(3))
    at_once.advance(30)
    for _ in range(30):
        singly.advance(1)
    assert at_once.states().tobytes() == singly.states().tobytes()


def test_broad_phases_find_the_same_contacts() -> None:
    """Pymunk's hash meets the pairs in another order, but a row of discs has but one."""
    scene = row_of_discs(12, gap=0.1)
    tree, grid = stepper(scene), stepper(scene, broad_phase="hash")
    for engine in (tree, grid):
        engine.advance(300)
    assert tree.states()[-1][3] > 0.5
    np.testing.assert_allclose(tree.states(), grid.states(), rtol=0, atol=ROUNDING)


@pytest.mark.parametrize(("slop", "depth"), [(None, 0.1), (0.005, 0.005)])
def test_disc_rests_at_the_slop_that_is_asked_for(slop: float | None, depth: float) -> None:
    """It is pushed out of the floor as far as that; pymunk's own is a tenth of a metre."""
    ball = Body(Circle(0.5), position=(0, 0.3), mass=1.0)
    resting = stepper(Scene([Body(Segment((-9, 0), (9, 0))), ball], gravity=(0, -10)), slop=slop)
    resting.advance(600)
    assert 0.5 - resting.states()[1][1] == pytest.approx(depth, rel=0.05)


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"slop": -0.1}, "slop must be >= 0 and finite, got -0.1"),
        ({"slop": math.nan}, "slop must be >= 0 and finite, got nan"),
        ({"broad_phase": "grid"}, "broad_phase must be tree or hash, got 'grid'"),
    ],
)
def test_setting_out_of_range_is_refused_by_name(wrong: dict[str, Any], message: str) -> None:
    """Before pymunk sees it, which would end the process or go on with nan."""
    with pytest.raises(ValueError, match=message):
        stepper(Scene(), **wrong)


def test_static_body_with_a_velocity_keeps_it() -> None:
    """It is kinematic in pymunk: it pushes, and is not pushed."""
    wall = Body(Segment((0, -5), (0, 5)), velocity=(2, 0))
    ball = Body(Circle(1), position=(2, 0), mass=1.0, material=Material(1.0))
    run = simulate(Scene([wall, ball]), 1.0, solver="pymunk")
    assert run.velocities[-1, 0].tolist() == [2, 0]
    assert run.positions[-1, 0] == pytest.approx([2, 0], abs=ROUNDING)
    assert run.velocities[-1, 1] == pytest.approx([4, 0], abs=ROUNDING)


def test_damping_rate_means_the_same_in_both_engines() -> None:
    """After 1 s at a rate of 0.7/s, the share exp(-0.7) of the speed is left."""
    scene = Scene([Body(Circle(1), mass=1.0, velocity=(3, 0), angular_velocity=2)], damping=0.7)
    for solver in ("pymunk", "sequential"):
        run = simulate(scene, 1.0, solver=solver)
        assert run.velocities[-1, 0, 0] == pytest.approx(3 * math.exp(-0.7), abs=ROUNDING)
        assert run.angular_velocities[-1, 0] == pytest.approx(2 * math.exp(-0.7), abs=ROUNDING)


def test_impulse_events_have_our_normal_and_our_sign() -> None:
    """The normal goes from a to b, the impulse is what b received, and momentum agrees with it."""
    floor = Body(Segment((-9, 0), (9, 0)))
    box = Body(
        Polygon.box(2, 1),
        position=(0, 0.51),
        velocity=(1, -2),
        mass=3.0,
        material=Material(0.5, 0.1),
    )
    for bodies in ([floor, box], [box, floor]):
        run = simulate(Scene(bodies), 0.1, solver="pymunk")
        events, moving = run.contacts, bodies.index(box)
        assert (events.body_a == 0).all()
        assert (events.body_b == 1).all()
        up = 1 if moving == 1 else -1
        assert events.normal == pytest.approx(np.tile([0, up], (len(events), 1)), abs=ROUNDING)
        tangents = np.column_stack((-events.normal[:, 1], events.normal[:, 0]))
        received = (
            events.normal_impulse[:, None] * events.normal
            + events.tangent_impulse[:, None] * tangents
        ).sum(axis=0)
        gained = run.momentum[-1] - run.momentum[0]
        assert up * received == pytest.approx(gained, abs=ROUNDING)


def test_polygons_mass_and_inertia_are_ours() -> None:
    """They are given to pymunk, not derived from its outline."""
    body = Body(Polygon.box(2, 1), mass=3.0, inertia=7.0)
    (theirs,) = stepper(Scene([body])).bodies
    assert (theirs.mass, theirs.moment) == (3.0, 7.0)


def test_substeps_are_steps_of_a_part_of_dt() -> None:
    """Four sub-steps of dt/4 end where four steps of dt/4 do."""
    scene = Scene([Body(Circle(1), mass=1.0, velocity=(3, 5))], gravity=(0, -10))
    coarse = simulate(scene, 0.5, solver="pymunk", dt=1 / 20, substeps=4)
    fine = simulate(scene, 0.5, solver="pymunk", dt=1 / 80)
    assert coarse.positions[-1] == pytest.approx(fine.positions[-1], abs=ROUNDING)


def test_scene_of_pymunk_and_ours_give_the_same_run_until_contacts_are_shared() -> None:
    """One bouncing, spinning ball on a floor: the first two seconds agree, contacts included."""
    rubber = Material(0.8, 0.3)
    ball = Body(Circle(0.5), position=(0, 2), velocity=(1, 0), mass=1.0, material=rubber)
    scene = Scene([ball, Body(Segment((-10, 0), (10, 0)))], gravity=(0, -9.81))
    ours, theirs = (simulate(scene, 2.0, solver=solver) for solver in ("sequential", "pymunk"))
    assert ours.positions == pytest.approx(theirs.positions, abs=ROUNDING)
    assert ours.velocities == pytest.approx(theirs.velocities, abs=ROUNDING)
    assert ours.contacts.normal_impulse == pytest.approx(
        theirs.contacts.normal_impulse, abs=ROUNDING
    )
    assert ours.contacts.point == pytest.approx(theirs.contacts.point, abs=ROUNDING)


def test_forgotten_contacts_are_gone() -> None:
    """Boxes that lay on each other have none left."""
    run = stepper(scenes.box_stack(2, 0.5))
    run.advance(5)
    assert touching(run) > 0
    run.forget_contacts()
    assert touching(run) == 0


def touching(run: PymunkStepper) -> int:
    """Return how many contacts the space keeps, each counted for either body."""
    found: list[Any] = []
    for body in run.bodies:
        body.each_arbiter(found.append)
    return len(found)
