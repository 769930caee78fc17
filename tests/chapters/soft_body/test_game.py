"""What the soft bodies show, measured on the game's world."""

from __future__ import annotations

import numpy as np
import pytest

from lesson_code.chapters.soft_body.game import SoftBody
from lesson_code.view.pygame.program import Input

from ..conftest import run

AREA_KEPT, AT_REST = 0.2, 0.05
"""Of the area, at the hardest impact; of the largest kinetic energy, after ten seconds."""


def test_soft_bodies_deform_keep_their_area_and_come_to_rest() -> None:
    """They are squashed where they land, by less than a fifth, and lie still in the end."""
    game = SoftBody(0)
    areas, energies = [], []
    for _ in range(600):
        game.step()
        areas += game.area_ratios().tolist()
        energies.append(game.world.kinetic_energy())
    assert 1 - AREA_KEPT < min(areas) < 0.95
    assert max(areas) < 1 + AREA_KEPT
    assert energies[-1] < AT_REST * max(energies)
    assert game.world.states()[len(game.walls) :, 1].min() > 0


def test_soft_body_forces_add_up_to_nothing() -> None:
    """Springs and pressure are inner forces: they push no body as a whole."""
    game = SoftBody(0)
    run(game, 40)
    assert game.forces().sum(axis=0) == pytest.approx([0.0, 0.0], abs=1e-9)


def test_soft_body_follows_the_mouse() -> None:
    """A body that is pulled up rises against its weight."""
    game = SoftBody(0)
    run(game, 300)
    bead = game.rings[1][4]
    x, y = game.world.position(bead)
    game.take(Input("down", place=(x, y)))
    game.take(Input("move", place=(x, y + 2.0)))
    run(game, 60)
    assert game.world.position(bead)[1] > y + 0.5
    assert np.isfinite(game.world.states()).all()
