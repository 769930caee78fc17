"""What the asteroid field shows, measured on the game's world."""

from __future__ import annotations

import math
from itertools import combinations

import pytest

from lesson_code.chapters.asteroids.game import LIVES, PROGRAM, WAVES, Asteroids
from lesson_code.engine.live_world import TIME_STEP
from lesson_code.view.pygame.game import Input

from ..conftest import run

ROUNDING = 1e-9
"""Relative: thousands of impacts, each with its rounding."""


def test_asteroids_ledger_of_momentum_is_kept() -> None:
    """Thrust, shots, recoil, bursts, impacts, edges: the sum stays what it was."""
    game = Asteroids(2)
    before = game.ledger()
    game.take(Input("press", "up"))
    game.take(Input("press", "left"))
    for k in range(300):
        if k % 6 == 0:
            game.press("space")
        if k == 80:
            game.take(Input("release", "up"))
        game.step()
    assert game.score > 0
    assert game.ledger() == pytest.approx(before, abs=1e-9)


def test_asteroids_burst_keeps_the_mass() -> None:
    """Three pieces of unequal mass weigh what the asteroid did."""
    game = Asteroids(2)
    rock = max(game.rocks, key=game.mass)
    whole, others = game.mass(rock), set(game.rocks) - {rock}
    game._burst(rock)
    pieces = [game.mass(n) for n in game.rocks if n not in others]
    assert len(set(pieces)) == 3
    assert sum(pieces) == pytest.approx(whole, rel=ROUNDING)


@pytest.mark.parametrize("seed", range(8))
def test_asteroids_pieces_begin_where_there_is_room(seed: int) -> None:
    """Beside another asteroid, which a piece in the wrong direction would overlap by its radius.

    Directions are tried 30 degrees apart; what is missing to the best is a tenth of a radius.
    """
    game = Asteroids(seed)
    rock, neighbour, *rest = sorted(game.rocks, key=game.mass, reverse=True)
    for other in [*rest, game.ship]:
        game.world.remove(other)
    reach = game.radius(rock)
    game.world.move(rock, (3.0, 3.0))
    game.world.move(neighbour, (3.0 + reach + game.radius(neighbour), 3.0))
    game._burst(rock)
    for piece in game.rocks:
        if piece != neighbour:
            apart = math.dist(game.world.position(piece), game.world.position(neighbour))
            assert game.radius(piece) + game.radius(neighbour) - apart <= 0.1 * reach


def test_asteroids_come_back_on_the_other_side() -> None:
    """A ship that has flown out of the field is just outside of the opposite edge, unseen."""
    game = Asteroids(5)
    for rock in game.rocks:
        game.world.remove(rock)
    reach = game.radius(game.ship)
    for start, velocity, back in (
        ((8.0 + reach - 0.01, 3.0), (6.0, 0.0), (-reach, 3.0)),
        ((4.0, 0.01 - reach), (0.0, -6.0), (4.0, 6.0 + reach)),
    ):
        game.world.move(game.ship, start)
        game.world.throw(game.ship, velocity)
        run(game, 1)
        assert game.world.position(game.ship) == pytest.approx(back)
        assert game.world.velocity(game.ship) == velocity


def test_asteroid_waits_outside_as_long_as_its_place_is_taken() -> None:
    """It comes back when the other one has moved on, and not onto it."""
    game = Asteroids(5)
    waiting, other, *rest = game.rocks
    for rock in [*rest, game.ship]:
        game.world.remove(rock)
    game.world.move(waiting, (9.0, 3.0))
    game.world.throw(waiting, (0.1, 0.0))
    game.world.move(other, (0.2, 3.0))
    game.world.throw(other, (0.0, 0.0))
    game.ship = other  # somebody has to steer
    run(game, 2)
    assert game.world.position(waiting)[0] > 9.0
    game.world.move(other, (4.0, 3.0))
    run(game, 1)
    assert game.world.position(waiting)[0] == -game.radius(waiting)


@pytest.mark.parametrize("seed", range(3))
def test_asteroids_overlap_by_no_more_than_they_approach_in_a_step(seed: int) -> None:
    """Nor when they come back at an edge: half a minute, and the way of a step is the bound."""
    game, fastest = Asteroids(seed), 0.0
    for _ in range(1800):
        game.step()
        speeds = [math.hypot(*game.world.velocity(rock)) for rock in game.rocks]
        fastest = max(fastest, *speeds)
        for a, b in combinations(game.rocks, 2):
            apart = math.dist(game.world.position(a), game.world.position(b))
            assert game.radius(a) + game.radius(b) - apart <= 2 * fastest * TIME_STEP


def test_asteroids_tour_plays_to_an_end_and_keeps_the_ledger() -> None:
    """It turns, thrusts, shoots all waves to dust or loses its lives; and what it does adds up."""
    game, tour, most = Asteroids(0), dict(PROGRAM.tour), 0.0
    start = game.ledger()
    for k in range(9_000):
        if k in tour:
            game.take(tour[k])
        game.step()
        most = max(most, math.dist(game.ledger(), start))
        if game.is_over:
            break
    assert game.is_over
    assert game.notice
    assert game.wave > 1
    assert most < 1e-9


def test_asteroids_all_waves_shot_to_dust_are_a_win() -> None:
    """Each wave begins when the last asteroid is gone; what it brings was outside before."""
    game = Asteroids(1)
    start = game.ledger()
    for wave, count in enumerate(WAVES, start=1):
        assert (game.wave, game.lives) == (wave, LIVES)
        assert 0 < len(game.rocks) <= count
        while game.rocks and game.wave == wave:
            game._burst(min(game.rocks, key=game.radius))
        assert game.ledger() == pytest.approx(start, abs=1e-9)
        game.step()
    assert game.is_over
    assert game.notice.startswith("All waves are dust")
    game.press("r")
    assert (game.wave, game.is_over) == (1, False)


def test_asteroids_three_hits_are_the_end_and_a_hit_leaves_time() -> None:
    """A life is lost once in 2.5 s, however often the ship is struck meanwhile."""
    game = Asteroids(3)
    rock, *others = game.rocks
    for other in others:
        game.world.remove(other)
    for life in range(LIVES):
        run(game, max(game.safe_until - game.world.steps, 0))
        for _ in range(2):
            game.world.move(game.ship, (4.0, 3.0))
            game.world.throw(game.ship, (0.0, 0.0), 0.0)
            game.world.move(rock, (4.0 - game.radius(rock) - 0.6, 3.0))
            game.world.throw(rock, (3.0, 0.0), 0.0)
            run(game, 20)
        assert game.lives == LIVES - 1 - life
    assert game.notice.startswith("Game over")
