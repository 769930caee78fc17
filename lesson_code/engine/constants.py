"""The numbers that the engine's stages share: value, unit, reason, what breaks without them."""

from __future__ import annotations

SLOP = 0.005
"""Of the smaller body's width: overlap that is left alone, so that resting contacts stay contacts.

At 0 a resting contact opens and closes in turn and jitters; at 0.1 bodies stand visibly in each
other. Relative to the bodies, because 5 mm is nothing for a wall and everything for a grain.
"""

FINE_SLOP = 5e-4
"""The same for the direct solver, whose contacts neither sink nor jitter, and need less room.

At 0 its resting contacts too would open and close in turn.
"""

SEAM = 1e-6
"""Of a body's width: a step of the floor that is lower is none, but the rounding of its pieces.

At 0 a floor whose pieces are a rounding error apart is rough; at 0.01 bodies pass over real steps.
"""

PUSH_SHARE = 0.2
"""Of the overlap beyond the slop: how much is undone in one step.

At 1 a pile pushes itself apart, because each contact corrects the whole fault for itself; at
0.01 a stack under load sinks faster than it is lifted. 0.2 is the usual value (box2d-lite).
"""

IMPACT_DEPTH = 0.5
"""Of the slop: how far a fast body is let into another one, so that the impact is a contact.

At 0 they would only touch, and touching is no contact; at 1 and more they would be pushed apart.
"""

MOST_IMPACTS = 64
"""Impacts of fast bodies in one step. A ball of 1e6 m/s between two walls would make thousands."""

FEWEST_FOR_GRID = 24
"""Bodies: below this comparing all pairs is as fast as keeping a grid."""

LARGEST_IN_GRID = 4.0
"""Times the median size: a body larger than this would make the cells too wide for the others."""

CELL_MARGIN = 1.01
"""Times the largest body in the grid: how wide a cell is. Rounding must not make bodies that fill
a cell exactly reach beyond the next one, or most of a heap of equal discs would count as large.
"""

SLOTS_PER_BODY = 2
"""Slots of the grid for each body: half of them empty, so that few cells share one."""

PAIRS_PER_BODY, PAIRS_ANYWAY = 50, 10_000
"""More candidate pairs than 50 N + 10,000 are refused: discs that do not overlap have 3 N.

Only bodies heaped into one another make more; 10,000 in one place would make 50 million, and
fill the memory before the first step.
"""

LEAST_DETERMINANT = 1e-9
"""Of two contact points, 1 - k12^2 / (k11 k22): below this they are too close to tell apart.

At 0 they are one point, and how they share the load is undefined; the equations for two lose as
many digits as this has zeros. Box2D, with the 7 digits of single precision, takes 1e-3; with 16,
points 1 cm apart on a body of 1 m would then be solved in turn, and the answer would hang on
which comes first.
"""
