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

MOST_BYTES = 1_000
"""A body, of all tables, at 100,000 discs."""

WHOLE_RUNS: dict[str, tuple[float, float]] = {
    **dict.fromkeys(("run-gas-10", "run-gas-100", "run-pile-30"), (1.0, 0.3)),
    **dict.fromkeys(("run-gas-1000", "run-pile-300"), (2.0, 0.0)),
    "run-pile-3000": (1 / 1.5, 0.0),
    "run-gas-10000": (1 / 2.5, 0.0),
    "run-gas-100000": (1 / 5.0, 0.0),
}
"""By scene, what ours may take from the start of Python to the result, its program kept: a share of
pymunk's time, and so many seconds more."""

FEWEST_FOR_SECOND_CALL = 30
"""Discs from which on a second call in a process may take no longer than pymunk's."""


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
