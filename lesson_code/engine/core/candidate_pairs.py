"""Candidate pairs: the broad phase runs again only when a body has left its box."""

from __future__ import annotations

from lesson_code.engine.core.broad_phase import bound, has_left_box
from lesson_code.engine.core.pipeline import BroadPhase
from lesson_code.engine.core.rows import World
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects


def find_pairs(world: World, broad_phase: BroadPhase, effects: Effects = EVERY_EFFECT) -> bool:
    """Find the candidate pairs, and return whether the table had room for them.

    The pairs of an earlier step are reused as long as every body is in the box drawn then.
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
