"""What the complete demo shows, measured on the game's world."""

from __future__ import annotations

import pytest

from lesson_code.chapters.demo import game as demo
from lesson_code.chapters.demo.game import Demo
from lesson_code.view.pygame.game import Input
from lesson_code.view.pygame.picture import Picture
from lesson_code.view.pygame.window import Window

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


def after(key: str) -> tuple[list[float], float]:
    """Return the velocities along x of the first two bodies after they have met, and the energy."""
    game = Demo(0)
    game.press(key)
    before = game.world.kinetic_energy()
    run(game, 100)
    first, second = game.bodies[:2]
    speeds = [game.world.velocity(n)[0] for n in (first, second)]
    return speeds, game.world.kinetic_energy() / before


def test_demo_answers_are_what_is_seen() -> None:
    """-3/5 and 2/5 of 2 m/s; the plank moves and turns; half of the energy."""
    assert after("2")[0] == pytest.approx([-1.2, 0.8], rel=ROUNDING)
    game = Demo(0)
    game.press("3")
    run(game, 100)
    plank = game.bodies[1]
    assert game.world.velocity(plank)[0] > 0.1
    assert abs(game.world.spin(plank)) > 0.1
    speeds, kept = after("4")
    assert speeds == pytest.approx([1.0, 1.0], rel=ROUNDING)
    assert kept == pytest.approx(0.5, rel=ROUNDING)


def test_demo_answer_comes_after_the_scene(
    program_window: Window, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The question at once, the answer four seconds later; R asks again."""
    told: list[str] = []
    monkeypatch.setattr(Picture, "label", lambda _, words, *__, **___: told.append(words))
    game = Demo(0)
    for steps, lines in ((0, 1), (240, 2)):
        run(game, steps)
        told.clear()
        demo.draw(game, Picture(program_window, demo.PROGRAM.camera), demo.PROGRAM.effects())
        assert told == [game.scene.question, game.scene.answer][:lines]
