"""Warm starts of sub-steps: what has carried a load is given again, but not what was a blow.

The impulses of the last sub-step are the best guess for those of this one where they carry a load:
what gravity gives a body in a sub-step they take back. What has stopped a heavy body is no load.
Given again it throws the body up, and sweeps take little of it back where light bodies lie between:
each takes back no more than a light body's speed is worth.

What carries takes energy. So where a body would get much more speed than gravity gives, each island
is given only as much as adds none. The impulses J do the work

    W(s) = s J u + s^2 J K J / 2,    0 <= s <= 1

on contacts that approach with u; K is what makes velocities of impulses. If W(1) > 0, it is

    s = -2 J u / J K J = 1 - W(1) / (J K J / 2)

at which it is 0, or no part at all. The sweeps that follow find what is missing.
"""

from __future__ import annotations

from lesson_code.engine.core.constants import MOST_OF_LOAD
from lesson_code.engine.core.islands import find_islands, first_of_island
from lesson_code.engine.core.rows import BodyRow, World
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects
from lesson_code.engine.solvers.impacts import energy_of_motion, first_body, work_on
from lesson_code.engine.solvers.sequential import give_again


def give_loads(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Give each contact the impulse of the last sub-step, as far as that adds no energy."""
    give_again(world, effects)
    if effects.gravity and is_blow(world):
        note_work(world)
        give_part_of_loads(world)


def is_blow(world: World) -> bool:
    """Return whether a body has got much more speed than gravity gives in a sub-step."""
    state = world.state
    gravity2 = state.gravity_x * state.gravity_x + state.gravity_y * state.gravity_y
    most = MOST_OF_LOAD * MOST_OF_LOAD * gravity2 * state.dt * state.dt
    found = False
    for body in world.bodies:
        dx, dy = body.vx - body.start_vx, body.vy - body.start_vy
        found = found or dx * dx + dy * dy > most
    return found and gravity2 > 0.0


def note_work(world: World) -> None:
    """Note, in the first body of each island, the work of what was given, W(1), and J K J / 2."""
    find_islands(world)
    for body in world.bodies:
        body.gained = body.between = 0.0
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        first_body(world, c).gained += work_on(world, c)
    for i in range(len(world.bodies)):
        body = world.bodies[i]
        if body.inv_m > 0.0 and not body.is_asleep:
            dx, dy = body.vx - body.start_vx, body.vy - body.start_vy
            first = world.bodies[first_of_island(world.bodies, i)]
            first.between += energy_of_motion(body, dx, dy, body.w - body.start_w)


def give_part_of_loads(world: World) -> None:
    """Leave each island the part of what was given that adds no energy."""
    for i in range(len(world.bodies)):
        body = world.bodies[i]
        if body.inv_m > 0.0 and not body.is_asleep:
            s = part_of_load(world.bodies[first_of_island(world.bodies, i)])
            body.vx = body.start_vx + s * (body.vx - body.start_vx)
            body.vy = body.start_vy + s * (body.vy - body.start_vy)
            body.w = body.start_w + s * (body.w - body.start_w)
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        s = part_of_load(first_body(world, c))
        c.normal_impulse *= s
        c.tangent_impulse *= s


def part_of_load(island: BodyRow) -> float:
    """Return the s at which an island, by its first body, gains nothing; 1 if it loses energy."""
    if island.gained <= 0.0 or island.between == 0.0:
        return 1.0
    return max(1.0 - island.gained / island.between, 0.0)
