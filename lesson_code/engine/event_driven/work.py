"""How much work a run of the exact solver is about to be: events, before the first has happened.

A gas has as many collisions as kinetic theory expects of one in the box that is drawn around it.
This only helps to choose between plain Python and machine code; a run that goes otherwise is looked
at again on the way.

References
----------
Chapman and Cowling, The Mathematical Theory of Non-uniform Gases (1970), collision frequency; in
the plane, with the contact value of Henderson, A simple equation of state for hard discs (1975).
"""

from __future__ import annotations

import math

import numpy as np

from lesson_code.engine.core.scene import Scene
from lesson_code.engine.event_driven.constants import MOST_AHEAD

DENSEST = 0.7
"""Area fraction above which more discs make no gas."""

BEGIN_EVENTS = 1.5
"""Events that predicting the first one of a disc is worth."""


def events_expected(scene: Scene, duration: float, *, has_grid: bool) -> float:
    """Return about how many events a scene has in a time, s.

    With a grid, discs that leave their cells are among them.

    Where nothing is known of them, as with gravity or without an end, there are
    :data:`MOST_AHEAD` for each disc.
    """
    c = scene.columns
    discs = int(c.is_free.sum())
    if discs == 0 or any(scene.gravity) or math.isinf(duration):
        return MOST_AHEAD * discs
    speed = float(np.hypot(c.vx, c.vy)[c.is_free].mean())
    places = np.stack([c.x, c.y], axis=-1)[c.is_free]
    radii = c.bounding_radius[c.is_free][:, np.newaxis]
    width = 2 * float(radii.mean())
    area = float(np.ptp([places - radii, places + radii], axis=(0, 1)).prod())
    share = min(math.pi * float((radii**2).sum()) / area, DENSEST)
    crowding = (1 - 7 * share / 16) / (1 - share) ** 2
    hits = discs / area * width * math.sqrt(2) * speed * crowding
    borders = 4 / math.pi * speed / width if has_grid else 0.0
    return discs * (BEGIN_EVENTS + duration * (hits + borders))
