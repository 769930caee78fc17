"""What the complete demo shows, measured on the game's world."""

from __future__ import annotations

import pytest

from lesson_code.chapters.demo import game as demo
from lesson_code.chapters.demo.game import Demo
from lesson_code.view.pygame.program import Input

from ..conftest import run

ROUNDING = 1e-9
"""Relative: thousands of impacts, each with its rounding."""


def test_demo_has_five_circles_a_triangle_and_a_square_and_resets_to_them() -> None:
    """R gives seven bodies again and does not append (fault 23)."""
    game = Demo(0)
    game.take(Input("down", place=(4.2, 3.4)))
    assert len(game.bodies) == 8
    game.press("r")
    corners = [len(game.world.body(body).shape.outline) for body in game.bodies]
    assert corners == [0, 0, 0, 0, 0, 3, 4]


def test_demo_clear_leaves_the_walls() -> None:
    """C takes every body out."""
    game = Demo(0)
    game.press("c")
    assert (len(game.bodies), len(game.world)) == (0, 4)


def test_demo_arrows_change_the_restitution_within_0_and_1() -> None:
    """The read-out follows, and so does every body."""
    game = Demo(0)
    for key, presses, expected in (("up", 30, 1.0), ("left", 50, 0.0), ("right", 3, 0.15)):
        for _ in range(presses):
            game.press(key)
        assert game.restitution == expected
        assert {body.material.restitution for _, body in game.world.items()} == {expected}
    assert ("restitution", "0.15") in demo.readings(game)


def test_demo_space_gives_every_body_an_impulse_and_some_spin() -> None:
    """Circles and polygons alike (fault 32)."""
    game = Demo(0)
    run(game, 1)
    before = game.world.states()[4:]
    game.press("space")
    after = game.world.states()[4:]
    assert (before[:, 3:6] != after[:, 3:6]).all()


def test_demo_energy_counts_polygons_and_spin() -> None:
    """A square that only turns has I w^2 / 2 (fault 22)."""
    game = Demo(0)
    for body in game.bodies:
        game.world.throw(body, (0.0, 0.0), 0.0)
    square = game.bodies[-1]
    game.world.throw(square, (0.0, 0.0), 3.0)
    mass = 10.0 * 0.8 * 0.8
    assert game.world.kinetic_energy() == pytest.approx(mass * 0.64 / 6 * 9 / 2, rel=ROUNDING)


def test_demo_energy_never_grows_without_impulses() -> None:
    """With restitution 0.8 and friction 0.2 a minute only loses (fault 1)."""
    game = Demo(0)
    energies = [game.world.kinetic_energy()]
    for _ in range(600):
        game.step()
        energies.append(game.world.kinetic_energy())
    assert energies[-1] < energies[0]
    assert max(energies) == energies[0]


def test_demo_bodies_flash_while_they_touch() -> None:
    """Who was pushed in a step is who is drawn white in it."""
    game = Demo(0)
    for body in game.bodies:
        game.world.throw(body, (0.0, 0.0), 0.0)
    first, second = game.bodies[:2]
    game.world.move(first, (3.0, 3.5))
    game.world.move(second, (3.65, 3.5))
    game.world.throw(first, (1.0, 0.0))
    run(game, 1)
    assert game.world.touching() == {first, second}
