"""Who plays pool when nobody does: the straightest way to pot a ball that may be met."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence

from lesson_code.engine.core.scene import XY

IMPULSE = 0.5
"""N s."""

COST_OF_WAY, COST_OF_BLOCK = 0.2, 2.0
"""rad: what 1 m of way, or a ball in it, counts beside the angle by which a ball is cut."""


def stroke(
    cue: XY, wanted: Collection[XY], others: Collection[XY], pockets: Sequence[XY], radius: float
) -> XY:
    """Return the impulse of the stroke that costs least, N s.

    The cue ball is aimed at the place that it has when it meets the ball on its way to the pocket.

    Parameters
    ----------
    cue : (float, float)
        Where the cue ball lies, m.
    wanted, others : collection of (float, float)
        Where the balls lie that have to be met first, and all balls but the cue ball, m.
    pockets : sequence of (float, float)
        m.
    radius : float
        m.

    Examples
    --------
    >>> stroke((0.0, 0.0), [(1.0, 0.0)], [(1.0, 0.0)], [(2.0, 0.0)], 0.1)
    (0.5, 0.0)
    """
    best, chosen = math.inf, (IMPULSE, 0.0)
    for ball in wanted:
        for pocket in pockets:
            reach = math.dist(ball, pocket)
            if reach == 0.0:
                continue
            back = (ball[0] - pocket[0]) / reach, (ball[1] - pocket[1]) / reach
            ghost = ball[0] + 2 * radius * back[0], ball[1] + 2 * radius * back[1]
            way = ghost[0] - cue[0], ghost[1] - cue[1]
            far = math.hypot(*way) or 1.0
            cut = math.acos(min(max(-(back[0] * way[0] + back[1] * way[1]) / far, -1.0), 1.0))
            blocked = any(_is_between(cue, ghost, o, radius) for o in others if o != ball)
            cost = cut + COST_OF_WAY * (far + reach) + COST_OF_BLOCK * blocked
            if cost < best:
                best, chosen = cost, (way[0] * IMPULSE / far, way[1] * IMPULSE / far)
    return chosen


def _is_between(start: XY, end: XY, ball: XY, radius: float) -> bool:
    """Return whether a ball is in the way of another one."""
    length = math.dist(start, end) or 1.0
    ux, uy = (end[0] - start[0]) / length, (end[1] - start[1]) / length
    x, y = ball[0] - start[0], ball[1] - start[1]
    return 0 < x * ux + y * uy < length and abs(x * uy - y * ux) < 2 * radius
