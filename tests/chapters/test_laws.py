"""Laws that the programs keep while they are played: energy, momentum, and nobody in anybody.

In the quick tier for some seconds of the tour and some hundred inputs; in the full tier for ten
minutes of the tour and for 10,000 inputs.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from random import Random
from typing import Any

import pytest
from tiers import share

from lesson_code.chapters.programs import load
from lesson_code.view.pygame.game import Game, Input
from lesson_code.view.pygame.program import Program

from .conftest import deepest_in_room, deepest_of_outlines, deepest_overlap, make_step
from .conftest import energy as energy_of

KEPT = 1e-9
"""Relative, where nothing else may change it: 1e-15 to 1e-12 were measured."""

DEEPEST = 0.01
"""Of the smaller radius."""

MINUTES_10, INPUTS = 36_000, 10_000
AT_REST_SOON = ("dominoes", "soft_body")
"""Their tours end after 17 s; a step of theirs costs ten times as much as one of the others."""

LOOK = 6
"""Steps from one look at overlaps to the next."""


def tour(program: Program, game: Game, steps: int) -> Iterator[tuple[int, bool]]:
    """Make steps of the tour; yield after each its number, and whether there was an input."""
    for k in range(steps):
        given = [one for step, one in program.tour if step == k]
        for one in given:
            game.take(one)
        make_step(game)
        yield k, bool(given)


def random_inputs(seed: int, count: int) -> Iterator[Input]:
    """Yield keys that games know and places in and around an 8 x 6 field."""
    stream = Random(seed)  # noqa: S311 - a test
    keys = ["space", "up", "down", "left", "right", *"123456789abcdefgnrw"]
    for _ in range(count):
        kind = stream.choice(("press", "release", "down", "move", "up"))
        yield Input(kind, stream.choice(keys), (stream.uniform(-2, 10), stream.uniform(-2, 8)))


def overlap(game: Any) -> float:
    """Return the deepest overlap of round bodies, as a part of the smaller radius."""
    return deepest_overlap(game.world)


def in_room(game: Any) -> float:
    """Return the same, with the walls of a room of 8 x 6."""
    return max(overlap(game), deepest_in_room(game.world, 8.0, 6.0))


ENERGY: dict[str, Callable[[Any], float]] = {
    "simulator": lambda game: energy_of(game.world),
    "cradle": lambda game: float(game.energy()),
    "demo": lambda game: float(game.world.kinetic_energy()),
    "pool": lambda game: float(game.world.kinetic_energy()),
    "dominoes": lambda game: float(game.energy()),
    "billiards": lambda game: math.hypot(*game.velocity) ** 2 / 2,
    "soft_body": lambda game: float(sum(game.energies())),
}
"""J (for billiards per kg, px^2/s^2): all there is."""

ELASTIC = ("simulator", "cradle")
"""Their tours lose nothing either."""

GAINED = {"soft_body": 1e-3, "dominoes": 1e-4}
"""Relative: the springs of soft bodies gain and lose that much in a step, and dominoes that have
just been stood up are lifted out of the floor by 1e-5 of their height."""

APART: dict[str, Callable[[Any], float]] = {
    "simulator": in_room,
    "demo": in_room,
    "pool": overlap,
    "cradle": overlap,
    "breakout": overlap,
    "dominoes": lambda game: deepest_of_outlines(game.world),
}
"""How deep bodies are in one another, as a part of the smaller radius; dominoes, as a part of half
the least diagonal."""


@pytest.mark.parametrize("name", sorted({*ENERGY, *APART}))
def test_tour_keeps_energy_and_keeps_bodies_apart(name: str) -> None:
    """For ten minutes, or two and a half: no energy comes between inputs, and nobody into anybody.

    While the mouse pulls, it does work.
    """
    program, part, is_elastic = load(name), 4 if name in AT_REST_SOON else 1, name in ELASTIC
    game = program.game(0)
    energy, depth = ENERGY.get(name, lambda _: 0.0), APART.get(name, lambda _: 0.0)
    start = energy(game)
    for k, was_given in tour(program, game, share(MINUTES_10 // part, 12 if is_elastic else 24)):
        now = energy(game)
        if was_given or (not is_elastic and getattr(game, "grip", None) is not None):
            start = now
        assert now <= start * (1 + GAINED.get(name, KEPT))
        assert not is_elastic or now >= start * (1 - KEPT)
        assert k % LOOK or depth(game) < DEEPEST


@pytest.mark.parametrize("name", APART)
def test_inputs_let_nobody_into_anybody(name: str) -> None:
    """The same for 10,000 random keys and clicks, a step after every second one."""
    game: Any = load(name).game(1)
    for k, given in enumerate(random_inputs(5, share(INPUTS, 12))):
        game.take(given)
        if k % 2:
            make_step(game)
        if k % (2 * LOOK) == 1:
            assert APART[name](game) < DEEPEST


def test_asteroids_inputs_keep_the_ledger_of_momentum() -> None:
    """10,000 random inputs: thrust, shots, bursts, dust and waves always add up to the same."""
    game = load("asteroids").game(2)
    start = game.ledger()
    for given in random_inputs(9, share(INPUTS)):
        if given.key == "r":
            continue
        game.take(given)
        game.step()
        assert math.dist(game.ledger(), start) < KEPT
