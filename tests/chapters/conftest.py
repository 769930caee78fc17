"""What tests of chapters and programs share: a solved workbook; and games that are played."""

from __future__ import annotations

import math
import shutil
from pathlib import Path

import numpy as np
import pytest

from lesson_code.course.notebooks.root import home
from lesson_code.engine.core.penetration import deepest_overlaps
from lesson_code.engine.core.scene import Scene
from lesson_code.engine.live_world import LiveWorld
from lesson_code.geometry.shapes import Circle
from lesson_code.view.pygame.game import Game


@pytest.fixture
def solved(tmp_path: Path) -> Path:
    """Return a workbook of a student's, with every solution in the place of its exercise."""
    (tmp_path / "notebooks").mkdir()
    shutil.copy(home() / "notebooks" / "00_start_here.ipynb", tmp_path / "notebooks")
    copied = shutil.ignore_patterns("source")
    shutil.copytree(home() / "solutions", tmp_path / "exercises", ignore=copied)
    return tmp_path


def make_step(game: Game) -> None:
    """Make a step; what takes long in plain Python goes on in machine code."""
    game.step()
    go_on_in_code(game)


def go_on_in_code(game: Game) -> None:
    """Let a world for whose steps plain Python takes long go on in machine code: the same bits."""
    world = getattr(game, "world", None)
    if isinstance(world, LiveWorld) and world.wants_code:
        world.compile()


def run(game: Game, steps: int) -> None:
    """Make some steps."""
    for _ in range(steps):
        make_step(game)


def deepest_overlap(world: LiveWorld) -> float:
    """Return the deepest overlap of two discs, as a part of the smaller radius; below 0: apart."""
    discs = [
        (world.position(n), body.shape.radius)
        for n, body in world.items()
        if isinstance(body.shape, Circle)
    ]
    if len(discs) < 2:
        return -math.inf
    p, r = np.array([place for place, _ in discs]), np.array([radius for _, radius in discs])
    gaps = np.hypot(*(p[:, None] - p[None]).T) - r[:, None] - r[None]
    np.fill_diagonal(gaps, np.inf)
    return float(-(gaps / np.minimum(r[:, None], r[None])).min())


def deepest_of_outlines(world: LiveWorld) -> float:
    """Return the deepest overlap of any two bodies, as a part of the least circumradius."""
    states, bodies = world.states(), world.bodies()
    depth = deepest_overlaps(Scene(bodies), states[None, :, :2], states[None, :, 2])[0]
    return float(depth / min(b.shape.bounding_radius for b in bodies if not b.is_static))


def deepest_in_room(world: LiveWorld, width: float, height: float) -> float:
    """Return how far a disc is out of a room from (0, 0), as a part of its radius."""
    discs = [
        (world.position(n), body.shape.radius)
        for n, body in world.items()
        if isinstance(body.shape, Circle)
    ]
    return max(
        (max(r - x, x + r - width, r - y, y + r - height) / r for (x, y), r in discs),
        default=-math.inf,
    )


def energy(world: LiveWorld) -> float:
    """Return kinetic and potential energy of all bodies that can be pushed, J."""
    heights = sum((body.mass or 0.0) * world.position(n)[1] for n, body in world.items())
    return world.kinetic_energy() - world.gravity[1] * heights
