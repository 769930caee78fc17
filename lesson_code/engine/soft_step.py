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

from lesson_code.engine.broad_phase import bound
from lesson_code.engine.continuous import part_to_impact
from lesson_code.engine.narrow_phase import find_contacts
from lesson_code.engine.rows import World
from lesson_code.engine.world import (
    BroadPhase,
    ContactSolver,
    Listener,
    accelerate,
    find_pairs,
    move,
)


def soft_step(
    world: World, broad_phase: BroadPhase, solver: ContactSolver, listener: Listener | None = None
) -> bool:
    """Let one time step pass, or only the part of it until a fast body has hit something.

    Returns whether the step has come to its end, as :func:`step_to_impacts` does. Meanwhile
    ``state.dt`` is the length of a sub-step.
    """
    state = world.state
    whole = state.dt
    state.dt = whole / state.substeps
    bound(world)  # 1
    find_pairs(world, broad_phase)
    find_contacts(world)  # 2
    if listener is not None:
        listener.before_impulses(world)
    solver.prepare(world)  # 3
    part = part_to_impact(world, broad_phase)  # 4
    state.dt = part / state.substeps
    for _ in range(state.substeps):
        accelerate(world)  # 5
        solver.warm_start(world)  # 6
        for _ in range(state.iterations):
            solver.solve(world)  # 7
        move(world)  # 8
        for _ in range(state.iterations):
            solver.correct(world)  # 9
    solver.store(world)  # 10
    state.dt = whole
    state.left -= part
    if listener is not None:
        listener.after_impulses(world)  # 11
    return state.left <= 0.0
