"""The step: the stages of the engine, in their order. The pipeline of notebook 00, as code.

    detection         1 move the bodies      2 broad phase      3 narrow phase
    resolution        4 prepare              5 accelerate       6 warm start
                      7 impulses             8 correction       9 store
    post-processing  10 callbacks         11 sleep

Positions come first: at the end of a step the velocities belong to the contacts at the positions
that the bodies have there. The bounce is computed from the velocity before gravity has acted in
this step, so that a ball that bounces for ever keeps its height.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple, Protocol, TypeAlias

from lesson_code.engine.core.broad_phase import bound, has_left_box
from lesson_code.engine.core.narrow_phase import find_contacts
from lesson_code.engine.core.rows import BodyRow, World
from lesson_code.engine.effects.damping import damp
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects
from lesson_code.engine.effects.gravity import fall
from lesson_code.engine.effects.impulse_record import (
    has_room_for_record,
    record_impulses,
    record_resting,
)
from lesson_code.engine.effects.sleeping import has_room_for_sleep, let_sleep
from lesson_code.geometry.rows import turn

Stage: TypeAlias = Callable[[World, Effects], None]
"""A stage changes the world's tables and returns nothing."""

BroadPhase: TypeAlias = Callable[[World], int]
"""Writes the candidate pairs, and returns how many there are."""


class ContactSolver(NamedTuple):
    """The stages in which one kind of solver differs from another."""

    prepare: Stage
    warm_start: Stage
    solve: Stage
    has_overlap_to_undo: Callable[[World, Effects], bool]
    correct: Stage
    store: Stage


class Listener(Protocol):
    """Who wants to be told of the contacts of a step."""

    def before_impulses(self, world: World) -> None:
        """Hear of the contacts; may change or remove them."""

    def after_impulses(self, world: World) -> None:
        """Hear of the contacts again, now with their impulses."""


class Pipeline(NamedTuple):
    """What the stages of a run are: chosen once, before it begins."""

    make_part: Callable[[World, Pipeline], bool]  # a step, or the part of it until an impact
    broad_phase: BroadPhase
    solver: ContactSolver
    listener: Listener | None = None
    effects: Effects = EVERY_EFFECT
    is_continuous: bool = True  # whether fast bodies are looked for
    splits_steps: bool = True  # whether a step is split at their impacts; else the run stops there
    keeps_impulses: bool = True  # whether every impulse is written down


def step(world: World, pipeline: Pipeline) -> bool:
    """Let one time step pass, and return whether it has.

    It has not when a table was too small or a body was lost. Once there is room, the next call
    goes on where this one stopped.
    """
    state, solver, effects = world.state, pipeline.solver, pipeline.effects
    if not state.has_moved:
        move(world, effects)  # 1
        state.has_moved = True
    if state.lost_body >= 0:
        return False
    if effects.collisions:
        if not find_pairs(world, pipeline.broad_phase, effects):  # 2
            return False
        if not find_contacts(world, effects):  # 3
            return False
        if effects.sleeping and not has_room_for_sleep(world):
            return False
        if pipeline.keeps_impulses and not has_room_for_record(world):
            return False
        if pipeline.listener is not None:
            pipeline.listener.before_impulses(world)
        solver.prepare(world, effects)  # 4
    if effects.gravity or effects.damping:
        accelerate(world, effects)  # 5
    if effects.collisions:
        resolve(world, pipeline)
        if pipeline.listener is not None:
            pipeline.listener.after_impulses(world)  # 10
        if pipeline.keeps_impulses:
            record_impulses(world, effects)
        if effects.sleeping:
            if pipeline.keeps_impulses:
                record_resting(world)
            let_sleep(world)  # 11
    state.has_moved = False
    return True


def rest(world: World, pipeline: Pipeline) -> bool:
    """Let a step pass in which everything sleeps, and return whether it has.

    It has not when the record was full.
    """
    state = world.state
    state.dt = state.left
    state.time = (state.steps_done + 1) * state.whole
    state.contact_count = 0
    if pipeline.keeps_impulses:
        if not has_room_for_record(world):
            return False
        record_resting(world)
    return True


def resolve(world: World, pipeline: Pipeline) -> None:
    """Find the impulses of all contacts, and the pushes out of overlaps."""
    state, solver, effects = world.state, pipeline.solver, pipeline.effects
    if effects.warm_starting:
        solver.warm_start(world, effects)  # 6
    for _ in range(state.iterations):
        solver.solve(world, effects)  # 7
    if effects.position_correction and solver.has_overlap_to_undo(world, effects):
        for _ in range(state.iterations):
            solver.correct(world, effects)  # 8
    if effects.warm_starting:
        solver.store(world, effects)  # 9


def move(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Move every body by its velocity and by the push out of an overlap, which is then spent.

    A body that leaves the range of floating point is noted as lost.
    """
    dt = world.state.dt
    for number, body in enumerate(world.bodies):
        if body.waits or (effects.sleeping and body.is_asleep):
            continue
        body.x += (body.vx + body.push_vx) * dt
        body.y += (body.vy + body.push_vy) * dt
        if not math.isfinite(body.x + body.y):
            world.state.lost_body = number
            return
        if effects.rotation and not turn_on(world, body, dt):
            world.state.lost_body = number
            return
        body.push_vx = 0.0
        body.push_vy = 0.0


def turn_on(world: World, body: BodyRow, dt: float) -> bool:
    """Turn a body by its angular velocity; return whether its angle is still a number."""
    spin = body.w + body.push_w
    body.angle += spin * dt
    body.push_w = 0.0
    if not math.isfinite(body.angle):
        return False
    if spin != 0.0 and body.corner_count > 0:
        turn_with_angle(world, body)
    return True


def turn_with_angle(world: World, body: BodyRow) -> None:
    """Let the body's outline follow its angle."""
    body.cos = math.cos(body.angle)
    body.sin = math.sin(body.angle)
    turn(world.corners, body)


def find_pairs(world: World, broad_phase: BroadPhase, effects: Effects = EVERY_EFFECT) -> bool:
    """Find the candidate pairs, and return whether the table had room for them.

    The pairs of an earlier step serve as long as every body is in the box that was drawn then.
    """
    state = world.state
    if state.has_pairs and not has_left_box(world, effects):
        return True
    bound(world, effects)
    return seek_pairs(world, broad_phase)


def seek_pairs(world: World, broad_phase: BroadPhase) -> bool:
    """Find the pairs of the boxes as they are drawn; return whether the table had room."""
    state = world.state
    count = broad_phase(world)
    state.has_pairs = count <= len(world.pairs)
    if state.has_pairs:
        state.pair_count = count
    else:
        state.pairs_wanted = count
    return state.has_pairs


def accelerate(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Let damping and gravity act on the velocities."""
    if effects.damping:
        damp(world, effects)
    if effects.gravity:
        fall(world, effects)
