"""The engine's tables: rows with named fields, which the stages read and write.

A table is a list of rows; a row is an object with fixed fields (``__slots__``). The stages use
nothing else: field names, whole-number indices, plain arithmetic and loops. That keeps them
readable, and leaves no more to a compiler than it can take.

Tables have room for more rows than are in use; how many are in use is counted in ``State``.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

from lesson_code.geometry.rows import Corner, ManifoldRow


@dataclass(slots=True)
class BodyRow:
    """A body as it moves. Fields up to `corner_count` are what the narrow phase reads."""

    x: float = 0.0  # m, centre of mass
    y: float = 0.0
    cos: float = 1.0  # of the angle; follows it
    sin: float = 0.0
    radius: float = 0.0  # m, of a circle, or a segment's half thickness; 0 for a polygon
    first_corner: int = 0  # where the outline begins in the table of corners
    corner_count: int = 0  # 0 circle, 2 segment, 3 and more polygon

    angle: float = 0.0  # rad, counter-clockwise
    vx: float = 0.0  # m/s
    vy: float = 0.0
    w: float = 0.0  # rad/s, counter-clockwise
    push_vx: float = 0.0  # m/s, moves the body out of an overlap in the next step, then is 0
    push_vy: float = 0.0
    push_w: float = 0.0  # rad/s, likewise

    inv_m: float = 0.0  # 1/kg, 0 for a body that nothing can push
    inv_i: float = 0.0  # 1/(kg m^2), 0 for a body that nothing can turn
    restitution: float = -1.0  # negative: left to the other body
    friction: float = -1.0  # negative: left to the other body
    extent: float = 0.0  # m, smallest width; the scale for what overlap is small

    thickness: float = math.inf  # m, smallest width of its matter; infinite: nothing pushes it
    reach: float = 0.0  # m, distance of its farthest point from the centre of mass
    is_fast: bool = False  # whether it may pass through another body within this step
    waits: bool = False  # whether it stays where it is for what is left of this step

    min_x: float = 0.0  # m, the box around the shape, parallel to the axes
    min_y: float = 0.0
    max_x: float = 0.0
    max_y: float = 0.0

    cell_x: int = 0  # the grid cell that holds the box's lower left corner
    cell_y: int = 0
    next_in_cell: int = -1  # the next body in the same slot of the grid; -1 for the last
    tally: int = 0  # counter for sorting the pairs
    static_contact: int = -1  # the last contact with a static body; -1: none, or not looked for


@dataclass(slots=True)
class PairRow:
    """A candidate pair: two bodies whose boxes overlap, a < b."""

    a: int = 0
    b: int = 0


@dataclass(slots=True)
class IndexRow:
    """A whole number in a table: a body in the order of a sweep, or the first in a grid slot."""

    index: int = -1


@dataclass(slots=True)
class ContactRow:
    """One contact point of two bodies during one step."""

    a: int = 0  # bodies, a < b
    b: int = 0
    feature: int = 0  # which features of the shapes touch; the same in the next step
    nx: float = 0.0  # unit normal from a to b
    ny: float = 0.0
    ax: float = 0.0  # m, lever arm on a: from its centre of mass to the point on its surface
    ay: float = 0.0
    bx: float = 0.0  # m, lever arm on b
    by: float = 0.0
    penetration: float = 0.0  # m, > 0
    restitution: float = 0.0  # of the pair
    friction: float = 0.0  # of the pair

    next_static: int = -1  # the one before among the pushed body's contacts with static bodies
    is_covered: bool = False  # whether it is with an edge inside a floor (seams.py)

    case: int = 3  # what the direct solver takes the contact for at first (contact_problem.py)

    is_block: bool = False  # whether this row and the next are solved together: one manifold
    coupling: float = 0.0  # 1/kg, in a block: the velocity at one point from 1 N s at the other
    normal_mass: float = 0.0  # kg, effective mass along the normal
    tangent_mass: float = 0.0  # kg, along the tangent, which is the normal turned by +90 degrees
    target_vn: float = 0.0  # m/s, relative normal velocity to reach at least: the bounce
    push_speed: float = 0.0  # m/s, >= 0, speed at which the overlap is to be undone

    normal_impulse: float = 0.0  # N s, >= 0, received by b along the normal so far
    tangent_impulse: float = 0.0  # N s, received by b along the tangent so far
    push_impulse: float = 0.0  # N s, >= 0, of the position correction; never enters v


@dataclass(slots=True)
class MemoryRow:
    """The impulses of a contact of the last step, for warm starting."""

    a: int = 0
    b: int = 0
    feature: int = 0
    normal_impulse: float = 0.0
    tangent_impulse: float = 0.0


@dataclass(slots=True)
class State:
    """The one row that belongs to the whole world: its settings and its counts."""

    dt: float = 0.0  # s, of the step, or of the part of it that is made now
    dt_before: float = 0.0  # s, of the step before; 0: there was none
    time: float = 0.0  # s, at the end of the step, or of the part of it that is made now
    end: float = 0.0  # s, at the end of the whole step
    left: float = 0.0  # s, of the step that is split at impacts
    impacts: int = 0  # parts that it has been split into
    thinnest: float = math.inf  # m, the least thickness of all bodies
    gravity_x: float = 0.0  # m/s^2
    gravity_y: float = 0.0
    damping: float = 0.0  # 1/s
    iterations: int = 0  # sweeps over the contacts in a step
    restitution_rule: int = 0  # how the pair's value comes from two bodies' (combination.py)
    friction_rule: int = 0
    cell_size: float = 1.0  # m, of the grid

    pair_count: int = 0  # rows in use
    contact_count: int = 0
    memory_count: int = 0
    softened: int = 0  # islands so far that had no exact answer (the direct solver alone counts)


class World(NamedTuple):
    """All tables of a running scene."""

    state: State
    bodies: list[BodyRow]
    corners: list[Corner]
    pairs: list[PairRow]
    sorted_pairs: list[PairRow]  # scratch for the sort
    order: list[IndexRow]  # bodies sorted along x, for the sweep
    slots: list[IndexRow]  # of the grid: the first body in each
    contacts: list[ContactRow]
    memory: list[MemoryRow]
    manifold: ManifoldRow  # scratch for the narrow phase
