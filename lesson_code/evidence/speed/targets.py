"""Targets: how many times faster than another engine, and the other limits."""

from __future__ import annotations

ANY = ("sequential", "substep")
"""Either of our solvers may reach a target on heaps of polygons."""

Targets = list[tuple[tuple[str, ...], str, dict[str, float]]]

TARGETS: Targets = [
    (("sequential",), "pymunk", {"gas-100": 2.8, "gas-1000": 4, "gas-10000": 7, "gas-100000": 14}),
    (("sequential",), "pymunk", {"settled-100": 2, "settled-1000": 2.8}),
    (("sequential",), "pymunk", {"settled-10000": 4, "settled-100000": 8}),
    (("sequential",), "box2d", {"gas-100": 5, "gas-1000": 5, "gas-10000": 5, "gas-100000": 5}),
    (("exact",), "pymunk", {"gas-1000": 4, "gas-10000": 8}),
    (ANY, "pymunk", {"bin-500": 1.5, "bin-2000": 1.5}),
    (ANY, "box2d", {"pyramid-10": 1.3, "bin-500": 1.3, "bin-2000": 1.3}),
    (ANY, "box2d", {"stack-10": 1.3, "stack-20": 1.3}),
]
"""Which of ours against which peer, and by scene the ratio of times, theirs to ours, that is wanted
at equal quality. Against pymunk that means the better of its two ways to find pairs."""

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


def target_of(scene: str, ours: str, peer: str) -> float | None:
    """Return the ratio that one of ours is to reach against a peer in a scene; None: none.

    >>> target_of("gas-1000", "sequential", "pymunk"), target_of("gas-10", "exact", "box2d")
    (4, None)
    """
    found = (
        ratios[scene]
        for solvers, against, ratios in TARGETS
        if ours in solvers and against == peer and scene in ratios
    )
    return next(found, None)
