"""The numbers of the event-driven solver: value, unit, reason, what breaks without them."""

from __future__ import annotations

STILL = 1e-15
"""Of the scene's speed: an approach slower than this is rounding.

Without it two discs that move on side by side would collide for ever at one instant. In 10 s at
1 m/s it lets them overlap by 1e-14 m.
"""

REST = 1e-13
"""Of the scene's speed: a disc that leaves a face slower than this rests on it.

The bounces that are left would take 2 v / (g (1 - e)): with g = 10 m/s^2 and e = 0.8 less than
1e-12 s. Without it a ball would bounce for ever, in ever shorter times.
"""

CLOCK = 2.3e-16
"""Of the time: the clock's last digit. It changes the speed of a bounce by up to g CLOCK t.

A disc rests, too, if a bounce takes less than that from its speed. Without it a ball with e = 0.98
that has bounced for 40 s would go on for ever: the last digit gives it what the bounces take.
"""

LEAST_LOSS = 1e-3
"""Of the speed in a bounce: less counts as this in the rule above.

In so long a series the last digits cancel out. Without it a ball with e = 0.999999 would rest
too soon.
"""

PLACE = 4.4e-16
"""Of a place: two of its last digits. A perfectly elastic disc that hops no higher rests.

Without it a ball with e = 1 that is put on the floor, 1e-16 m too high by rounding, would bounce
for ever, fifty million times a second.
"""

GRIPS = 1e-12
"""Of the scene's speed: sliding slower than this is none; friction holds it.

When sliding ends, rounding leaves about 1e-16 of it. Without it the disc would begin to slide
again, in turn to either side.
"""

SLOW = 1e-9
"""Of the scene's speed: discs that approach slower than this lose no energy any more.

Three discs in a row with e below 7 - 4 sqrt(3) collide infinitely often in a finite time (inelastic
collapse). By then the approach is so slow that all the energy in it is below 1e-18 of the whole.
"""

HOP = 1e-2
"""Of the speed of a fall by a radius: slower than this, discs in a pile lose no energy.

Discs that rest on each other press on each other, and their motion has no closed form. They are
let hop: by less than 1e-4 of a radius, some hundred times a second. At 0 a pile would need
endlessly many collisions; at 1 it would never come to rest.
"""

LEAST_HOP = 1 / 16
"""Of a hop: a disc in a pile leaves an obstacle no slower, unless it is perfectly elastic.

Without it one that happens to come very slowly would bounce a million times before its
neighbours move.
"""

PILE_HOPS = 8.0
"""Hops: a disc that has met no other disc for so long is not in a pile any more."""

MOST_EVENTS_AT_ONCE = 1_000
"""For each disc, at one instant or (of discs in piles) within one hop: more are an endless loop.

Bounces of one disc on obstacles alone come to an end, however many there are: with e = 0.99 some
thousand within a hop. A pile of discs of very different mass comes to this; stepping solves it,
exact events do not.
"""

MOST_CELLS = 512
"""Cells that an obstacle may be noted in; a larger one is looked at from everywhere."""

CELL_MARGIN = 1e-9
"""Of a cell: so much wider is it than the largest disc; rounding then takes no neighbour away."""

EVENTS_A_CALL = 10_000
"""Then the loop comes back to its driver. So a run can be compiled that turns out to be long, or be
interrupted from the keyboard, and what is counted in whole numbers of 32 bits stays small."""

EVENT_SECONDS = 2e-5
"""s, of plain Python for an event; 0.7e-5 (thin gas) to 3e-5 (dense) were measured on the machine
whose speed `engine.compiled.choice` compares with."""

MOST_AHEAD = 10.0
"""Times the work that is done: the most that is expected of what is left."""

RECORD_ROWS = 4_096
"""Impulses that are written down before the driver takes them away."""

TIE_TIME = 1e-12
"""Of the time: two collisions that are this close together come at once, but for rounding. At 0 a
rack that a cue ball hits in the middle breaks askew; 1e-12 s is far less than any two by chance."""

LONG_AGO = 1e8
"""Times that: a disc that has not collided for so long is in no series of ever faster hits."""
