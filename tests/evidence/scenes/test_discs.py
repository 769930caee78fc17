"""The scenes of chapter 04: what stands where, and what the engine makes of them."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

from lesson_code import Scene, simulate
from lesson_code.chapters.ch04_circles.scenes import balls_on_table, scattered_balls
from lesson_code.evidence.scenes import discs as disc_scenes
from lesson_code.reference.impact_closed_forms import (
    break_shot,
    cradle_all_at_once,
    cradle_one_by_one,
)

ROUNDING = 1e-12
"""Of a speed or an energy of 1 to 10, over some hundred impacts of 1e-16 each."""

CONVERGED = 1e-8
"""Of 1 m/s: 100 sweeps leave less, and so does an overlap of 1e-9 m, by which the normals err."""

MIRRORED = 1e-4
"""m: each hit multiplies a fault by the way between hits over the radius, ten or so; after ten
hits 1e-16 has become 1e-6."""

FINE = {"duration": 3.0, "dt": 1 / 240, "iterations": 30}


def gaps(scene: Scene) -> list[float]:
    """Return the gap of each pair of balls that can be pushed, m."""
    balls = [body for body in scene.bodies if not body.is_static]
    return [
        math.dist(a.position, b.position) - a.shape.radius - b.shape.radius
        for a, b in itertools.combinations(balls, 2)
    ]


# Rows


@pytest.mark.parametrize("last_first", [False, True])
@pytest.mark.parametrize("gap", [-1e-6, 0.0, 0.25])
def test_row_has_the_gaps_asked_for_whatever_the_order(gap: float, last_first: bool) -> None:
    """The neighbours of five discs are all so far apart; the disc on the left moves."""
    scene = disc_scenes.row_of_discs(5, gap, last_first=last_first)
    assert sorted(gaps(scene))[:4] == pytest.approx([gap] * 4, abs=ROUNDING)
    discs = sorted(scene.bodies, key=lambda body: body.position[0])
    assert [disc.velocity for disc in discs] == [(1.0, 0.0)] + [(0.0, 0.0)] * 4
    assert (discs[0] is scene.bodies[0]) is not last_first


@pytest.mark.parametrize("last_first", [False, True])
@pytest.mark.parametrize("gap", [-1e-6, 1e-6])
def test_row_leaves_one_by_one_or_all_at_once(gap: float, last_first: bool) -> None:
    """A millionth of a metre decides between the two closed forms; the order does not."""
    run = simulate(
        disc_scenes.row_of_discs(5, gap, last_first=last_first),
        1.0,
        iterations=100,
        solver="sequential",
    )
    expected = cradle_one_by_one(5, 1.0) if gap > 0 else cradle_all_at_once(5, 1.0)
    order = -1 if last_first else 1
    assert run.velocities[-1, ::order, 0] == pytest.approx(expected, abs=CONVERGED)


# The shot between two


@pytest.mark.parametrize("upper_first", [False, True])
def test_cue_ball_touches_both_which_touch_each_other(upper_first: bool) -> None:
    """The cue ball overlaps each of the others by 1 nm, and they just touch."""
    scene = disc_scenes.cue_between_two(upper_first=upper_first)
    assert gaps(scene) == pytest.approx([-1e-9, -1e-9, 0.0], abs=1e-15)
    assert (scene.bodies[1].position[1] > 0) is upper_first


@pytest.mark.parametrize("upper_first", [False, True])
def test_cue_ball_is_thrown_aside_by_the_first_attempt_alone(upper_first: bool) -> None:
    """Sequential impulses give the closed form in either order, the first attempt in none."""
    scene = disc_scenes.cue_between_two(upper_first=upper_first)
    shot = {"duration": 1e-9, "dt": 1e-9}
    order = [0, 1, 2] if upper_first else [0, 2, 1]
    run = simulate(scene, iterations=20, **shot)
    assert run.velocities[-1][order] == pytest.approx(break_shot(1.0, 1.0), abs=CONVERGED)
    naive = simulate(scene, solver="naive", **shot)
    assert naive.velocities[-1, 0, 1] == pytest.approx(
        (-1 if upper_first else 1) * math.sqrt(3) / 8, abs=CONVERGED
    )


# The table


@pytest.mark.parametrize(
    ("scene", "balls"),
    [(scattered_balls(1.0), 32), (disc_scenes.rack_break(0.95), 16)],
    ids=["scattered", "rack"],
)
def test_table_has_four_cushions_then_the_balls_clear_of_each_other(
    scene: Scene, balls: int
) -> None:
    """Balls lie on the table, and nothing overlaps at the start."""
    static = [body.is_static for body in scene.bodies]
    assert static == [True] * disc_scenes.CUSHIONS + [False] * balls
    assert min(gaps(scene)) > 9e-4
    for ball in scene.bodies[disc_scenes.CUSHIONS :]:
        x, y = np.abs(ball.position)
        assert x + disc_scenes.BALL_RADIUS < disc_scenes.LENGTH / 2
        assert y + disc_scenes.BALL_RADIUS < disc_scenes.WIDTH / 2


def test_cushions_bound_the_table() -> None:
    """Their ends are the corners of the table."""
    ends = set()
    for cushion in disc_scenes.rack_break(1.0).bodies[: disc_scenes.CUSHIONS]:
        for end in (cushion.shape.start, cushion.shape.end):
            ends.add(tuple(np.add(cushion.position, end).tolist()))
    x, y = disc_scenes.LENGTH / 2, disc_scenes.WIDTH / 2
    assert ends == {(-x, -y), (x, -y), (-x, y), (x, y)}


def test_break_is_symmetric_with_enough_sweeps() -> None:
    """The cue ball stays on the middle line, and each row stays its own mirror image."""
    run = simulate(
        disc_scenes.rack_break(0.95), 4.0, dt=1 / 240, iterations=30, solver="sequential"
    )
    balls = run.positions[:, disc_scenes.CUSHIONS :]
    rows = [range(1), *(range(1 + k * (k + 1) // 2, 1 + (k + 1) * (k + 2) // 2) for k in range(5))]
    for row in rows:
        mirrored = balls[:, row[::-1]] * (1, -1)
        assert np.max(np.abs(balls[:, row] - mirrored)) <= MIRRORED
    assert np.max(np.abs(balls[:, 0, 1])) <= CONVERGED
    assert set(balls_on_table(run)) == {16}
