"""What Breakout shows, measured on the game's world."""

from __future__ import annotations

import math
from random import Random

import pytest
from tiers import share

from lesson_code.chapters.breakout.game import BRICK, PADDLE, PROGRAM, RADIUS, Breakout, steady
from lesson_code.engine.core.constants import IMPACT_DEPTH, SLOP
from lesson_code.engine.live_world import TIME_STEP

from ..conftest import run

ROUNDING = 1e-9
"""Relative: thousands of impacts, each with its rounding."""


@pytest.mark.parametrize("speed", [5.0, 200.0, 20_000.0])
def test_breakout_no_ball_passes_a_brick_at_any_speed(speed: float) -> None:
    """A ball shot straight up comes back below the bricks, and has struck one."""
    game = Breakout(0)
    game.serves = False
    game.world.move(game.ball, (4.39, 3.5))
    game.world.throw(game.ball, (0.0, speed))
    for _ in range(60):
        game.world.step()
        if game.struck:
            break
    assert len(game.struck) == 1
    lowest = min(game.world.position(brick)[1] for brick in game.bricks) - BRICK[1] / 2
    assert game.world.position(game.ball)[1] < lowest


def depths(game: Breakout) -> tuple[float, float]:
    """Return how deep the ball is in bricks and walls, and in the paddle, m; < 0 outside."""

    def depth(number: int, size: tuple[float, float]) -> float:
        dx, dy = (
            abs(ball - box) - side / 2
            for ball, box, side in zip((x, y), game.world.position(number), size, strict=True)
        )
        return RADIUS - (math.hypot(max(dx, 0.0), max(dy, 0.0)) or max(dx, dy))

    x, y = game.world.position(game.ball)
    walls = (RADIUS - x, x + RADIUS - 8.0, y + RADIUS - 6.0) if y > 0 else ()
    bricks = (depth(brick, BRICK) for brick in game.bricks)
    return max(-1.0, *walls, *bricks), depth(game.paddle, PADDLE)


@pytest.mark.parametrize("level", range(1, 6))
def test_breakout_ball_stays_out_of_bricks_walls_and_paddle(level: int) -> None:
    """Within 1 % of its radius; in the paddle too, whose ends may come at it from the side."""
    game = Breakout(level)
    game.level = level
    game._build()
    for k in range(900):
        game.press("space")
        game.drag((game.random.uniform(0.0, 8.0) if k % 20 == 0 else game.target, 0.0))
        run(game, 1)
        if game.is_over:
            break
        still, paddle = depths(game)
        assert still <= 0.01 * RADIUS
        assert paddle <= 0.01 * RADIUS


def test_breakout_ball_of_any_speed_ends_a_step_outside_of_bricks_and_walls() -> None:
    """At 20,000 m/s, with up to 64 impacts in a step: no deeper than impacts are let in.

    From there the rules give it the speed of the level, and never back into what it has hit.
    """
    stream = Random(6)  # noqa: S311 - a test
    for _ in range(share(120)):
        game = Breakout(0)
        game.level = 2
        game._build()
        game.serves = False
        heading = stream.choice((stream.uniform(0, 2 * math.pi), stream.gauss(math.pi / 2, 0.05)))
        game.world.move(game.ball, (stream.uniform(0.2, 7.8), stream.uniform(0.8, 3.3)))
        game.world.throw(game.ball, (20_000 * math.cos(heading), 20_000 * math.sin(heading)))
        run(game, 1)
        if not game.serves:
            assert depths(game)[0] <= IMPACT_DEPTH * SLOP * 2 * RADIUS + 1e-9
            run(game, 1)
            assert depths(game)[0] <= game.speed * TIME_STEP


def test_breakout_rules_do_not_send_the_ball_into_a_wall() -> None:
    """In a corner of paddle and wall the paddle's angle is reflected by the wall."""
    game = Breakout(0)
    game.serves = False
    game.world.move(game.paddle, (PADDLE[0] / 2 + 0.05, 0.4))
    game.target = PADDLE[0] / 2 + 0.05
    game.world.move(game.ball, (RADIUS + 0.02, 0.4 + PADDLE[1] / 2 + RADIUS + 0.02))
    game.world.throw(game.ball, (-3.0, -3.0))
    run(game, 1)
    vx, vy = game.world.velocity(game.ball)
    assert vx > 0
    assert vy > 0


def test_breakout_paddle_decides_the_angle() -> None:
    """A ball on the right end leaves to the right, at the speed of the level."""
    game = Breakout(0)
    game.serves = False
    x, y = game.world.position(game.paddle)
    game.world.move(game.ball, (x + 0.5, y + 0.5))
    game.world.throw(game.ball, (0.0, -5.0))
    run(game, 6)
    vx, vy = game.world.velocity(game.ball)
    assert math.hypot(vx, vy) == pytest.approx(game.speed, rel=ROUNDING)
    assert math.degrees(math.atan2(vx, vy)) == pytest.approx(60 * 0.5 / 0.7, abs=1.0)


def test_breakout_ball_below_the_paddle_costs_a_life() -> None:
    """Three lives, then nothing moves until R."""
    game = Breakout(0)
    for _ in range(3):
        game.serves = False
        game.world.move(game.ball, (1.0, -RADIUS))
        game.world.throw(game.ball, (0.0, -9.0))
        run(game, 1)
    assert (game.lives, game.is_over) == (0, True)
    game.press("r")
    assert (game.lives, game.is_over) == (3, False)


def test_breakout_last_brick_begins_the_next_level() -> None:
    """There are more rows, some of them twice as hard, and the ball is faster."""
    game = Breakout(0)
    for number in list(game.bricks):
        game._hit(number)
    run(game, 1)
    assert (game.level, len(game.bricks), game.speed) == (2, 40, 6.0)
    assert sorted(set(game.bricks.values())) == [1, 2]


def test_breakout_steady_velocity_is_never_flat() -> None:
    """A ball that runs from wall to wall is tilted; the speed is what is asked for."""
    for velocity in ((3.0, 0.0), (-2.0, 0.1), (0.0, 0.0), (1.0, -4.0)):
        vx, vy = steady(velocity, 5.0)
        assert math.hypot(vx, vy) == pytest.approx(5.0, rel=ROUNDING)
        assert abs(vy) >= 1.0 - ROUNDING


def played(seed: int, steps: int) -> tuple[Breakout, list[float]]:
    """Return a game that has played its tour, and where its paddle was."""
    game, paddle, tour = Breakout(seed), [], dict(PROGRAM.tour)
    for k in range(steps):
        if k in tour:
            game.take(tour[k])
        game.step()
        paddle.append(game.world.position(game.paddle)[0])
    return game, paddle


def test_breakout_tour_plays() -> None:
    """The paddle goes to and fro, catches both capsules, and the first level is done unharmed."""
    game, paddle = played(0, 4_500)
    assert max(paddle) - min(paddle) > 5.0
    assert game.level >= 2
    assert game.lives == 3


@pytest.mark.full
@pytest.mark.parametrize("seed", range(3))
def test_breakout_tour_wins(seed: int) -> None:
    """All five levels within ten minutes."""
    game, _ = played(seed, 36_000)
    assert game.is_over
    assert game.lives > 0


@pytest.mark.parametrize(("power", "impulse"), [("", 10.0), ("m", 30.0), ("e", 7.0), ("me", 21.0)])
def test_breakout_brick_gets_the_impulse_of_mass_and_restitution(
    power: str, impulse: float
) -> None:
    """J = (1 + e) m vn: 5 m/s with 1 kg and e = 1, with 3 kg, with e = 0.4, and with both."""
    game = Breakout(0)
    game.serves = False
    game._change_powers(dict.fromkeys(power, 10_000))
    game.world.move(game.ball, (4.39, 3.5))
    game.world.throw(game.ball, (0.0, 5.0))
    while not game.impulse:
        game.step()
    assert game.impulse == pytest.approx(impulse, rel=ROUNDING)


def test_breakout_heavy_ball_breaks_a_strong_brick_at_once() -> None:
    """It takes two hits of 1 kg, and one of 3 kg."""
    for power, left in (("", 1), ("m", 0)):
        game = Breakout(0)
        game.level = 2
        game._build()
        game.serves = False
        game._change_powers(dict.fromkeys(power, 10_000))
        strong = max(game.bricks, key=lambda n: (game.bricks[n], -abs(game.rows[n]), n))
        x, y = game.world.position(strong)
        game.world.move(game.ball, (x, y + BRICK[1] / 2 + RADIUS + 0.01))
        game.world.throw(game.ball, (0.0, -6.0))
        run(game, 1)
        assert game.bricks.get(strong, 0) == left


def test_breakout_capsule_acts_once_it_is_caught_and_for_its_time() -> None:
    """It falls from its brick; missed, it is gone."""
    for x, caught in ((4.0, True), (1.0, False)):
        game = Breakout(0)
        game.falling = [("m", (x, 1.0))]
        run(game, 70)
        assert game.falling == []
        assert (game.mass == 3.0) is caught
        run(game, 720)
        assert game.mass == 1.0
