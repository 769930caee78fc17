"""What pool shows, measured on the game's world."""

from __future__ import annotations

import pytest

from lesson_code.chapters.pool.game import HEAD, MASS, PROGRAM, Pool
from lesson_code.chapters.pool.game import Rules as PoolRules
from lesson_code.view.pygame.game import Input

from ..conftest import deepest_overlap, run

ROUNDING = 1e-9
"""Relative: thousands of impacts, each with its rounding."""

SYMMETRIC = 1e-6
"""m: the contacts of a rack are swept until they agree to about 1e-12 of the speed, and a ball on
its way makes a hundred times more of it with each impact."""


def test_pool_rack_breaks_symmetrically() -> None:
    """A straight break is its own mirror image, with spin and friction between the balls."""
    game = Pool(0)
    game.strike((1.2, 0.0))
    run(game, 20)
    states = game.world.states()[1:16]
    mirror = [row * (row + 1) // 2 + row - k for row in range(5) for k in range(row + 1)]
    y = states[:, 1] - HEAD[1]
    assert states[mirror, 0] == pytest.approx(states[:, 0], abs=SYMMETRIC)
    assert -y[mirror] == pytest.approx(y, abs=SYMMETRIC)


def test_pool_spin_turns_the_ball_at_the_cushion() -> None:
    """The cue to the left gives clockwise spin; off the far cushion the ball goes aside."""
    ways = []
    for presses in (["left"] * 4, [], ["right"] * 4):
        game = Pool(0)
        for ball in game.balls[1:]:
            game.world.remove(ball)
        for key in presses:
            game.press(key)
        game.strike((0.4, 0.0))
        run(game, 60)
        ways.append(game.world.velocity(game.cue)[1])
    assert ways[1] == 0.0
    assert ways[0] == pytest.approx(-ways[2], rel=ROUNDING)
    assert abs(ways[0]) > 0.02


def test_pool_balls_come_to_rest_or_fall() -> None:
    """After a break everything ends, and no ball is lost."""
    game = Pool(0)
    game.strike((1.3, 0.02))
    run(game, 60 * 30)
    assert game.is_at_rest
    assert len(game.balls) + len(game.potted) == 16


def test_pool_cue_ball_in_a_pocket_is_a_foul_and_comes_back() -> None:
    """It lies at its place again, and the others as they were."""
    game = Pool(0)
    game.world.move(game.cue, (0.1, 0.1))
    game.strike((-0.2, -0.2))
    run(game, 30)
    assert game.fouls == 1
    assert game.world.position(game.cue) == HEAD
    assert len(game.balls) == 16


def test_pool_drag_strikes_away_from_the_mouse() -> None:
    """Pulled back by 0.2 m: 2 N s/m of it, divided by the mass."""
    game = Pool(0)
    game.take(Input("down", place=(0.3, 0.3)))
    game.take(Input("up", place=(HEAD[0] - 0.2, HEAD[1])))
    assert game.world.velocity(game.cue) == pytest.approx((0.4 / MASS, 0.0), rel=ROUNDING)
    assert game.strokes == 1


def test_pool_leaves_out_what_a_player_has_not_written() -> None:
    """Without a rack the cue ball lies alone, and the window says so; the stroke counts."""

    def stub(*_: object) -> None:
        raise NotImplementedError("Task P.1: rack")

    def weak(impulse: object, *_: object) -> tuple[tuple[float, float], float]:
        return (0.1, 0.0), 0.0

    game = Pool(0, rules=PoolRules(rack=stub, strike=weak))
    assert len(game.balls) == 1
    assert game.notice == "not written yet: Task P.1: rack"
    game.strike((1.0, 0.0))
    assert game.world.velocity(game.cue) == (0.1, 0.0)


def test_pool_rack_is_that_of_eight_ball() -> None:
    """The 8 in the middle of the third row; one solid and one striped ball in the far corners."""
    game = Pool(0)
    assert sorted(game.on_table()) == list(range(1, 16))
    assert game.label(5) == 8
    assert (game.label(11) < 8) != (game.label(15) < 8)


def test_pool_tour_plays_by_the_rules() -> None:
    """A minute: several strokes, balls fall, every foul is named, and no ball is lost."""
    game, tour = Pool(0), dict(PROGRAM.tour)
    for k in range(3_600):
        if k in tour:
            game.take(tour[k])
        game.step()
        assert deepest_overlap(game.world) < 0.01
    assert game.strokes >= 4
    assert game.potted
    assert len(game.balls) + len(game.potted) == 16


def test_pool_ball_in_hand_goes_where_there_is_room() -> None:
    """After a foul the cue ball is dragged; onto another ball, or off the table, it is not."""
    game = Pool(0)
    game.is_in_hand = True
    apex = game.world.position(1)
    game.take(Input("down", place=HEAD))
    game.take(Input("move", place=(0.4, 0.3)))
    game.take(Input("move", place=(apex[0] + 0.01, apex[1])))
    assert game.world.position(game.cue) == (0.4, 0.3)
    game.take(Input("up", place=apex))
    assert game.strokes == 0
    assert game.aim is None


def test_pool_stroke_that_meets_nobody_is_a_foul() -> None:
    """The turn changes, and the cue ball is in the other player's hand."""
    game = Pool(0)
    game.strike((-0.02, 0.0))
    run(game, 600)
    assert (game.match.foul, game.match.turn) == ("no ball was met", 1)
    assert game.is_in_hand
