"""What the soft bodies show, measured on the game's world."""

from __future__ import annotations

from random import Random

import numpy as np
import pytest
from tiers import share

from lesson_code.chapters.soft_body.contacts import Skins, Walls, resolve
from lesson_code.chapters.soft_body.game import RADIUS, SoftBody
from lesson_code.view.pygame.game import Input

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


def test_right_button_holds_a_soft_body_as_the_left_one_does() -> None:
    """It pulls, lets go, and adds nothing."""
    games = [SoftBody(0), SoftBody(0)]
    for game, (take, pull, leave) in zip(
        games, (("down", "move", "up"), ("grab", "pull", "drop")), strict=True
    ):
        run(game, 100)
        x, y = game.world.position(game.rings[0][0])
        for kind, place in ((take, (x, y)), (pull, (x, y + 1.0))):
            game.take(Input(kind, place=place))
        run(game, 30)
        game.take(Input(leave, place=(x, y + 1.0)))
        run(game, 30)
    assert np.array_equal(games[0].snapshot(), games[1].snapshot())
    assert len(games[1].rings) == 3


@pytest.mark.full
def test_sliders_reach_the_soft_bodies() -> None:
    """Without gravity they stay where they are; without friction the floor takes less speed."""
    game = SoftBody(0)
    game.take(Input("set", "gravity", (0.0, 0.0)))
    before = game.points().mean(axis=1)
    run(game, 60)
    assert game.points().mean(axis=1) == pytest.approx(before, abs=1e-9)
    left = []
    for friction in (0.0, 0.5):
        game = SoftBody(0)
        run(game, 300)
        game.take(Input("set", "friction", (friction, 0.0)))
        game._v[:, 0] = 1.0
        run(game, 6)
        left.append(game._v[:, 0].mean())
    assert left[0] > 1.1 * left[1]


def deepest(game: SoftBody) -> float:
    """Return how far a mass, or the end of a ledge, is in a body, as a part of its radius."""
    return float(-game.gaps().min() / RADIUS)


def test_soft_bodies_stay_out_of_one_another_however_they_are_kicked() -> None:
    """Five bodies, kicked every second: no mass and no ledge gets into a body by 1 % of its radius.

    With contacts of mass and mass alone they stayed in one another, and the ledge pierced them.
    """
    game, worst = SoftBody(0), -1.0
    for k in range(share(1_200)):
        if k in (100, 250):
            game.press("b")
        if k % 60 == 30:
            game.press("space")
        game.step()
        worst = max(worst, deepest(game))
    assert len(game.rings) == 5
    assert worst < 0.01


@pytest.mark.full
def test_soft_bodies_stay_out_of_one_another_when_they_are_dragged_about() -> None:
    """A mouse that pulls a mass with the weight of a whole body presses in no more than 3 %."""
    game, worst, stream = SoftBody(0), -1.0, Random(5)  # noqa: S311 - a test
    for k in range(share(1_800)):
        if k % 40 == 0:
            place = stream.uniform(-2, 10), stream.uniform(-2, 8)
            stream.choice((game.down, game.drag, game.let_go))(place)
            game.press(stream.choice(("b", "space", "x", "x")))
        game.step()
        worst = max(worst, deepest(game))
        assert 0.5 < game.area_ratios().min() < game.area_ratios().max() < 1.2
    assert worst < 0.03


def test_soft_body_energy_is_in_its_parts_and_only_falls() -> None:
    """Motion, height, springs and gas: each takes part, and their sum grows by no more than 0.1 %.

    That much the springs gain and lose in a step of 1/240 s.
    """
    game = SoftBody(0)
    first, largest = sum(game.energies()), np.zeros(4)
    last = first
    for _ in range(600):
        game.step()
        parts = game.energies()
        assert sum(parts) <= last + 1e-3 * first
        last, largest = sum(parts), np.maximum(largest, parts)
    assert (largest > 0.002 * first).all()
    assert last < 0.75 * first


def test_gas_energy_is_the_work_of_its_pressure() -> None:
    """Squeezed to 0.9 of its area in 1,000 parts: the sum of -p dA, with p of each part."""
    game = SoftBody(0)
    whole, rest = game._p.copy(), game._areas[0]
    centre, work, before = whole[:16].mean(axis=0), 0.0, 1.0
    for ratio in np.linspace(1.0, 0.9, 1_001)[1:]:
        game._p[:16] = centre + np.sqrt((before + ratio) / 2) * (whole[:16] - centre)
        work -= game.pressures()[0] * rest * (ratio - before)
        before = ratio
    game._p[:16] = centre + np.sqrt(0.9) * (whole[:16] - centre)
    assert game.energies()[3] == pytest.approx(work, rel=1e-6)


def test_contact_of_two_bodies_keeps_the_momentum() -> None:
    """A ring thrown at another: what one gets the other loses, and they do not bounce apart."""
    turns = 2 * np.pi * np.arange(16) / 16
    ring = np.column_stack([np.cos(turns), np.sin(turns)])
    p = np.concatenate((ring, ring + np.array([2.11, 0.3])))
    v = np.repeat([(3.0, 0.0), (0.0, 0.0)], 16, axis=0)
    contacts = Skins(16, 0.05, ()).contacts(p, 0.5)
    free = Walls(np.full_like(v, -np.inf), np.full_like(v, np.inf))
    impulses = resolve(contacts, v, free, 0.1, 0.5, 1 / 10)
    assert impulses.sum() > 0.0
    assert v.sum(axis=0) == pytest.approx([48.0, 0.0], abs=1e-12)
    assert 0.1 * (v**2).sum() / 2 < 0.1 * 16 * 9 / 2


def test_skin_knows_inside_from_outside() -> None:
    """By hand, on a square ring with skin of 0.1: 1 m outside, and 0.5 m inside."""
    square = np.array([(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)])
    far = np.array([(3.0, 1.0), (9.0, 0.0), (9.0, 9.0), (0.5, 1.0)])
    gaps = Skins(4, 0.1, ()).gaps(np.concatenate((square, far)))
    assert gaps[4, 0] == pytest.approx(1.0 - 0.2)
    assert gaps[7, 0] == pytest.approx(-0.5 - 0.2)
