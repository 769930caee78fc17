"""The step in sub-steps: contacts are found once, and bodies move several times.

    detection         1 broad phase          2 narrow phase
    resolution        3 prepare: impacts     4 how long to go on until a fast body hits something
                      each sub-step          5 accelerate     6 warm start      7 springs
                                             8 move           9 relax
                      10 store
    post-processing   11 callbacks

Contacts come first here, and the motion follows, because the contacts have to follow it. All jumps
of velocity lie in stage 3. So the look ahead for fast bodies comes after it: it then knows the
velocities with which they will move.
"""

from __future__ import annotations

from lesson_code.engine.core.narrow_phase import find_contacts
from lesson_code.engine.core.rows import World
from lesson_code.engine.core.step import Pipeline, accelerate, find_pairs, move
from lesson_code.engine.effects.continuous import choose_part
from lesson_code.engine.effects.impulse_record import has_room_for_record, record_impulses


def soft_part(world: World, pipeline: Pipeline) -> bool:
    """Let a step pass, or the part of it until a fast body has hit something.

    Returns whether it has passed, as :func:`rigid_part` does. Meanwhile ``state.dt`` is the length
    of a sub-step.
    """
    state, solver, effects = world.state, pipeline.solver, pipeline.effects
    if not state.is_prepared and not prepare_part(world, pipeline):
        return False
    if not choose_part(world, pipeline):  # 4
        return False
    part = state.dt
    state.dt = part / state.substeps
    for _ in range(state.substeps):
        if effects.gravity or effects.damping:
            accelerate(world, effects)  # 5
        if effects.collisions:
            solver.warm_start(world, effects)  # 6
            for _ in range(state.iterations):
                solver.solve(world, effects)  # 7
        move(world, effects)  # 8
        if state.lost_body >= 0:
            return False
        if effects.collisions:
            for _ in range(state.iterations):
                solver.correct(world, effects)  # 9
    if effects.collisions:
        solver.store(world, effects)  # 10
        if pipeline.listener is not None:
            pipeline.listener.after_impulses(world)  # 11
        if pipeline.keeps_impulses:
            record_impulses(world, effects)
    state.dt = part
    state.is_prepared = False
    return True


def prepare_part(world: World, pipeline: Pipeline) -> bool:
    """Find the contacts, and let impacts pass; return whether the tables had room for that."""
    state = world.state
    effects = pipeline.effects
    state.dt = state.whole / state.substeps
    if effects.collisions:
        if not find_pairs(world, pipeline.broad_phase, effects):  # 1
            return False
        if not find_contacts(world, effects):  # 2
            return False
        if pipeline.keeps_impulses and not has_room_for_record(world):
            return False
        if pipeline.listener is not None:
            pipeline.listener.before_impulses(world)
        pipeline.solver.prepare(world, effects)  # 3
    state.is_prepared = True
    return True
