"""The rules of Breakout: laws, limits and answers that do not come from their own lines."""

from __future__ import annotations

import math
from random import Random

import numpy as np
import pytest
from shapely.geometry import Point
from shapely.geometry import Polygon as ShapelyPolygon

from lesson_code.chapters.breakout.rules import STEEPEST, brick_impact, fly, paddle_bounce

ROUNDING = 1e-12
"""Relative: sums of a few dozen numbers of like size."""

ROOT = 1e-9
"""Relative: of places that shapely computes again."""


def test_paddle_bounce_keeps_the_speed_and_is_clamped() -> None:
    """Up in the middle, 60 degrees at the ends and beyond."""
    assert paddle_bounce(0.0, 3.0) == (0.0, 3.0)
    for offset in (-2.0, -1.0, 0.4, 1.0, 7.0):
        x, y = paddle_bounce(offset, 3.0)
        assert math.hypot(x, y) == pytest.approx(3.0, rel=ROUNDING)
        clamped = min(max(offset, -1.0), 1.0)
        assert math.atan2(x, y) == pytest.approx(clamped * STEEPEST, rel=ROUNDING)


def test_brick_impact_touches_when_it_says_so() -> None:
    """At the time of impact the brick is a radius away, along the normal; before, farther."""
    stream, hits = Random(1), 0  # noqa: S311 - a test
    brick = (0.0, 0.0, 2.0, 1.0)
    outline = ShapelyPolygon([(0, 0), (2, 0), (2, 1), (0, 1)])
    for _ in range(200):
        start = np.array([stream.uniform(-3, 5), -2.0])
        velocity = np.array([stream.uniform(-2, 2), 4.0])
        hit = brick_impact(start, velocity, 0.3, brick)
        if hit is None:
            continue
        hits += 1
        time, normal = hit
        assert outline.distance(Point(start + velocity * time)) == pytest.approx(0.3, rel=ROOT)
        assert outline.distance(Point(start + velocity * 0.9 * time)) > 0.3
        foot = start + velocity * time - 0.3 * np.array(normal)
        assert outline.exterior.distance(Point(foot)) < 1e-9
    assert hits > 50


@pytest.mark.parametrize("speed", [1.0, 1e3, 1e6, 1e9])
def test_fly_no_ball_passes_through_a_brick_at_any_speed(speed: float) -> None:
    """The brick breaks and the ball comes back below it."""
    brick = (0.0, 1.0, 2.0, 0.01)
    duration = min(1.0, 10.0 / speed)
    place, velocity, broken = fly((1.0, 0.2), (0.0, speed), 0.1, [brick], duration)
    assert broken == [0]
    assert velocity == (0.0, -speed)
    assert place[1] == pytest.approx(0.2 + 0.7 - (duration * speed - 0.7), rel=ROOT)
