"""The families that the default call is known not to hold: a seed, and what goes wrong there.

Each is a strict expected failure: when its law holds at that seed, its line has to go. The families
that are not in this list are searched by Hypothesis.
"""

from __future__ import annotations

KNOWN_TO_FAIL: dict[str, tuple[int, str]] = {
    "angular-momentum-rough": (1, "friction acts at two points of an overlap, which is a torque"),
    "angular-momentum-smooth": (2, "impulses act at two points of an overlap, which is a torque"),
    "arch-of-stones": (1, "stones that touch exactly sink into each other, and the arch settles"),
    "ball-in-pit": (2, "in a step with a bounce the height changes with the old velocity"),
    "ball-on-rod": (1, "in a step with a bounce the height changes with the old velocity"),
    "balls-in-pit": (0, "in a step with a bounce the height changes with the old velocity"),
    "bouncy-stack-at-rest": (
        1,
        "bodies that touch exactly fall freely in the first step, and bounce",
    ),
    "box-in-cage": (1, "between two steps a body is drawn on in a straight line, through a wall"),
    "box-over-floor": (2, "in a step with a bounce the height changes with the old velocity"),
    "closing-walls": (
        1,
        "a slow ball is found late at each wall, so that a hit is missed in the end",
    ),
    "creep-on-slope": (2, "a box that touches exactly slides freely in the first step"),
    "cue-between-two-balls": (0, "a cue that flies is found inside both balls, with other normals"),
    "cue-into-rack": (1, "hits at one instant are played one after the other"),
    "dropped-into-each-other": (3, "boxes in one heap lift each other out of it"),
    "dropped-stack": (2, "in a step with a bounce the height changes with the old velocity"),
    "dull-rod-on-rough-floor": (
        1,
        "a thin rod that touches stalls in parts of steps, while gravity acts in whole ones",
    ),
    "elastic-rod": (1, "in a step with a bounce the height changes with the old velocity"),
    "forces-in-stack": (1, "a tall stack is still settling by a hair after a second"),
    "heap-of-discs": (2, "pushing bodies out of each other lifts them, and that is energy"),
    "heavier-upwards": (0, "a contact under a heavy load sinks in by more than a thousandth"),
    "into-a-corner": (1, "between two steps a body is drawn on in a straight line, through a wall"),
    "ladder-at-a-wall": (2, "a ladder that touches exactly begins to move before it is held"),
    "light-and-heavy-in-turn": (5, "a very light box between heavy ones is squeezed out"),
    "load-among-discs": (
        2,
        "forty bodies elsewhere take the exact solution of the contacts away from two",
    ),
    "moving-frame": (
        0,
        "what counts as fast is the speed against the origin, not against the floor",
    ),
    "nearly-straight-sides": (
        2,
        "the contact changes from one half of a side to the other, for ever",
    ),
    "polygon-over-floor": (2, "in a step with a bounce the height changes with the old velocity"),
    "polygons-fall-into-pit": (
        0,
        "pushing bodies out of each other lifts them, and that is energy",
    ),
    "rod-at-any-step": (
        1,
        "a thin rod that touches stalls in parts of steps, while gravity acts in whole ones",
    ),
    "rod-on-rough-floor": (
        0,
        "in a step with a bounce the height changes, and Newton's e gains with friction",
    ),
    "rod-on-smooth-floor": (2, "in a step with a bounce the height changes with the old velocity"),
    "seen-between-steps": (4, "a fast ball that touches the floor at the start goes into it"),
    "seesaw": (2, "the post lets the plank sink in unevenly"),
    "shot-at-tower": (
        1,
        "between two steps a body is drawn on in a straight line, through the boxes",
    ),
    "stack-of-21-to-64": (
        5,
        "one corner of two that touch exactly is dropped, and the stack leans",
    ),
    "stack-of-any-size": (
        7,
        "one corner of two that touch exactly is dropped, and the stack leans",
    ),
    "steps-in-turn": (1, "a long step lets bodies fall far before they are held"),
    "sunk-in-the-floor": (0, "a body that comes out of the floor bounces"),
    "thin-slabs": (3, "the lowest of thin slabs that touch exactly falls through the floor"),
    "three-logs": (2, "sinking in by a slop moves logs that stand by a hair, or that spread"),
    "tipping-box": (0, "the lower corner sinks in, and the box leans"),
    "toppling-rod": (
        2,
        "a thin rod that touches stalls in parts of steps, while gravity acts in whole ones",
    ),
    "tower-of-any-masses": (0, "a very light box between heavy ones is squeezed out"),
    "two-fast-bodies": (2, "two fast boxes meet between two steps, and are not seen"),
}
"""By family: the seed of a draw that fails, and the reason."""
