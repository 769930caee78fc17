"""The step: all stages of the engine, in their order. The pipeline of notebook 00, as code.

===============  ============================  ==============================================
stage            a step                        a step in sub-steps
===============  ============================  ==============================================
..               move the bodies
detection        broad phase, narrow phase     broad phase, narrow phase
resolution       prepare                       prepare, with the impacts
                 accelerate                    how long until a fast body hits something
                 warm start                    in each sub-step: accelerate, warm start,
                 impulses                      springs, move the bodies, relax
                 position correction
                 store                         store
post-processing  callbacks, record, sleep      callbacks, record
===============  ============================  ==============================================

In a step positions come first: at its end the velocities belong to the contacts at the positions
that the bodies have there. The bounce is computed from the velocity before gravity has acted in
this step, so that a ball that bounces for ever keeps its height.

With sub-steps contacts come first, and the motion follows, because the contacts have to follow
it. All jumps of velocity lie in their preparation. So the look ahead for fast bodies comes after
it: it then knows the velocities with which they will move. What no contact pushes moves at the
mean of its velocities before and after gravity has acted, along its parabola.
"""

from __future__ import annotations

import math

from lesson_code.engine.core.candidate_pairs import find_pairs
from lesson_code.engine.core.constants import LOOKS_AT_A_PART
from lesson_code.engine.core.frames import note_frame
from lesson_code.engine.core.islands import find_islands, first_of_island
from lesson_code.engine.core.motion import accelerate, move, note_velocities
from lesson_code.engine.core.narrow_phase import find_contacts
from lesson_code.engine.core.pipeline import Pipeline
from lesson_code.engine.core.rows import State, World
from lesson_code.engine.core.skin import take_skins_off
from lesson_code.engine.effects.continuous import choose_part
from lesson_code.engine.effects.flags import Effects
from lesson_code.engine.effects.impulse_record import (
    has_capacity_for_record,
    record_impulses,
    record_resting,
)
from lesson_code.engine.effects.next_contact import (
    choose_part_ahead,
    find_near_pairs,
)
from lesson_code.engine.effects.sleeping import everything_sleeps, has_capacity_for_sleep, let_sleep


def advance(world: World, pipeline: Pipeline) -> bool:
    """Make the steps that are left, and return whether all are made.

    They are not when a table was too small or a body was lost. Once there is room, the next call
    goes on where this one stopped.
    """
    state = world.state
    while state.steps_left > 0:
        if state.left == 0.0:
            state.left, state.impacts = state.whole, 0
        while state.left > 0.0:
            if not pipeline.make_part(world, pipeline):
                return False
            state.left -= state.dt
        state.steps_done += 1
        state.steps_left -= 1
        if state.steps_a_frame > 0 and state.steps_left % state.steps_a_frame == 0:
            note_frame(world, pipeline.effects)
    return True


# The step


def rigid_part(world: World, pipeline: Pipeline) -> bool:
    """Make a step, or the part of it until a fast body has hit something; return if it is made."""
    if pipeline.effects.sleeping and everything_sleeps(world):
        return rest(world, pipeline)
    if not world.state.has_moved and not choose_part(world, pipeline):
        return False
    return step(world, pipeline)


def step(world: World, pipeline: Pipeline) -> bool:
    """Make one time step, and return whether it is complete.

    It is not when a table was too small or a body was lost. Once there is room, the next call
    goes on where this one stopped.
    """
    state, effects = world.state, pipeline.effects
    if not state.has_moved:
        move(world, effects)
        state.has_moved = True
    if state.lost_body >= 0:
        return False
    if effects.collisions:
        if not detect(world, pipeline):
            return False
        pipeline.solver.prepare(world, effects)
    if effects.gravity or effects.damping:
        accelerate(world, effects)
    if effects.collisions:
        resolve(world, pipeline)
        post_process(world, pipeline)
    state.has_moved = False
    return True


def detect(world: World, pipeline: Pipeline) -> bool:
    """Find the contacts; return whether the tables have room for them and for their record."""
    effects = pipeline.effects
    if not find_pairs(world, pipeline.broad_phase, effects):
        return False
    return see_contacts(world, pipeline)


def see_contacts(world: World, pipeline: Pipeline) -> bool:
    """Find the contacts of the candidate pairs; return whether the tables have room for them."""
    effects = pipeline.effects
    if not find_contacts(world, effects):
        return False
    if effects.sleeping and not has_capacity_for_sleep(world):
        return False
    if pipeline.effects.impulse_record and not has_capacity_for_record(world):
        return False
    if pipeline.listener is not None:
        pipeline.listener.before_impulses(world)
    return True


def resolve(world: World, pipeline: Pipeline) -> None:
    """Find the impulses of all contacts, and the pushes out of overlaps."""
    state, solver, effects = world.state, pipeline.solver, pipeline.effects
    if effects.warm_starting:
        solver.warm_start(world, effects)
    for _ in range(state.iterations):
        solver.solve(world, effects)
    if effects.position_correction and solver.has_overlap_to_undo(world, effects):
        for _ in range(state.iterations):
            solver.correct(world, effects)
    if effects.warm_starting:
        solver.store(world, effects)


def post_process(world: World, pipeline: Pipeline) -> None:
    """Tell of the contacts and write down their impulses; let islands at rest fall asleep."""
    if pipeline.listener is not None:
        pipeline.listener.after_impulses(world)
    if pipeline.effects.impulse_record:
        record_impulses(world, pipeline.effects)
    if pipeline.effects.sleeping:
        if pipeline.effects.impulse_record:
            record_resting(world)
        let_sleep(world)


def rest(world: World, pipeline: Pipeline) -> bool:
    """Let a step pass in which everything sleeps, and return whether it has.

    It has not when the record was full.
    """
    state = world.state
    state.dt = state.left
    state.time = (state.steps_done + 1) * state.whole
    state.contact_count = 0
    if pipeline.effects.impulse_record:
        if not has_capacity_for_record(world):
            return False
        record_resting(world)
    return True


# The step with forces at the midpoint


def midpoint_part(world: World, pipeline: Pipeline) -> bool:
    """Make a step, or the part of it until a new contact; return whether it is made.

    Contacts come first, and impacts at the velocities that the bodies have there. The forces that
    follow are those for the whole of what is left of the step. Where a new contact comes up
    before its end, they are found again for the time until then.
    """
    state, effects = world.state, pipeline.effects
    if effects.sleeping and everything_sleeps(world):
        return rest(world, pipeline)
    if not state.is_prepared and not begin_at_contacts(world, pipeline):
        return False
    state.dt = min(state.left, state.horizon)
    if not let_forces_act_until_contact(world, pipeline):
        return False
    if effects.collisions:
        pipeline.solver.store(world, effects)
        post_process(world, pipeline)
    move(world, effects)
    state.is_prepared = False
    return state.lost_body < 0


def begin_at_contacts(world: World, pipeline: Pipeline) -> bool:
    """Find the contacts, and let impacts pass; return whether the tables had room for that."""
    state, solver, effects = world.state, pipeline.solver, pipeline.effects
    state.dt, state.horizon = state.left, math.inf
    if effects.collisions:
        if not (find_near_pairs(world, pipeline) and see_contacts(world, pipeline)):
            return False
        take_skins_off(world)
        solver.warm_start(world, effects)
        solver.prepare(world, effects)
    note_velocities(world)
    for body in world.bodies:
        body.waits = False
    state.is_prepared = True
    return True


def let_forces_act_until_contact(world: World, pipeline: Pipeline) -> bool:
    """Let forces act for so long that no two bodies touch anew; return whether that was possible.

    Gravity's part of the way depends on how long the part of the step is. So a shorter one is
    looked at once more: in it a body that rises is faster, and may touch sooner.
    """
    state = world.state
    for _ in range(LOOKS_AT_A_PART):
        let_forces_act(world, pipeline)
        longest = state.dt
        exchange_velocities(world)
        is_chosen = choose_part_ahead(world, pipeline)
        exchange_velocities(world)
        if not is_chosen:
            return False
        waits = let_islands_wait(world)
        if state.dt == longest and not waits:
            return True
        if waits or midpoint(state) == 1.0:
            break
    let_forces_act(world, pipeline)
    return True


def let_forces_act(world: World, pipeline: Pipeline) -> None:
    """Let gravity and the contacts act for the part of the step, and take the mean velocity.

    With v before and v' after, a body moves at (1 - theta) v + theta v'.
    """
    state, solver, effects = world.state, pipeline.solver, pipeline.effects
    for body in world.bodies:
        body.vx, body.vy, body.w = body.start_vx, body.start_vy, body.start_w
    if effects.gravity or effects.damping:
        accelerate(world, effects)
    if effects.collisions:
        solver.solve(world, effects)
    before = 1.0 - midpoint(state)
    for body in world.bodies:
        body.pseudo_vx = before * (body.start_vx - body.vx)
        body.pseudo_vy = before * (body.start_vy - body.vy)
        body.pseudo_w = before * (body.start_w - body.w)
    corrects = effects.collisions and effects.position_correction
    if corrects and solver.has_overlap_to_undo(world, effects):
        solver.correct(world, effects)


def midpoint(state: State) -> float:
    """Return theta: 1/2, where what gravity does on the way counts; without gravity 1.

    At 1/2 a body that flies follows its parabola, and no force at a contact gains energy. At 1
    angular momentum is kept as well, where forces act at the positions before they move bodies.
    """
    return 0.5 if state.gravity_x != 0.0 or state.gravity_y != 0.0 else 1.0


def exchange_velocities(world: World) -> None:
    """Give each body the velocity that it moves at; a second time undoes it."""
    for body in world.bodies:
        body.vx += body.pseudo_vx
        body.vy += body.pseudo_vy
        body.w += body.pseudo_w
        body.pseudo_vx = -body.pseudo_vx
        body.pseudo_vy = -body.pseudo_vy
        body.pseudo_w = -body.pseudo_w


def let_islands_wait(world: World) -> bool:
    """Let all bodies of an island wait if one has to; return whether any does.

    What waits keeps its velocity. If only some of an island did, impulses would be lost on them.
    """
    bodies = world.bodies
    found = False
    for body in bodies:
        found = found or body.waits
    if found:
        find_islands(world)
        for i in range(len(bodies)):
            if bodies[i].waits:
                bodies[first_of_island(bodies, i)].waits = True
        for i in range(len(bodies)):
            bodies[i].waits = bodies[first_of_island(bodies, i)].waits
    return found


# The step in sub-steps


def soft_part(world: World, pipeline: Pipeline) -> bool:
    """Let a step pass, or the part of it until a fast body has hit something.

    Returns whether it has passed, as :func:`rigid_part` does. Meanwhile ``state.dt`` is the length
    of a sub-step.
    """
    state, effects = world.state, pipeline.effects
    if effects.sleeping and everything_sleeps(world):
        return rest(world, pipeline)
    if not state.is_prepared and not prepare_part(world, pipeline):
        return False
    if not choose_part(world, pipeline):
        return False
    part = state.dt
    state.dt = part / state.substeps
    for _ in range(state.substeps):
        sub_step(world, pipeline)
        if state.lost_body >= 0:
            return False
    if effects.collisions:
        pipeline.solver.store(world, effects)
    state.dt = part
    if effects.collisions:
        post_process(world, pipeline)
    state.is_prepared = False
    return True


def prepare_part(world: World, pipeline: Pipeline) -> bool:
    """Find the contacts, and let impacts pass; return whether the tables had room for that."""
    state, effects = world.state, pipeline.effects
    state.dt = state.whole / state.substeps
    if effects.collisions:
        if not detect(world, pipeline):
            return False
        take_skins_off(world)
        pipeline.solver.prepare(world, effects)
    state.is_prepared = True
    return True


def sub_step(world: World, pipeline: Pipeline) -> None:
    """Make one sub-step: springs before the bodies move, rigid contacts after it."""
    state, solver, effects = world.state, pipeline.solver, pipeline.effects
    if effects.gravity or effects.damping:
        accelerate(world, effects)
    if effects.gravity:
        note_velocities(world)
    if effects.collisions:
        solver.warm_start(world, effects)
        for _ in range(state.iterations):
            solver.solve(world, effects)
    if effects.gravity:
        let_fly(world, effects)
    move(world, effects)
    if effects.collisions:
        for _ in range(state.iterations):
            solver.correct(world, effects)


def let_fly(world: World, effects: Effects) -> None:
    """Let each body that no contact has pushed follow its parabola: at its mean velocity."""
    state = world.state
    for body in world.bodies:
        is_pushed = body.vx != body.start_vx or body.vy != body.start_vy or body.w != body.start_w
        waits = body.waits or (effects.sleeping and body.is_asleep)
        if body.inv_m > 0.0 and not is_pushed and not waits:
            body.pseudo_vx -= state.gravity_x * state.dt / 2
            body.pseudo_vy -= state.gravity_y * state.dt / 2
