"""The rules of the dominoes: laws, limits and answers that do not come from their own lines."""

from __future__ import annotations

import math

from lesson_code.chapters.dominoes.rules import chain, tipping_angle, toppling_rate


def test_toppling_rate_just_takes_a_domino_over_its_edge() -> None:
    """A rod and a plate fall with 1 % more and stand with 1 % less, in small steps."""
    for width, height in ((0.1, 0.6), (0.3, 0.5)):
        for factor, falls in ((1.01, True), (0.99, False)):
            assert topples(width, height, factor * toppling_rate(width, height)) is falls


def topples(width: float, height: float, rate: float) -> bool:
    """Return whether a domino passes its tipping angle, by following it in time."""
    inertia = (width**2 + height**2) / 3
    half, angle, dt = math.hypot(width, height) / 2, 0.0, 1e-4
    while angle >= 0.0:
        lever = half * math.sin(tipping_angle(width, height) - angle)
        rate -= 9.81 * lever / inertia * dt
        angle += rate * dt
        if angle > tipping_angle(width, height):
            return True
    return False


def test_chain_every_domino_falls_and_in_order() -> None:
    """Each leans before the one after it does, and in the end all lie."""
    state = ([0.0] * 8, [1.0] + [0.0] * 7)
    order: list[int] = []
    for _ in range(800):
        state = chain(*state, 0.6, 0.3, 1 / 240, 1)
        order += [k for k, angle in enumerate(state[0]) if angle > 0.6 and k not in order]
    assert order == list(range(8))
    assert state[0] == [math.pi / 2] * 8


def test_chain_too_far_apart_stops() -> None:
    """Nobody pushes a row that stands."""
    assert chain([0.0] * 3, [0.0] * 3, 0.6, 0.3, 0.01, 500)[0] == [0.0] * 3
