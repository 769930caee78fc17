"""What we want to reach: how many times faster than another engine, and the other limits."""

from __future__ import annotations

from typing import NamedTuple

ANY = ("sequential", "substep")
"""Either of our solvers may reach a target on heaps of polygons."""


class Target(NamedTuple):
    """A ratio of times, theirs to ours, that is wanted in a scene at equal quality."""

    scene: str
    ours: tuple[str, ...]
    peer: str
    ratio: float


def _row(scene: str, ours: tuple[str, ...], peer: str, ratios: dict[int, float]) -> list[Target]:
    """Return the targets of one scene in several sizes."""
    return [Target(f"{scene}-{size}", ours, peer, ratio) for size, ratio in ratios.items()]


TARGETS = (
    *_row("gas", ("sequential",), "pymunk", {100: 2.8, 1_000: 4, 10_000: 7, 100_000: 14}),
    *_row("settled", ("sequential",), "pymunk", {100: 2, 1_000: 2.8, 10_000: 4, 100_000: 8}),
    *_row("bin", ANY, "pymunk", {500: 1.5, 2_000: 1.5}),
    *_row("gas", ("exact",), "pymunk", {1_000: 4, 10_000: 8}),
    *_row("gas", ("sequential",), "box2d", {100: 5, 1_000: 5, 10_000: 5, 100_000: 5}),
    *_row("pyramid", ANY, "box2d", {10: 1.3}),
    *_row("bin", ANY, "box2d", {500: 1.3, 2_000: 1.3}),
    *_row("stack", ANY, "box2d", {10: 1.3, 20: 1.3}),
)
"""Against pymunk that means the better of its two ways to find pairs."""

MOST_GROWTH = 1.1
"""Exponent of the time over the number of bodies, from 1,000 to 100,000."""

PILE_RATIOS = {
    "standing": {"pymunk": 2.0},
    "held-20": {"pymunk": 1.5, "box2d": 1.3},
    "held-50": {"pymunk": 1.5, "box2d": 1.3},
}
"""A peer's time over ours, by pile and peer, each with the least work that lets the pile hold."""

FEW_BODIES_RATIO = 10_000.0
"""Times less time than pymunk at equal error, for few bodies and the exact solver."""

MOST_BYTES = 1_000
"""A body, of all tables, at 100,000 discs."""

MOST_SECONDS = {"import": 0.3, "cold": 10.0, "kept": 1.0}
"""s: to import `lesson_code.simulation`; and for a first compiled run, from the start of Python to
its end: without kept programs, and with them."""


def targets_of(scene: str, engine: str) -> list[Target]:
    """Return what is wanted of one of our solvers in a scene."""
    return [t for t in TARGETS if t.scene == scene and engine in t.ours]
