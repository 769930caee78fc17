"""Foretelling: the next event is the earliest of all that could happen."""

from __future__ import annotations

import math
from itertools import combinations, permutations
from typing import Any

import numpy as np
import pytest

from lesson_code import Body, Circle, Material, Polygon, Scene, Segment, simulate
from lesson_code.engine.core.constants import FEWEST_FOR_GRID
from lesson_code.engine.core.mixing import mixing_rule
from lesson_code.engine.event_driven import ExactSolver
from lesson_code.engine.event_driven.event_prediction import hit_time, impact_after, note, predict
from lesson_code.engine.event_driven.loop import next_event, next_time
from lesson_code.engine.event_driven.motion import place_at
from lesson_code.engine.event_driven.rows import (
    DISC,
    END,
    GRIP,
    NOTHING,
    OBSTACLE,
    DiscRow,
    Tables,
)

ROUNDING = 1e-9
"""s: times found from states at other moments; 1e-13 was seen."""

OVERLAP = 1e-13
"""m: a place is right to 1e-15 m, and a hit comes at most that late."""

BALL = Material(restitution=0.9, friction=0.2)


def tables_for(*bodies: Body, **settings: Any) -> Tables:
    """Return the tables of a solver that has predicted all events."""
    return tables_for_events(Scene(bodies, **settings))


def tables_for_events(scene: Scene) -> Tables:
    """Return the tables of a solver whose events can be made one by one: it keeps no impulses."""
    return ExactSolver(scene, combine=mixing_rule("workbook"), keep_impulses=False).tables


def ball(radius: float = 0.5, **values: Any) -> Body:
    """Return a ball of 1 kg."""
    return Body(Circle(radius), **({"mass": 1.0, "material": BALL} | values))


def crowd(seed: int, gravity: tuple[float, float]) -> Scene:
    """Return 30 balls of all sizes in a box with a block and a disc that stand still."""
    rng = np.random.default_rng(seed)
    ends = (((-1, -1), (6, -1)), ((-1, 6), (6, 6)), ((-1, -1), (-1, 6)), ((6, -1), (6, 6)))
    walls = [Body(Segment(*pair), material=BALL) for pair in ends]
    block = Body(Polygon.box(0.8, 0.6), position=(2.5, 2.5), angle=0.4, material=BALL)
    post = Body(Circle(0.3), position=(0.5, 0.5), material=BALL)
    free = [k for k in range(36) if k not in (0, 7, 14, 15, 20, 21)]
    balls = [
        ball(
            rng.uniform(0.1, 0.3),
            position=(k % 6 + rng.uniform(-0.1, 0.1), k // 6 + rng.uniform(-0.1, 0.1)),
            velocity=rng.uniform(-3, 3, 2),
            mass=rng.uniform(0.5, 2),
        )
        for k in free
    ]
    return Scene([*walls, block, post, *balls], gravity=gravity)


def first_hit_of_any_pair(tables: Tables) -> float:
    """Return the time of the next hit of two discs, found among all pairs, s."""
    now, discs = tables.state.now, tables.discs
    moved = []
    for disc in discs:
        t = now - disc.time
        x, y = place_at(disc, now)
        moved.append(
            DiscRow(
                time=now,
                radius=disc.radius,
                x=x,
                y=y,
                vx=disc.vx + disc.ax * t,
                vy=disc.vy + disc.ay * t,
                ax=disc.ax,
                ay=disc.ay,
            )
        )
    pairs = combinations(moved, 2)
    return min(hit_time(tables.state, a, b) for a, b in pairs)


def next_hit_of_discs(tables: Tables) -> float:
    """Return the time of the earliest hit of two discs that is known and not stale, s."""
    return min(
        (
            disc.event_time
            for disc in tables.discs
            if disc.event_kind == DISC
            and tables.discs[disc.partner].changes == disc.partner_changes
        ),
        default=math.inf,
    )


@pytest.mark.parametrize("gravity", [(0.0, 0.0), (0.0, -9.81)], ids=["no gravity", "gravity"])
def test_next_event_is_before_the_first_hit_of_any_pair(gravity: tuple[float, float]) -> None:
    """The queue may hold borders and stale hits before it, but never comes too late.

    Where it is a hit of two discs it is the very same one.
    """
    tables = tables_for_events(crowd(1, gravity))
    hits = 0
    for event in range(1500):
        if event % 10 == 0:
            expected = first_hit_of_any_pair(tables)
            assert next_time(tables) <= expected + ROUNDING
            first = tables.discs[tables.queue[1].disc]
            is_fresh = first.event_kind == DISC and (
                first.event_time < first.border_time
                and tables.discs[first.partner].changes == first.partner_changes
            )
            if is_fresh:
                assert first.event_time == pytest.approx(expected, abs=ROUNDING)
            hits += is_fresh
        next_event(tables)
    assert hits > 10


@pytest.mark.parametrize("gravity", [(0.0, 0.0), (0.0, -9.81)], ids=["no gravity", "gravity"])
def test_bodies_never_overlap_at_any_time(gravity: tuple[float, float]) -> None:
    """Not by more than rounding: no hit of a disc, a face, a corner or a round post is missed."""
    scene = crowd(2, gravity)
    run = simulate(scene, 2.0, solver="exact", sample=np.linspace(0, 2, 400))
    assert len(run.contacts) > 50
    assert run.max_penetration.max() <= OVERLAP


# One event of each kind


def test_nothing_happens_to_a_disc_alone() -> None:
    """Its next event is none, never."""
    disc = tables_for(ball(velocity=(1, 2))).discs[0]
    assert (disc.event_kind, disc.event_time) == (NOTHING, math.inf)


def test_hit_of_two_discs_is_foretold_to_both() -> None:
    """2 m between them, at 4 m/s."""
    tables = tables_for(ball(velocity=(1, 0)), ball(position=(3, 0), velocity=(-3, 0)))
    assert [disc.event_kind for disc in tables.discs] == [DISC, DISC]
    assert [disc.event_time for disc in tables.discs] == [0.5, 0.5]
    assert [disc.partner for disc in tables.discs] == [1, 0]


def test_hit_of_an_obstacle_is_foretold_with_its_face() -> None:
    """5 m above the floor with g = 10 m/s^2; the upper face is that whose normal is up."""
    tables = tables_for(
        Body(Polygon.box(4, 1), position=(0, -0.5)), ball(position=(0, 5.5)), gravity=(0, -10)
    )
    disc = tables.discs[0]
    assert (disc.event_kind, disc.event_time, disc.partner) == (OBSTACLE, 1.0, 0)
    assert tables.corners[disc.feature].ny == pytest.approx(1.0)


def test_hit_of_a_corner_is_foretold_with_the_corner() -> None:
    """Straight down onto the end of a floor, half a radius beyond it."""
    tables = tables_for(Body(Segment((-4, 0), (0, 0))), ball(position=(0.25, 2), velocity=(0, -1)))
    disc = tables.discs[0]
    assert disc.event_kind == OBSTACLE
    assert disc.event_time == pytest.approx(2 - math.sqrt(3) / 4)
    corner = tables.corners[-1 - disc.feature]
    assert (corner.x, corner.y) == (0.0, 0.0)


def test_border_of_a_cell_is_foretold_with_its_side() -> None:
    """One of many discs: its cell is 1 m wide, and it is 0.25 m from the right border."""
    swarm = [ball(position=(3 * k, 30)) for k in range(FEWEST_FOR_GRID)]
    disc = tables_for(*swarm, ball(position=(0.75, 0.5), velocity=(0.5, 0))).discs[-1]
    assert (disc.event_kind, disc.border_side) == (NOTHING, 0)
    assert disc.border_time == pytest.approx(0.5, abs=1e-7)


def test_end_of_sliding_and_end_of_the_face_are_foretold() -> None:
    """A disc slides for v / (3 mu g) = 1/3 s; it rolls to the end of its floor."""
    floor, slider = Body(Segment((-4, 0), (4, 0))), Material(0.0, 0.2)
    tables = tables_for(
        floor, ball(position=(0, 0.5), velocity=(2, 0), material=slider), gravity=(0, -10)
    )
    next_event(tables)  # it is laid down
    disc = tables.discs[0]
    assert (disc.event_kind, disc.event_time) == (GRIP, pytest.approx(1 / 3))
    next_event(tables)
    rolled = (4 - (2 / 3 - 2 / 18)) / (4 / 3)
    assert (disc.event_kind, disc.event_time) == (END, pytest.approx(1 / 3 + rolled))


def test_disc_that_is_held_waits_for_other_discs_only() -> None:
    """No border, no face: it does not move."""
    tables = tables_for(ball())
    disc = tables.discs[0]
    disc.held, disc.vx = True, 1.0
    predict(tables, 0)
    assert disc.event_kind == NOTHING


# Rules


@pytest.mark.parametrize("order", list(permutations(range(4))))
def test_earliest_event_is_kept_in_whatever_order_they_are_found(order: tuple[int, ...]) -> None:
    """Of two at the same time an obstacle comes before a disc, and the lower number first."""
    disc = DiscRow()
    found = [(2.0, GRIP, 0), (1.0, DISC, 0), (1.0, OBSTACLE, 4), (1.0, OBSTACLE, 3)]
    for n in order:
        note(disc, *found[n], 0)
    note(disc, math.inf, GRIP, 0, 0)
    assert (disc.event_time, disc.event_kind, disc.partner) == (1.0, OBSTACLE, 3)


@pytest.mark.parametrize(
    ("speed", "expected"),
    [(-1.0, 0.0), (-1e-12, 0.0), (-1e-17, math.inf), (0.0, math.inf), (1.0, math.inf)],
)
def test_touching_discs_that_approach_slower_than_rounding_do_not_meet(
    speed: float, expected: float
) -> None:
    """Others that touch and approach meet now."""
    tables = tables_for(ball(velocity=(1, 0)))
    assert impact_after(tables.state, (1.0, 0.0, speed, 0.0), (0.0, 0.0), 1.0) == expected


def test_touching_discs_that_are_pressed_together_meet_now() -> None:
    """They do not approach yet, but they will."""
    tables = tables_for(ball(velocity=(1, 0)))
    assert impact_after(tables.state, (1.0, 0.0, 0.0, 0.0), (-10.0, 0.0), 1.0) == 0.0


def test_event_is_stale_when_the_partner_has_gone_another_way() -> None:
    """A third disc knocks the partner off: the predicted hit never happens, nothing is counted."""
    elastic = Material(1.0)
    solver = ExactSolver(
        Scene(
            [
                ball(velocity=(1, 0), material=elastic),
                ball(position=(5, 0), material=elastic),
                ball(position=(5, 3), velocity=(0, -4), material=elastic),
            ]
        ),
        combine=mixing_rule("workbook"),
    )
    first = solver.tables.discs[0]
    assert (first.event_kind, first.partner, first.event_time) == (DISC, 1, 4.0)
    solver.advance(1.0)
    assert solver.collisions == 1
    assert solver.tables.discs[1].changes != first.partner_changes
    solver.advance(10.0)
    assert solver.collisions == 1
    assert solver.states(10.0)[0, :2].tolist() == [10.0, 0.0]
