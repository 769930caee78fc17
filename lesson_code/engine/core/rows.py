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
    """A body as it moves. What is used together stands together, eight numbers to a block."""

    vx: float = 0.0  # m/s
    vy: float = 0.0
    w: float = 0.0  # rad/s, counter-clockwise
    inv_m: float = 0.0  # 1/kg, 0 for a body that nothing can push
    inv_i: float = 0.0  # 1/(kg m^2), 0 for a body that nothing can turn
    pseudo_vx: float = 0.0  # m/s, moves the body out of an overlap in the next step, then is 0
    pseudo_vy: float = 0.0
    pseudo_w: float = 0.0  # rad/s, likewise

    start_vx: float = 0.0  # m/s, noted before forces, impacts or springs change it
    start_vy: float = 0.0
    start_w: float = 0.0  # rad/s
    seen_x: float = 0.0  # m, where it was when its box was drawn (next_contact.py)
    seen_y: float = 0.0
    seen_angle: float = 0.0  # rad
    room: float = 0.0  # m, how far it may move in the box
    moved: float = 0.0  # m, how far it has
    way: float = 0.0  # m, how far it may go in this part of a step

    x: float = 0.0  # m, centre of mass
    y: float = 0.0
    cos: float = 1.0  # of the angle; follows it
    sin: float = 0.0
    angle: float = 0.0  # rad, counter-clockwise
    radius: float = 0.0  # m, of a circle, or a segment's half thickness; 0 for a polygon
    min_width: float = 0.0  # m, smallest width; the scale for what overlap is small
    first_corner: int = 0  # where the outline begins in the table of corners
    corner_count: int = 0  # 0 circle, 2 segment, 3 and more polygon

    min_x: float = 0.0  # m, the box drawn around the shape, parallel to the axes
    min_y: float = 0.0
    max_x: float = 0.0
    max_y: float = 0.0
    static_contact: int = -1  # the last contact with a static body; -1: none, or not looked for
    is_fast: bool = False  # whether it may pass through another body within this step
    colours: int = 0  # of its contacts so far, a bit for each (visits.py)
    waits: bool = False  # whether it stays where it is for what is left of this step
    is_asleep: bool = False
    is_restless: bool = False  # of an island's first body: whether one of its bodies is not still
    restitution: float = -1.0  # negative: left to the other body
    friction: float = -1.0  # negative: left to the other body
    bounding_radius: float = 0.0  # m, distance of its farthest point from the centre of mass
    quiet: float = 0.0  # s, for how long it has been still
    island: int = 0  # the first body of the island that it belongs to (islands.py)
    gained: float = 0.0  # J, of an island's first body: what its bounces have gained (impacts.py)
    rounding: float = 0.0  # J, up to which a loss is none
    lost: float = 0.0  # J, what it loses without a bounce
    between: float = 0.0  # J, of the difference between the two motions
    mass: float = math.inf  # kg, and kg m^2, as a page gives them; its program inverts them and
    inertia: float = 0.0  # takes 0 for the inertia of the filled shape (view/browser/set_up.py)


@dataclass(slots=True)
class PlaceRow:
    """What the broad phase notes of a body: its place in the grid, and a counter."""

    cell_x: int = 0  # the grid cell that holds the lower left corner of the body's box
    cell_y: int = 0
    next_in_cell: int = -1  # the next body in the same slot of the grid; -1 for the last
    tally: int = 0  # counter for sorting the pairs
    is_large: bool = False  # whether the box is too large for the grid


@dataclass(slots=True, order=True)
class PairRow:
    """A candidate pair: two bodies whose boxes overlap, a < b."""

    a: int = 0
    b: int = 0
    seen_gap: float = 0.0  # m, between their skins when it was looked at; 0: it was not
    seen_dx: float = 0.0  # m, from a to b then (next_contact.py)
    seen_dy: float = 0.0
    seen_angle_a: float = 0.0  # rad
    seen_angle_b: float = 0.0


@dataclass(slots=True)
class BoxRow:
    """The box around a body, in the order of the grid's slots."""

    min_x: float = 0.0  # m
    min_y: float = 0.0
    max_x: float = 0.0
    max_y: float = 0.0
    cell_x: int = 0
    cell_y: int = 0
    body: int = 0


@dataclass(slots=True)
class IndexRow:
    """A whole number in a table: a body in the order along x, or the first in a slot."""

    index: int = -1


@dataclass(slots=True)
class ContactRow:
    """One contact point of two bodies during one step.

    What a sweep reads stands first, eight numbers to a block: for the normal and the pushes, for
    friction, and for two points of one manifold.
    """

    a: int = 0  # bodies, a < b
    b: int = 0
    nx: float = 0.0  # unit normal from a to b
    ny: float = 0.0
    ra_x_n: float = 0.0  # m, lever arm on a about its centre of mass, of an impulse along n
    rb_x_n: float = 0.0  # m, on b
    normal_mass: float = 0.0  # kg, effective mass along the normal
    pseudo_speed: float = 0.0  # m/s, speed at which the overlap is still to be undone
    pseudo_impulse: float = 0.0  # N s, >= 0, of the position correction; never enters v

    ra_x_t: float = 0.0  # m, of an impulse along the tangent, which is n turned by +90 degrees
    rb_x_t: float = 0.0  # m
    tangent_mass: float = 0.0  # kg, along the tangent
    skew: float = 0.0  # 1/kg, the tangent velocity that 1 N s along the normal makes
    friction: float = 0.0  # of the pair
    target_vn: float = 0.0  # m/s, relative normal velocity to reach at least: the bounce
    normal_impulse: float = 0.0  # N s, >= 0, received by b along the normal so far
    tangent_impulse: float = 0.0  # N s, received by b along the tangent so far

    block_mass: float = 0.0  # kg, in a block: inverse of K, N s here for 1 m/s at this point alone
    shared_mass: float = 0.0  # kg, and N s at the other point
    k_cross_tangent: float = 0.0  # 1/kg, velocity here along the tangent from 1 N s at the other
    k_own: float = 0.0  # 1/kg, Delassus matrix, velocity here from 1 N s here
    k_cross: float = 0.0  # 1/kg, off its diagonal: here from 1 N s at the other point
    is_block: bool = False  # whether this row and the next are solved together: one manifold

    ax: float = 0.0  # m, lever arm on a: from its centre of mass to the point on its surface
    ay: float = 0.0
    bx: float = 0.0  # m, lever arm on b
    by: float = 0.0
    penetration: float = 0.0  # m, > 0
    restitution: float = 0.0  # of the pair
    feature: int = 0  # which features of the shapes touch; the same in the next step
    colour: int = 0  # contacts of one colour share no body that can be pushed (visits.py)
    is_covered: bool = False  # whether it is with an edge inside a floor (internal_edges.py)
    next_static: int = -1  # the one before among the pushed body's contacts with static bodies
    case: int = 3  # what the direct solver takes the contact for at first (contact_problem.py)
    remembered: float = -1.0  # N s, what it has needed before, for a step as long; -1: it is new

    # Of the solver with sub-steps; there the impulses above are those of one sub-step
    gap_origin: float = 0.0  # m, the gap less the part that follows the bodies' places and angles
    soft_mass: float = 0.0  # kg, effective mass along the normal of a contact that gives way
    slack_vn: float = 0.0  # m/s, <= 0, normal velocity that impacts have left to the next step
    softness: float = 0.0  # 1/kg, >= 0: speed by which it gives way for 1 N s that it carries
    soft_vn: float = 0.0  # m/s, relative normal velocity to reach at least, but for giving way
    normal_total: float = 0.0  # N s, of the impact and of the sub-steps of this step so far
    tangent_total: float = 0.0  # N s


@dataclass(slots=True)
class ColourRow:
    """A colour of contacts, of manifolds or of single ones (visits.py)."""

    left: int = 0  # visits of that colour that are still to get a place in the lanes
    place: int = 0  # the next of these places


@dataclass(slots=True)
class MemoryRow:
    """The impulses of a contact of the last step, for warm starting."""

    a: int = 0
    b: int = 0
    feature: int = 0
    normal_impulse: float = 0.0
    tangent_impulse: float = 0.0


@dataclass(slots=True)
class RestingRow:
    """A contact of an island that sleeps: what it is woken up with, and its record meanwhile."""

    a: int = 0
    b: int = 0
    feature: int = 0
    island: int = 0
    dt: float = 0.0  # s, of the step in which the impulses were given
    x: float = 0.0  # m, midway between the two surfaces
    y: float = 0.0
    nx: float = 0.0
    ny: float = 0.0
    normal_impulse: float = 0.0
    tangent_impulse: float = 0.0
    penetration: float = 0.0


@dataclass(slots=True)
class ImpulseRow:
    """The impulse of one contact point in one step, written down for the record."""

    time: float = 0.0  # s, end of the step
    a: int = 0
    b: int = 0
    x: float = 0.0  # m, midway between the two surfaces
    y: float = 0.0
    nx: float = 0.0
    ny: float = 0.0
    normal_impulse: float = 0.0
    tangent_impulse: float = 0.0
    penetration: float = 0.0


@dataclass(slots=True)
class VectorRow:
    """A body's place, m, or velocity, m/s, at a time that a run is wanted at."""

    x: float = 0.0
    y: float = 0.0


@dataclass(slots=True)
class NumberRow:
    """A body's angle, rad, or angular velocity, rad/s, at such a time."""

    value: float = 0.0


@dataclass(slots=True)
class State:
    """The one row that belongs to the whole world: its settings and its counts."""

    whole: float = 0.0  # s, of a whole step
    steps_done: int = 0  # whole steps
    steps_left: int = 0  # whole steps that are to be made
    steps_a_frame: int = 0  # after so many the states are noted; 0: they are not
    left: float = 0.0  # s, of the step that is being made; 0: none is
    impacts: int = 0  # parts that it has been split into; one with an impact may count for more
    dt: float = 0.0  # s, of the part that is made now
    dt_before: float = 0.0  # s, of the one before; 0: there was none
    time: float = 0.0  # s, at the end of the part that is made now
    has_moved: bool = False  # whether its bodies have moved already
    is_prepared: bool = False  # whether the contacts of the part are ready (sub-steps)
    has_fast: bool = False  # whether a fast body has stopped a run that splits no steps
    thinnest: float = math.inf  # m, the least thickness of all bodies that can be pushed
    horizon: float = math.inf  # s, when a contact that is seen will be reached (the direct solver)
    reach: float = math.inf  # m, how far a body may move without being watched
    skin: float = 0.0  # of a body's width: how far from its surface contacts are seen
    gravity_x: float = 0.0  # m/s^2
    gravity_y: float = 0.0
    damping: float = 0.0  # 1/s
    iterations: int = 0  # sweeps over the contacts in a step
    restitution_rule: int = 0  # how the pair's value comes from two bodies' (mixing.py)
    friction_rule: int = 0
    cell_size: float = 1.0  # m, of the grid
    slot_count: int = 1  # slots of the grid, a power of two
    row_stride: int = 1  # slots from a cell to the one above it
    box_count: int = 0  # boxes in the grid
    has_small_fixed: bool = False  # whether the grid holds bodies that nothing can push
    has_pairs: bool = False  # whether the pairs are those of the boxes as they are drawn

    pair_count: int = 0  # rows in use
    candidate_count: int = 0  # the same with those behind them that are apart (next_contact.py)
    contact_count: int = 0
    static_count: int = 0
    visit_count: int = 0
    lanes_of_two: int = 0  # the first visits, to manifolds, which are made in lanes (visits.py)
    lanes_of_one: int = 0  # and where the visits to single contacts end that are, too
    memory_count: int = 0
    impulse_count: int = 0
    resting_count: int = 0
    frame_rows: int = 0

    pairs_wanted: int = 0  # rows that a table was too small for; 0: it was not
    contacts_wanted: int = 0
    impulses_wanted: int = 0
    lost_body: int = -1  # one that has left the range of floating point

    substeps: int = 1  # motions in a step for one contact finding; during them dt is that of one
    omega: float = 0.0  # rad/s, natural frequency of soft contacts
    free_count: int = 0  # bodies that can be pushed
    asleep_count: int = 0  # those of them that sleep
    only_blows: bool = False  # whether contacts pass blows alone, and carry nothing (blows.py)
    has_moving_static: bool = False  # whether a body that nothing can push moves
    late_steps: int = 0  # so far, in which fast bodies had to wait after too many impacts
    softened: int = 0  # islands so far that had no exact answer (the direct solver alone counts)


class World(NamedTuple):
    """All tables of a running scene."""

    state: State
    bodies: list[BodyRow]
    corners: list[Corner]
    pairs: list[PairRow]
    sorted_pairs: list[PairRow]  # scratch for the sort
    places: list[PlaceRow]  # one for each body
    order: list[IndexRow]  # bodies sorted along x, for the sweep
    boxes: list[BoxRow]  # of the bodies that can be pushed, sorted by slot
    slots: list[IndexRow]  # of the grid: where the boxes of each begin
    fixed_slots: list[IndexRow]  # the first body in each that nothing can push
    contacts: list[ContactRow]
    visits: list[IndexRow]  # the contacts in the order of a sweep
    colours: list[ColourRow]  # of manifolds, then of single contacts
    static_contacts: list[IndexRow]  # those of them with a body that nothing can push
    memory: list[MemoryRow]
    resting: list[RestingRow]  # the contacts of islands that sleep
    impulses: list[ImpulseRow]  # the record, until somebody takes it away
    positions: list[VectorRow]  # the states after each step, a frame after the other
    velocities: list[VectorRow]
    angles: list[NumberRow]
    spins: list[NumberRow]
    manifold: ManifoldRow  # scratch for the narrow phase
