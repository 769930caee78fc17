"""The step: the stages of the engine, in their order. The pipeline of notebook 00, as code.

    detection         1 move the bodies      2 broad phase      3 narrow phase
    resolution        4 prepare              5 accelerate       6 warm start
                      7 impulses             8 correction       9 store
    post-processing  10 callbacks

Positions come first: at the end of a step the velocities belong to the contacts at the positions
that the bodies have there. The bounce is computed from the velocity before gravity has acted in
this step, so that a ball that bounces for ever keeps its height.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple, Protocol, TypeAlias

from lesson_code.engine.broad_phase import bound, most_pairs
from lesson_code.engine.narrow_phase import find_contacts
from lesson_code.engine.room import make_room
from lesson_code.engine.rows import BodyRow, World
from lesson_code.geometry.rows import turn

Stage: TypeAlias = Callable[[World], None]
"""A stage changes the world's tables and returns nothing."""

BroadPhase: TypeAlias = Callable[[World], int]
"""Writes the candidate pairs, and returns how many there are."""


class ContactSolver(NamedTuple):
    """The stages in which one kind of solver differs from another."""

    prepare: Stage
    warm_start: Stage
    solve: Stage
    correct: Stage
    store: Stage


class Listener(Protocol):
    """Who wants to be told of the contacts of a step."""

    def before_impulses(self, world: World) -> None:
        """Hear of the contacts; may change or remove them."""

    def after_impulses(self, world: World) -> None:
        """Hear of the contacts again, now with their impulses."""


def step(
    world: World, broad_phase: BroadPhase, solver: ContactSolver, listener: Listener | None = None
) -> None:
    """Let one time step pass."""
    move(world)  # 1
    bound(world)  # 2
    find_pairs(world, broad_phase)
    find_contacts(world)  # 3
    if listener is not None:
        listener.before_impulses(world)
    solver.prepare(world)  # 4
    accelerate(world)  # 5
    solver.warm_start(world)  # 6
    for _ in range(world.state.iterations):
        solver.solve(world)  # 7
    if has_overlap_to_undo(world):
        for _ in range(world.state.iterations):
            solver.correct(world)  # 8
    solver.store(world)  # 9
    if listener is not None:
        listener.after_impulses(world)  # 10


def move(world: World) -> None:
    """Move every body by its velocity and by the push out of an overlap, which is then spent.

    Raises
    ------
    FloatingPointError
        A body has left the range of floating point.
    """
    dt = world.state.dt
    for number, body in enumerate(world.bodies):
        if body.waits:
            continue
        body.x += (body.vx + body.push_vx) * dt
        body.y += (body.vy + body.push_vy) * dt
        spin = body.w + body.push_w
        body.angle += spin * dt
        if not math.isfinite(body.x + body.y + body.angle):
            raise FloatingPointError(f"body {number} has left the range of floating point")
        if spin != 0.0:
            turn_with_angle(world, body)
        body.push_vx = 0.0
        body.push_vy = 0.0
        body.push_w = 0.0


def turn_with_angle(world: World, body: BodyRow) -> None:
    """Let the body's outline follow its angle."""
    body.cos = math.cos(body.angle)
    body.sin = math.sin(body.angle)
    turn(world.corners, body)


def find_pairs(world: World, broad_phase: BroadPhase) -> None:
    """Find the candidate pairs; when the tables have no room for them all, make it.

    Raises
    ------
    ValueError
        The bodies overlap in so many pairs that no memory would hold them.
    """
    count = broad_phase(world)
    if count > len(world.pairs):
        bodies = len(world.bodies)
        if count > most_pairs(bodies):
            raise ValueError(
                "bodies must not be heaped into one another: "
                f"{bodies} of them overlap in {count} pairs or more"
            )
        make_room(world, count)
        count = broad_phase(world)
    world.state.pair_count = count


def accelerate(world: World) -> None:
    """Let gravity and damping act on the velocities."""
    state = world.state
    remaining = math.exp(-state.damping * state.dt)
    for body in world.bodies:
        if body.inv_m > 0.0:
            body.vx = body.vx * remaining + state.gravity_x * state.dt
            body.vy = body.vy * remaining + state.gravity_y * state.dt
            body.w = body.w * remaining


def has_overlap_to_undo(world: World) -> bool:
    """Return whether any contact overlaps by more than the slop."""
    for k in range(world.state.contact_count):  # noqa: SIM110 - a loop is what a compiler takes
        if world.contacts[k].push_speed > 0.0:
            return True
    return False
