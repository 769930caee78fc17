"""Sequential impulses: single impacts against closed forms, resting contacts, the push, memory."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import Phase, assume, given, settings
from hypothesis import strategies as st
from tiers import share

from lesson_code import Body, Circle, Material, MixingRule, Polygon, Scene, Segment, simulate
from lesson_code.engine.core.capacity import add_capacity
from lesson_code.engine.core.constants import BAUMGARTE_FACTOR, LEAST_EXCESS, SLOP
from lesson_code.engine.core.rows import BodyRow, ContactRow
from lesson_code.engine.core.tables import world_of
from lesson_code.engine.solvers.sequential import (
    has_overlap_to_undo,
    pseudo_speed_of,
    recall,
    store,
)
from lesson_code.engine.stepper import EngineStepper
from lesson_code.reference.contact_closed_forms import Struck, impact_with_friction

ROUNDING = 1e-13
"""Of speeds of some m/s: a few dozen operations, each right to 1e-16."""

CONVERGED = 1e-9
"""m/s: after 1000 sweeps normal and tangent impulse of a corner agree, where they come together."""

TINY_STEP = 1e-12
"""s: in so short a step bodies hit where they are; their turning adds less than 1e-11."""

seeds = st.integers(0, 10**9)
restitutions = st.floats(0, 1)
frictions = st.floats(0, 2)
masses = st.floats(1e-3, 1e3)
radii = st.floats(0.1, 10)


def engine(scene: Scene, dt: float = 1 / 60, iterations: int = 10) -> EngineStepper:
    """Return the engine at work on a scene."""
    rule = MixingRule("max", "max")
    return EngineStepper(
        scene, solver="sequential", dt=dt, iterations=iterations, substeps=1, combine=rule
    )


# What is remembered


@pytest.mark.parametrize("seed", range(share(6)))
def test_blow_is_no_force_that_is_remembered(seed: int) -> None:
    """Thin capsules that are poured into a bin strike within microseconds, and gain no energy.

    When blows were given again in the longer parts of a step that followed, the energy rose by 189
    times. The first step of a fall adds a percent, as positions come before velocities.
    """
    rng = np.random.default_rng(seed)
    surface, radius = Material(rng.uniform(0, 0.5), rng.uniform(0, 0.8)), rng.uniform(0.03, 0.05)
    walls = [Segment((-4, 0), (4, 0)), Segment((-4, 0), (-4, 60)), Segment((4, 0), (4, 60))]
    capsules = [
        Body(
            Segment((-0.32, 0), (0.32, 0), radius=radius),
            mass=1.0,
            material=surface,
            position=((n % 7 - 3) * 1.05, (n // 7 + 0.6) * 1.05),
            angle=rng.uniform(0, math.pi),
        )
        for n in range(26)
    ]
    bodies = [Body(wall, material=surface) for wall in walls] + capsules
    run = simulate(Scene(bodies, gravity=(0, -9.81)), 3.0, solver="sequential")
    assert run.energy.max() < 1.02 * run.energy[0]


# One impact of two discs


@settings(max_examples=share(200), phases=[Phase.explicit, Phase.generate])
@given(seeds, masses, masses, radii, radii, restitutions, frictions, st.integers(1, 5))
def test_impact_of_two_discs_is_the_closed_form_at_the_moved_places(
    seed: int, ma: float, mb: float, ra: float, rb: float, e: float, mu: float, iterations: int
) -> None:
    """A normal through both centres separates the two equations: one sweep is enough.

    jn = -(1 + e) vn / (1/ma + 1/mb);  jt = -vt / (3/ma + 3/mb), at most mu jn: a disc's r^2 / I
    is 2/m. The normal is that of the places *after* the step's motion.
    """
    rng = np.random.default_rng(seed)
    dt = 1e-3  # nothing moves by half of its width: the step is made in one part
    way = rng.uniform(-math.pi, math.pi)
    places = np.array([(0, 0), (ra + rb) * np.array([math.cos(way), math.sin(way)])])
    v, w = rng.uniform(-5, 5, (2, 2)), rng.uniform(-5, 5, 2)
    n = places[1] + v[1] * dt - places[0] - v[0] * dt
    assume(0.05 * (ra + rb) < np.hypot(*n) < ra + rb)
    n /= np.hypot(*n)
    t = np.array([-n[1], n[0]])
    vn, vt = (v[1] - v[0]) @ n, (v[1] - v[0]) @ t - w[0] * ra - w[1] * rb
    assume(vn < 0)
    jn = -(1 + e) * vn / (1 / ma + 1 / mb)
    jt = float(np.clip(-vt / (3 / ma + 3 / mb), -mu * jn, mu * jn))
    j = jn * n + jt * t
    expected = [v[0] - j / ma, v[1] + j / mb]
    spins = [w[0] - jt * 2 / (ma * ra), w[1] - jt * 2 / (mb * rb)]

    bodies = [
        Body(
            Circle(r), mass=m, position=p, velocity=u, angular_velocity=s, material=Material(e, mu)
        )
        for r, m, p, u, s in zip((ra, rb), (ma, mb), places, v, w, strict=True)
    ]
    run = simulate(Scene(bodies), dt, dt=dt, iterations=iterations, solver="sequential")
    scale = 10 * ROUNDING * max(1, 1 / min(ra, rb))
    np.testing.assert_allclose(run.velocities[1], expected, atol=scale)
    np.testing.assert_allclose(run.angular_velocities[1], spins, atol=10 * scale / min(ra, rb))
    assert run.contacts.normal_impulse[0] == pytest.approx(jn, rel=10 * ROUNDING)


HEAD_ON = {
    "equal masses exchange": ((1, 2.0), (1, -1.0), 1.0, (-1.0, 2.0)),
    "1 and 3 kg, e = 0.7": ((1, 2.0), (3, -1.0), 0.7, (-1.825, 0.275)),
    "sticking": ((1, 3.0), (2, 0.0), 0.0, (1.0, 1.0)),
    "against a wall": ((2, 4.0), (None, 0.0), 0.5, (-2.0, 0.0)),
    "against a wall that comes": ((2, 0.0), (None, -1.0), 1.0, (-2.0, -1.0)),
}


@pytest.mark.parametrize(("a", "b", "e", "after"), HEAD_ON.values(), ids=HEAD_ON)
def test_impact_head_on_worked_by_hand_is_found(a: Any, b: Any, e: float, after: Any) -> None:
    """The table of chapter 02, now in two dimensions and in a step."""
    bodies = [
        Body(Circle(0.5), mass=m, position=(x, 0), velocity=(v, 0), material=Material(e))
        for x, (m, v) in ((0, a), (1, b))
    ]
    run = simulate(Scene(bodies), 0.01, dt=0.01, solver="sequential")
    np.testing.assert_allclose(run.velocities[-1, :, 0], after, atol=10 * ROUNDING)


def test_impact_of_bodies_that_part_is_none() -> None:
    """Overlapping, but on their way apart: nothing to do, to the last bit."""
    bodies = [
        Body(Circle(0.5), mass=1, position=(x, 0), velocity=(v, 3), angular_velocity=v)
        for x, v in ((0, -1.0), (0.9, 1.0))
    ]
    run = simulate(Scene(bodies), 0.01, dt=0.01, solver="sequential")
    np.testing.assert_array_equal(run.velocities[1], run.velocities[0])
    assert len(run.contacts) == 0


def test_impact_twice_in_the_overlap_happens_once() -> None:
    """In the next step they still overlap, but part: the warm start is taken back again."""
    bodies = [
        Body(Circle(0.5), mass=m, position=(x, 0), velocity=(v, 0), material=Material(0.2))
        for x, v, m in ((0, 2, 1), (0.95, -1, 3))
    ]
    run = simulate(Scene(bodies), 0.02, dt=0.01, solver="sequential")
    assert run.max_penetration[1] > run.max_penetration[2] > 0
    np.testing.assert_allclose(run.velocities[2], run.velocities[1], atol=10 * ROUNDING)
    assert run.contacts.time.tolist() == [0.01]


# One impact of a corner


@settings(max_examples=share(60), phases=[Phase.explicit, Phase.generate])
@given(seed=seeds, e=restitutions, mu=frictions)
def test_impact_of_a_corner_is_the_closed_form(seed: int, e: float, mu: float) -> None:
    """A box hits with a corner: normal and tangent are coupled, and many sweeps solve both.

    (Where mu abs(knt) >= knn a sliding corner makes the sweeps swing for ever; left out here.)
    """
    rng = np.random.default_rng(seed)
    floor = Body(Segment((-9, 0), (9, 0)), material=Material(e, mu))
    box = Polygon.box(rng.uniform(0.2, 2), rng.uniform(0.2, 2))
    angle = rng.uniform(-3, 3)
    c, s = math.cos(angle), math.sin(angle)
    corners = np.array(box.outline) @ [[c, s], [-s, c]]
    heights = np.sort(corners[:, 1])
    assume(heights[1] - heights[0] > 1e-3)
    mass = rng.uniform(0.1, 10)
    body = Body(
        box, mass=mass, position=(0, -1e-6 - heights[0]), angle=angle,
        velocity=rng.uniform(-5, 5, 2), angular_velocity=rng.uniform(-5, 5),
    )  # fmt: skip
    arm = corners[np.argmin(corners[:, 1])]
    inverse_inertia = 1 / float(body.inertia or 0)
    knn = 1 / mass + arm[0] ** 2 * inverse_inertia
    knt = -arm[0] * arm[1] * inverse_inertia
    assume(mu * abs(knt) < 0.9 * knn)
    still = Struck(0.0, 0.0, (0, 0), 0.0, (0, 0))
    struck = Struck(1 / mass, inverse_inertia, body.velocity, body.angular_velocity, arm)
    expected = impact_with_friction(still, struck, (0, 1), e, mu)

    run = simulate(
        Scene([floor, body]), TINY_STEP, dt=TINY_STEP, iterations=1000, solver="sequential"
    )
    np.testing.assert_allclose(run.velocities[1, 1], expected.velocities[1], atol=CONVERGED)
    spin = expected.angular_velocities[1]
    assert run.angular_velocities[1, 1] == pytest.approx(spin, abs=10 * CONVERGED)


# Two points at once


@pytest.mark.parametrize(("width", "height"), [(1, 1), (10, 1), (1, 10), (30, 1), (1, 30)])
@pytest.mark.parametrize("e", [0.0, 0.5, 1.0])
def test_landing_flat_on_two_points_is_exact_in_one_sweep(
    width: float, height: float, e: float
) -> None:
    """Both corners stop or bounce together: the box does not turn, whatever its shape."""
    floor = Body(Segment((-50, 0), (50, 0)))
    box = Body(
        Polygon.box(width, height), mass=2, position=(0.3, height / 2 - 1e-6), velocity=(0, -1),
        material=Material(e, 0),
    )  # fmt: skip
    run = simulate(Scene([floor, box]), TINY_STEP, dt=TINY_STEP, iterations=1, solver="sequential")
    assert len(run.contacts) == 2
    assert run.velocities[1, 1, 1] == pytest.approx(e, abs=100 * ROUNDING)
    assert run.angular_velocities[1, 1] == pytest.approx(0, abs=100 * ROUNDING)


# Warm starting


def test_resting_stack_of_discs_in_a_pipe_finds_its_forces_over_many_steps() -> None:
    """One sweep a step is enough in time: each contact begins where the last step ended.

    The k-th contact from the top carries k discs: k m g dt.
    """
    pipe = [Segment((x, -1), (x, 9)) for x in (-0.5, 0.5)]
    walls = [Body(shape, material=Material(friction=0)) for shape in pipe]
    floor = Body(Segment((-1, 0), (1, 0)))
    discs = [Body(Circle(0.5), mass=2, position=(0, 0.499 + 0.998 * k)) for k in range(5)]
    run = simulate(
        Scene([*walls, floor, *discs], gravity=(0, -10)), 5.0, iterations=1, solver="sequential"
    )
    last = run.contacts.normal_impulse[run.contacts.time > 4.99]
    forces = sorted(last / (2 * 10 / 60))
    np.testing.assert_allclose(forces, [1, 2, 3, 4, 5], rtol=1e-6)


@given(
    st.lists(st.tuples(*[st.integers(0, 3)] * 3), unique=True, max_size=12),
    st.lists(st.tuples(*[st.integers(0, 3)] * 3), unique=True, max_size=12),
)
def test_impulses_of_the_last_step_are_found_by_bodies_and_feature(
    old: list[tuple[int, int, int]], new: list[tuple[int, int, int]]
) -> None:
    """The merge of two sorted tables, against a dictionary; what is new begins at 0."""
    world = world_of(Scene([Body(Circle(1), mass=1)]), 0.01, 1, MixingRule())
    world.state.contacts_wanted = 12
    add_capacity(world)
    memory = {key: (1.0 + n, -1.0 - n) for n, key in enumerate(sorted(old))}
    for row, (key, impulses) in zip(world.memory, memory.items(), strict=False):
        row.a, row.b, row.feature = key
        row.normal_impulse, row.tangent_impulse = impulses
    for contact, key in zip(world.contacts, sorted(new), strict=False):
        contact.a, contact.b, contact.feature = key
    world.state.memory_count, world.state.contact_count = len(old), len(new)
    recall(world)
    found = [(c.normal_impulse, c.tangent_impulse) for c in world.contacts[: len(new)]]
    assert found == [memory.get(key, (0.0, 0.0)) for key in sorted(new)]


def test_impulses_are_remembered_as_they_are() -> None:
    """Stored, they come back in the next step for the same bodies and feature."""
    world = world_of(Scene([Body(Circle(1), mass=1)]), 0.01, 1, MixingRule())
    world.state.contacts_wanted = 3
    add_capacity(world)
    for n, contact in enumerate(world.contacts[:3]):
        contact.a, contact.b, contact.feature = 0, 1 + n // 2, n
        contact.normal_impulse, contact.tangent_impulse = 3.0 + n, -1.0 - n
    world.state.contact_count = 3
    store(world)
    for contact in world.contacts:
        contact.normal_impulse = contact.tangent_impulse = 0.0
    recall(world)
    assert [c.normal_impulse for c in world.contacts[:3]] == [3.0, 4.0, 5.0]
    assert [c.tangent_impulse for c in world.contacts[:3]] == [-1.0, -2.0, -3.0]


# The push out of an overlap


def overlapping(overlap: float, mass_b: float | None = 1.0, size: float = 1.0) -> Scene:
    """Return two discs at rest that overlap."""
    return Scene(
        [
            Body(Circle(size), mass=3),
            Body(Circle(size), mass=mass_b, position=(2 * size - overlap, 0)),
        ]
    )


@pytest.mark.parametrize("mass_b", [1.0, 100.0, None], ids=["lighter", "heavier", "static"])
def test_overlap_beyond_the_slop_shrinks_by_the_same_share_in_each_step(
    mass_b: float | None,
) -> None:
    """(overlap - slop) is multiplied by 0.8, and no body gets a velocity from it, to the bit."""
    run = simulate(overlapping(0.1, mass_b), 0.5, solver="sequential")
    slop = SLOP * 2.0
    steps = np.arange(30)
    expected = slop + (0.1 - slop) * (1 - BAUMGARTE_FACTOR) ** steps
    np.testing.assert_allclose(run.max_penetration[1:], expected, atol=ROUNDING)
    assert not run.velocities.any()
    assert not run.angular_velocities.any()


def test_overlap_is_shared_in_inverse_proportion_to_the_masses() -> None:
    """3 kg and 1 kg: the lighter moves three times as far, and the centre of mass stays."""
    run = simulate(overlapping(0.1), 1.0, solver="sequential")
    ways = run.positions[-1, :, 0] - run.positions[0, :, 0]
    assert ways[1] / ways[0] == pytest.approx(-3, rel=1e-12)


@pytest.mark.parametrize("size", [1e-3, 1.0, 1e3])
def test_overlap_within_the_slop_is_left_alone(size: float) -> None:
    """0.5 % of the width, be it a grain or a house: not a bit of the state changes."""
    run = simulate(overlapping(0.99 * SLOP * 2 * size, size=size), 0.5, solver="sequential")
    assert (run.positions == run.positions[0]).all()
    moved = simulate(overlapping(1.5 * SLOP * 2 * size, size=size), 0.5, solver="sequential")
    assert (moved.positions[-1] != moved.positions[0]).any()


def test_overlap_of_bodies_that_part_by_themselves_is_not_pushed() -> None:
    """Fast enough apart: they move by their velocities and by nothing else."""
    bodies = [
        Body(Circle(1), mass=1, position=(x, 0), velocity=(v, 0))
        for x, v in ((0, -1.0), (1.9, 1.0))
    ]
    run = simulate(Scene(bodies), 0.1, solver="sequential")
    np.testing.assert_allclose(run.positions[:, 1, 0], 1.9 + run.times, atol=ROUNDING)


@pytest.mark.parametrize(
    ("vn", "left"),
    [(0.0, 2.0), (0.5, 1.5), (5.0, -3.0), (-5.0, 2.0)],
    ids=["all", "some by itself", "leaves by itself", "approach does not count"],
)
def test_push_speed_is_less_by_what_the_bodies_do_themselves(vn: float, left: float) -> None:
    """The overlap is to be undone at 2 m/s; a negative speed asks for no push at all."""
    world = world_of(Scene([Body(Circle(1), mass=1)] * 2), 0.01, 1, MixingRule())
    world.contacts.append(ContactRow(a=0, b=1, nx=1.0, pseudo_speed=2.0))
    world.state.contact_count = 1
    world.bodies[1].vx = vn
    assert has_overlap_to_undo(world)
    assert world.contacts[0].pseudo_speed == left


def test_overlaps_that_are_all_left_alone_are_none_to_undo() -> None:
    """And the contacts stay as they are."""
    world = world_of(Scene([Body(Circle(1), mass=1)] * 2), 0.01, 1, MixingRule())
    world.contacts.extend(ContactRow(a=0, b=1, nx=1.0) for _ in range(3))
    world.bodies[1].vx = 1.0
    assert not has_overlap_to_undo(world)
    world.state.contact_count = 3
    assert not has_overlap_to_undo(world)
    assert [c.pseudo_speed for c in world.contacts] == [0.0, 0.0, 0.0]


@pytest.mark.parametrize("min_width", [1e-3, 1.0, 1e3])
@pytest.mark.parametrize(("excess", "share"), [(0.0, 0), (0.99, 0), (1.01, 1), (50, 1)])
def test_overlap_is_undone_only_beyond_a_hundredth_of_the_slop(
    min_width: float, excess: float, share: int
) -> None:
    """Beyond it the whole excess over the slop counts: BAUMGARTE_FACTOR of it in a step."""
    slop = SLOP * min_width
    over = excess * LEAST_EXCESS * slop
    c = ContactRow(penetration=slop + over)
    a, b = BodyRow(min_width=min_width), BodyRow(min_width=2 * min_width)
    speed = pseudo_speed_of(c, a, b, dt=0.25)
    assert speed == pytest.approx(share * BAUMGARTE_FACTOR * over / 0.25, rel=1e-9)


def test_overlap_of_coincident_discs_is_undone_along_x() -> None:
    """Discs in one place have the normal (1, 0); without speed they slip apart and stop.

    They stop when they overlap by the slop and no more than a hundredth of it.
    """
    run = simulate(
        Scene([Body(Circle(1), mass=1), Body(Circle(1), mass=1)]), 2.0, solver="sequential"
    )
    (left, right), slop = run.positions[-1], SLOP * 2.0
    assert (left[1], right[1], right[0]) == (0, 0, -left[0])
    assert slop <= 2.0 - (right[0] - left[0]) <= slop * (1 + LEAST_EXCESS)
    assert not run.velocities.any()


def test_push_of_a_step_is_spent_after_the_next() -> None:
    """It has moved the bodies once and is gone."""
    stepper = engine(overlapping(0.1))
    stepper.advance(1)
    assert stepper.world.bodies[1].pseudo_vx > 0
    stepper.world.state.contact_count = 0
    stepper.world.bodies[1].x += 5
    stepper.advance(1)
    assert [body.pseudo_vx for body in stepper.world.bodies] == [0.0, 0.0]
