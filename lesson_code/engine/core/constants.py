"""The numbers that the engine's stages share: value, unit, reason, what breaks without them."""

from __future__ import annotations

SLOP = 0.005
"""Of the smaller body's width: overlap that is left alone, so that resting contacts stay contacts.

At 0 a resting contact opens and closes in turn and jitters; at 0.1 bodies stand visibly in each
other. Relative to the bodies, because 5 mm is nothing for a wall and everything for a grain.
"""

FINE_SLOP = 5e-4
"""The same for the direct solver, whose contacts neither sink nor jitter, and need less room.

At 0 what rounding makes of an overlap would be pushed out, and lift the body.
"""

SKIN = 1e-3
"""Of a body's width: how far from its surface the direct solver sees contacts.

At 0 a corner that lies on a face would be in contact or not by rounding, and a box would stand on
one of its two corners. At 0.1 bodies bounce before they visibly touch.
"""

SOFT_SKIN = 1e-6
"""The same for the solver with sub-steps, which is to see what touches at the start of a run.

At 0 a stack falls freely for the first step, and lands: one of 20 boxes in 50 sub-steps then hops
by metres. At 1e-3 bodies in a row that are a thousandth apart are struck as one.
"""

REACH = 0.5
"""Of the thinnest body's width: how far a body may move in a step unwatched.

At 1 one could pass through another between two looks. At 0.1 heaps take two to three times as long.
"""

INTERNAL_EDGE_TOLERANCE = 1e-6
"""Of a body's width: a lower step in the floor does not count; it is the rounding of its pieces.

At 0 a floor whose pieces are a rounding error apart is rough; at 0.01 bodies pass over real steps.
"""

BAUMGARTE_FACTOR = 0.2
"""Of the overlap beyond the slop: how much is corrected in one step.

At 1 a pile pushes itself apart, because each contact corrects the whole overlap on its own; at
0.01 a stack under load sinks faster than it is lifted. 0.2 is the usual value (box2d-lite).
"""

LEAST_EXCESS = 0.01
"""Of the slop: overlap beyond it by no more than this is left alone too.

An overlap that is corrected by a fixed share never vanishes. Without this margin a pile at rest
would be pushed by less and less for ever, at the cost of sweeps in every step.
"""

IMPACT_DEPTH = 0.5
"""Of the slop: how far a fast body may enter another one, so that the impact is a contact.

At 0 they would only touch, which is not a contact; at 1 or more they would be pushed apart.
"""

LEAST_PART = 1e-12
"""Of a step: the shortest part that one is split into by bodies with a skin. At 0 time may stop; at
1e-6 what flies at 1e7 m/s passes through a plate in it."""

LOOKS_AT_A_PART = 8
"""Looks at a part of a step for what touches within it. Each that finds something makes the part
shorter, and its way another one; the lengths converge to that until the bodies touch."""

NEAR = 1e-10
"""Of a body's width: two bodies with skins that are nearer than this touch. At half a skin they
would bounce off each other at an angle that is wrong by a thousandth."""

LAST_DIGITS = 1e-15
"""Of the bodies' coordinates: what is nearer than this touches, too; rounding tells no more."""

FINE_LOOKS, MOST_FINE = 8, 16
"""Looks in one step at what comes exactly when bodies touch, in islands of so many contacts. After
so many, and in larger islands, what is within the skin and closes is struck at once: a pile that
falls makes dozens of impacts in each step, and to stop at each costs as much as a step.
"""

LOOKS_OF_AN_IMPACT = 4
"""Looks that one counts for at whose start something has hit: two such in a step, but more where
a corner that turns is looked at again and again, and passes by."""

MOST_IMPACTS, IMPACTS_A_BODY = 64, 8
"""Impacts of fast bodies in one step, and for each body that can be pushed where that is more. A
ball of 1e6 m/s between two walls would make thousands; of a heap of planks that is poured into a
bin each has some at once, in the worst step.
"""

IMPACTS_TO_DOUBLE = 4
"""Impacts in one step after which a body is let go twice as deep, before the next one is seen."""

FASTEST_GROWTH = 2.0
"""Times what a contact has carried: what is more in a part of a step with impacts is a blow."""

FEWEST_FOR_GRID = 24
"""Bodies: below this comparing all pairs is as fast as keeping a grid."""

LARGEST_IN_GRID = 4.0
"""Times the median size: a larger body would make the cells too wide for the others."""

CELL_MARGIN = 1.01
"""Times the largest box in the grid: how wide a cell is. Rounding must not make boxes that fill
a cell exactly wider than it, or most of a heap of equal discs would count as large.
"""

LAST_CELL = 1e9
"""Number of the last cell of the grid on each side. A compiled program keeps the numbers in 32
bits: it would take cell 2^31 for cell -2^31, and lose the pairs between it and its neighbour.
"""

SLOT_RATIO = 0.6180339887498949
"""Of the slots: how far a cell is from the one above it. The golden section, (sqrt(5) - 1) / 2."""

STEPS_AHEAD = 4.0
"""Steps that the fastest body may move before the boxes are redrawn and pairs are searched again.

At 0 there would be a search in every step; at 20 every disc of a gas would be compared with many
distant ones.
"""

LEAST_MARGIN, MOST_MARGIN = 0.05, 0.35
"""Of a body's width: the margin of its box, at the least and at the most."""

FEWEST_FOR_ORDER = 64
"""Contacts: fewer are visited as they stand, from the ground up in a tower built that way."""

MOST_COLOURS = 31
"""Bits of a whole number of 32 that has a sign. A pyramid has four colours, a bin seven."""

MOST_FOR_COLOURS = 8_192
"""Contacts: with 40,000 of boxes colours take a third longer than strides, which stay in the cache.
"""

STRIDE = 6
"""Stride of a sweep over discs, in contacts: it goes through a part of the table six times.

Contacts side by side share a body, and a processor has to wait for the first before it can begin
with the second: in table order a heap of discs takes half as long again.
"""

PART_OF_SWEEP = 1_024
"""Contacts of discs that a sweep goes through in strides at a time: few enough to stay in the
cache. With 100,000 discs and all contacts at once a step takes nearly twice as long.
"""

PAIRS_PER_BODY, PAIRS_ANYWAY = 50, 10_000
"""More candidate pairs than 50 N + 10,000 are refused: discs that do not overlap have 3 N.

Only bodies heaped into one another make more; 10,000 in one place would make 50 million, and
fill the memory before the first step.
"""

LEAST_DETERMINANT = 1e-9
"""Of two contact points, 1 - k12^2 / (k11 k22): below this they are too close to tell apart.

At 0 they are one point, and how they share the load is undefined; the equations for two lose as
many digits as this has zeros. Box2D, with the 7 digits of single precision, takes 1e-3; with 16,
points 1 cm apart on a body of 1 m would then be solved in turn, and the answer would depend on
which comes first.
"""

SOFT_FREQUENCY = 0.25
"""Of the rate of the sub-steps: the frequency at which a soft contact would swing undamped.

A load F sinks by F h^2 / (m (2 pi 0.25)^2) until the contact carries it, h the sub-step. With 20
boxes on one another, each 1 cm off the line: at 0.2 they sink so far that they have leaned over by
1 m after 20 s, at 0.35 the springs are stiffer than one sweep can follow, and the stack shakes.
Box2D v3 allows up to the same share, and 30 Hz at the most. Of n sweeps in a sub-step each follows
springs as stiff, so that they may be n times as stiff together: with 3 or 4 a stack of 30 stands.
"""

MOST_SUNK, MOST_SUNK_IN_WALL = 0.1, 0.025
"""Of the lesser width: a soft contact that would give way by more to its load is made stiffer. The
lowest of 120 capsules 4 mm thick would be pressed through a floor that is a line.

What is pressed between a heavy body and a wall has no room: a fifth of its width is in the wall.
With half of it 6 of 300 heaps under a heavy ball lose a body through a wall, so 2 do.
"""

SOFT_DAMPING = 10.0
"""Damping ratio of a soft contact; 1 is critical damping. 10 is Box2D's value.

It corrects 7 % of an overlap in a sub-step. At 1 it would be 44 %, and the stack of 20 falls.
"""

SOFT_WAY, MOST_OF_LOAD = 0.01, 7.0
"""Of the lesser width: a contact that would move, in a sub-step, by more than this otherwise than
its spring asks for is solved again. And times the speed that gravity gives in a sub-step: impulses
of the last one that give a body more are not all load (loads.py).
"""

IMPACT_SWEEPS = 20
"""Sweeps over the contacts in which an impact is solved, at the most; two discs need one. So many
sweeps of pushes are made, too, where fewer leave bodies deep in one another: of 400 heaps in a bin,
4 let a body through the floor in 7, 20 in 3. With 200 a disc leaves a box too small for its discs.

At 4 a dense gas with e = 1 loses 4 % of its energy in 10 s, at 10 still 0.06 %.
"""

MOST_IMPACT_SWEEPS, IMPACT_WAY = 200, 5e-4
"""Sweeps at the most while bodies would still enter one another in a sub-step, and by which part of
the lesser width. Of two hundred balls that are thrown about, 20 sweeps let one into a wall by up to
0.14 of its radius, where a heavy one hits a crowd.
"""

ROUNDING_OF_WORK = 1e-12
"""Of the work of an impulse: less is rounding, and no gain of energy."""

IMPACT_ROUNDING = 1e-12
"""m/s: a slower approach is rounding, not an impact. At this speed a millimetre takes 30 years."""

SPEED_DOUBT = 1.5
"""Times the greatest speed that the energy of a scene allows: a margin for rounding, and for sweeps
that have not converged. A body that moves more than half its width in a step has to be watched.
"""

STILL = 1e-9
"""Of the speed that gravity gives in a step: a body that is slower is still.

A body at rest keeps this share of the speed that gravity gives and contacts take back, and less
with every step. A larger value would stop bodies that creep: 1e-9 is 0.16 nanometres a second at 60
steps a second, half a micrometre in an hour. Without gravity only a body
that does not move at all is still.
"""

QUIET_TIME = 1.0
"""s for which an island has to be still before it sleeps; so a pile never sleeps sooner."""

STEPS_A_LOOK = 8
"""Steps from one search for islands that may sleep to the next."""

MOST_FALLING, MOST_FOR_DIRECT, MOST_STANDING = 24, 40, 100
"""Bodies that can be pushed: up to 40 the direct solver suits any scene in which no more than 24
fall, and up to 100 one in which all stand from the start.

Its time grows with the cube of the contacts in an island, and where bodies fall on one another with
their impacts, too: for 30 discs that fall it takes thirty times as long as sweeps. What stands is
soon asleep.
"""

MOST_PRESSED, MOST_DRIFTING = 16, 64
"""Bodies that can be pushed: up to 64 the direct solver suits those that nothing presses together,
neither gravity nor a mover; in a program that is played it suits others up to 16.

In a program it has half a frame of 1/60 s. A pile of 12 falling discs takes 3 ms a step in the
median and 11 ms in the worst twentieth, one of 40 takes 57 ms there; 60 discs and a polygon that
drift take 2 ms and 6 ms. A crowd that flies fast takes longer, 60 boxes at 7 m/s, 2 m from one
another, 1 to 2 s for each second. Sub-steps take a twentieth of it; but then angular momentum
drifts by 1e-4 of what all have, and boxes lie in one another by half of their width.
"""

TOUCHING = 1e-6
"""Of the radius: discs that are nearer than this at the start touch, and are struck together."""
