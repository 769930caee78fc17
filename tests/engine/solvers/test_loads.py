"""Warm starts of sub-steps: what carried a load is given again, and no blow is."""

from __future__ import annotations

from copy import deepcopy
from functools import cache

import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code import Body, Circle, Polygon, Scene, Segment
from lesson_code.engine.core.mixing import MixingRule
from lesson_code.engine.core.motion import note_velocities
from lesson_code.engine.core.rows import World
from lesson_code.engine.solvers.loads import give_loads
from lesson_code.engine.stepper import EngineStepper

G, H = 9.81, 1 / 240
RATIOS = (1.0, 30.0, 300.0)


@cache
def at_rest(ratio: float) -> World:
    """Return a heavy ball on two boxes on the floor, after 4 s; a sub-step of gravity has passed.

    A disc lies beside them: an island of its own, the last body of the table.
    """
    bodies = [
        Body(Segment((-9, 0), (9, 0))),
        Body(Polygon.box(4, 0.5), mass=1.0, position=(0, 0.25)),
        Body(Polygon.box(4, 0.5), mass=2.0, position=(0, 0.75)),
        Body(Circle(1), mass=ratio, position=(0, 2)),
        Body(Circle(1), mass=1.0, position=(6, 1)),
    ]
    stepper = EngineStepper(
        Scene(bodies, gravity=(0, -G)),
        solver="substep",
        dt=4 * H,
        iterations=1,
        substeps=4,
        combine=MixingRule(),
        compiled=False,
    )
    stepper.advance(240)
    world = stepper.world
    world.state.dt = world.state.dt_before = H
    for c in world.contacts[: world.state.contact_count]:
        c.normal_impulse, c.tangent_impulse = c.normal_impulse / 4, c.tangent_impulse / 4
    for body in world.bodies:
        body.vy -= G * H if body.inv_m > 0.0 else 0.0
    note_velocities(world)
    return world


def energy(world: World) -> float:
    """Return the kinetic energy of the first island, J."""
    return sum(
        (b.vx * b.vx + b.vy * b.vy) / b.inv_m / 2 + b.w * b.w / b.inv_i / 2
        for b in world.bodies[1:4]
    )


@pytest.mark.parametrize("ratio", RATIOS)
def test_load_is_given_again_whole(ratio: float) -> None:
    """It takes back what gravity has given, and each impulse is what it was.

    Of the load a fiftieth is left, as springs still settle: for the light boxes that is some speed.
    """
    world = deepcopy(at_rest(ratio))
    before = [c.normal_impulse for c in world.contacts[: world.state.contact_count]]
    give_loads(world)
    assert [c.normal_impulse for c in world.contacts[: world.state.contact_count]] == before
    assert max(abs(body.vy) for body in world.bodies) < 0.02 * ratio * G * H


@given(ratio=st.sampled_from(RATIOS), times=st.floats(1.0, 1e6))
def test_what_was_a_blow_adds_no_energy_and_leaves_other_islands_alone(
    ratio: float, times: float
) -> None:
    """The impulses of the first island are some times what carries it; the disc beside it rests.

    Up to 8 times they give no body more than 7 times the speed that gravity has given: that much is
    let pass, for what settles needs some of it. The part is the difference of two numbers that are
    nearly one, with 6 digits less than they.
    """
    world = deepcopy(at_rest(ratio))
    carried = energy(world)
    mine = [c for c in world.contacts[: world.state.contact_count] if 4 not in (c.a, c.b)]
    [beside] = [c for c in world.contacts[: world.state.contact_count] if 4 in (c.a, c.b)]
    for c in mine:
        c.normal_impulse, c.tangent_impulse = c.normal_impulse * times, c.tangent_impulse * times
    rest = beside.normal_impulse
    give_loads(world)
    assert beside.normal_impulse == rest
    if times > 8.5:
        assert energy(world) <= carried * (1 + 1e-7)
    else:
        assert energy(world) <= 64 * carried
