"""The tables of the event-driven solver: discs that each live in their own time."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

from lesson_code.engine.core.rows import (
    BodyRow,
    ContactRow,
    ImpulseRow,
    IndexRow,
    NumberRow,
    VectorRow,
)
from lesson_code.engine.event_driven.constants import EVENTS_A_CALL
from lesson_code.geometry.rows import Corner

NOTHING, GRIP, END, OBSTACLE, DISC = range(5)
"""What a disc's next event is: none, no more sliding, no more face, a hit, a hit. Of two at the
same time the one that stands first here comes first."""


@dataclass(slots=True)
class DiscRow:
    """A disc: its state at a time of its own, how it moves from there, and its next event.

    Two blocks of 64 bytes are all there is where nothing falls, turns or rubs: what neighbours
    read when they look ahead stands in the first.
    """

    time: float = 0.0  # s, when the disc had the state below
    x: float = 0.0  # m
    y: float = 0.0
    vx: float = 0.0  # m/s
    vy: float = 0.0
    radius: float = 0.0  # m
    cell_x: int = 0  # the grid cell of the centre
    cell_y: int = 0
    next_in_slot: int = -1  # the next disc in the same slot of the grid; -1 for the last
    changes: int = 0  # how often this disc's motion has changed

    event_time: float = math.inf  # s, of the next event, borders left aside
    border_time: float = math.inf  # s, when it leaves its cell, if nothing happens before
    event_kind: int = NOTHING
    partner: int = -1  # the other disc, or the obstacle
    feature: int = 0  # of the obstacle: an edge k, or the corner k as -1 - k
    partner_changes: int = 0  # the partner's `changes` when the event was predicted
    border_side: int = 0  # by which side it leaves the cell: 0 right, 1 left, 2 up, 3 down
    body: int = 0  # its place in the scene
    inv_m: float = 0.0  # 1/kg
    met: float = -math.inf  # s, when it last met a disc
    restitution: float = -1.0  # negative: left to the other body

    friction: float = -1.0  # likewise
    inv_i: float = 0.0  # 1/(kg m^2)
    angle: float = 0.0  # rad
    w: float = 0.0  # rad/s
    ax: float = 0.0  # m/s^2, the same until the next event
    ay: float = 0.0
    alpha: float = 0.0  # rad/s^2, likewise
    support: int = -1  # the obstacle whose face the disc rests on; -1: it flies
    face: int = 0  # which face
    held: bool = False  # whether a second face holds it too: it does not move at all


@dataclass(slots=True)
class EventRow:
    """The earliest event among some discs, in the queue."""

    time: float = math.inf  # s
    disc: int = 0  # to which it happens


@dataclass(slots=True)
class SlotRow:
    """A slot of the grid: cells whose numbers agree in their last digits share it."""

    first_disc: int = -1  # the first disc with its centre in one of them; -1: there is none
    first_near: int = -1  # the first NearRow of one of them; -1: there is none


@dataclass(slots=True)
class NearRow:
    """An obstacle that a disc with its centre in this cell might touch."""

    obstacle: int = 0
    cell_x: int = 0
    cell_y: int = 0
    next_in_slot: int = -1


@dataclass(slots=True)
class MomentRow:
    """A time at which the states of all discs are wanted."""

    time: float = 0.0  # s


@dataclass(slots=True)
class ExactState:
    """What belongs to the whole scene."""

    now: float = 0.0  # s, the time of the last event
    gravity_x: float = 0.0  # m/s^2
    gravity_y: float = 0.0
    restitution_rule: int = 0  # how the pair's value comes from two bodies' (mixing.py)
    friction_rule: int = 0
    cell_size: float = 1.0  # m, width of a grid cell: no disc is wider; infinite: one cell
    slot_count: int = 1  # of the grid, a power of two
    row_stride: int = 1  # slots from a cell to the one above it
    first_x: int = 0  # the outermost cells, which have no outer border
    last_x: int = 0
    first_y: int = 0
    last_y: int = 0

    still: float = 0.0  # m/s, an approach slower than this is none
    rest: float = 0.0  # m/s, a disc that leaves a face slower than this stays on it
    grips: float = 0.0  # m/s, sliding slower than this is none
    slow: float = 0.0  # m/s, discs that approach slower than this lose no energy
    hop: float = 0.0  # m/s, in a pile impacts slower than this lose no energy
    pile_time: float = 0.0  # s, a disc that has met no disc for so long is in no pile

    until: float = -math.inf  # s, later events are left alone
    moments: int = 0  # times before `until` at which states are noted
    moments_done: int = 0
    frame_rows: int = 0  # rows in use: those of all bodies at the moments that are done
    stops_at_collision: bool = False  # whether to stop after the next one, too
    stops_at_tie: bool = False  # whether to stop where two collisions of a disc come at one time
    ties: int = 0  # of those so far
    has_begun: bool = False  # whether the first events have been predicted
    events_left: int = EVENTS_A_CALL  # after so many more the driver has a look

    collisions: int = 0  # since the driver has last counted them
    impulse_count: int = 0  # rows in use
    events_at_once: int = 0  # so far, at this very instant
    window: float = 0.0  # s, the time of one hop: for so long events in piles are counted
    window_start: float = 0.0  # s, when that counting began
    events_in_piles: int = 0  # since then


class Tables(NamedTuple):
    """All tables of a running scene."""

    state: ExactState
    discs: list[DiscRow]
    obstacles: list[BodyRow]
    obstacle_bodies: list[IndexRow]  # the obstacles' places in the scene
    corners: list[Corner]
    queue: list[EventRow]  # of all discs' events, the earliest in row 1
    slots: list[SlotRow]  # of the grid
    near: list[NearRow]
    everywhere: list[IndexRow]  # obstacles that are near everywhere
    contact: ContactRow  # scratch for a collision
    impulses: list[ImpulseRow]  # the record, until the driver takes it away
    moments: list[MomentRow]
    positions: list[VectorRow]  # of all bodies at those times; the program notes the discs'
    velocities: list[VectorRow]
    angles: list[NumberRow]
    spins: list[NumberRow]
