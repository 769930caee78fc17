"""The sweeps of sequential impulses: what one visit does, and that each contact is visited once."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Any

import pytest
from contacts import apply_impulse, mass_along, velocity_along
from hypothesis import given
from hypothesis import strategies as st

from lesson_code import Body, Circle, MixingRule, Scene
from lesson_code.engine.compiled.lanes import LANES
from lesson_code.engine.core.constants import (
    FEWEST_FOR_ORDER,
    MOST_COLOURS,
    PART_OF_SWEEP,
    SLOP,
    STRIDE,
)
from lesson_code.engine.core.contact_frame import (
    apply_impulses,
    apply_pseudo_impulse,
    missing_pseudo_velocity,
    missing_velocity,
    pseudo_velocity,
    set_frame,
    velocity_at,
)
from lesson_code.engine.core.contact_motion import (
    normal_of,
    tangent_of,
)
from lesson_code.engine.core.penetration import deepest_overlaps
from lesson_code.engine.core.rows import BodyRow, ContactRow, IndexRow, World
from lesson_code.engine.core.tables import world_of
from lesson_code.engine.effects.flags import EVERY_EFFECT
from lesson_code.engine.solvers import sequential as contact_solver
from lesson_code.engine.solvers.sequential import solve_contact
from lesson_code.engine.solvers.visits import order_visits
from lesson_code.engine.stepper import EngineStepper
from lesson_code.evidence.scenes.speed import settled_discs
from lesson_code.evidence.speed.quality import Gauge
from lesson_code.formulas.contact import friction_impulse, normal_impulse

ROUNDING = 1e-10
"""m/s, rad/s and N s: of arms, speeds and impulses up to 10 and of 1/kg up to 1e2 x 10, some
dozen operations, each right to 1e-16 of numbers below 1e4."""

components = st.floats(-10, 10)
inverses = st.one_of(st.just(0.0), st.floats(0.1, 10))
bodies = st.builds(
    BodyRow, vx=components, vy=components, w=components, inv_m=st.floats(0.1, 10), inv_i=inverses,
    corner_count=st.just(4),
)  # fmt: skip
contacts = st.builds(
    ContactRow, nx=st.just(0.6), ny=st.just(-0.8), ax=components, ay=components,
    bx=components, by=components, target_vn=st.floats(0, 10), friction=st.floats(0, 2),
    normal_impulse=st.floats(0, 10), tangent_impulse=components,
)  # fmt: skip


def ready(c: ContactRow, a: BodyRow, b: BodyRow) -> ContactRow:
    """Return a contact with its arms and effective masses."""
    set_frame(c, a, b)
    return c


def numbers(row: Any, *names: str) -> list[float]:
    """Return some fields of a row."""
    return [getattr(row, name) for name in names]


# One visit


@given(bodies, bodies, contacts)
def test_skew_is_the_coupling_of_normal_and_tangent(a: BodyRow, b: BodyRow, c: ContactRow) -> None:
    """The sum of (r x n)(r x t) / I, and what 1 N s along n does to the velocity along t."""
    rn = [x * c.ny - y * c.nx for x, y in ((c.ax, c.ay), (c.bx, c.by))]
    rt = [x * c.nx + y * c.ny for x, y in ((c.ax, c.ay), (c.bx, c.by))]
    k_nt = rn[0] * rt[0] * a.inv_i + rn[1] * rt[1] * b.inv_i
    assert ready(c, a, b).skew == pytest.approx(k_nt, abs=ROUNDING)
    before = velocity_along(c, a, b, tangent_of(c))
    apply_impulse(c, a, b, normal_of(c), 1.0)
    after = velocity_along(c, a, b, tangent_of(c))
    assert after - before == pytest.approx(k_nt, abs=ROUNDING)


@given(bodies, bodies, contacts)
def test_velocities_read_at_once_are_those_read_singly(
    a: BodyRow, b: BodyRow, c: ContactRow
) -> None:
    """Along normal and tangent, by lever arms that are set once."""
    singly = velocity_along(c, a, b, normal_of(c)), velocity_along(c, a, b, tangent_of(c))
    assert velocity_at(ready(c, a, b), a, b) == pytest.approx(singly, abs=ROUNDING)


@given(bodies, bodies, contacts)
def test_effective_masses_of_a_frame_are_those_along_normal_and_tangent(
    a: BodyRow, b: BodyRow, c: ContactRow
) -> None:
    """Seen from the contact or from the axes."""
    ready(c, a, b)
    assert c.normal_mass == pytest.approx(mass_along(c, a, b, normal_of(c)), rel=ROUNDING)
    assert c.tangent_mass == pytest.approx(mass_along(c, a, b, tangent_of(c)), rel=ROUNDING)


@given(bodies, bodies, contacts, components)
def test_push_does_to_push_velocities_what_an_impulse_does_to_velocities(
    a: BodyRow, b: BodyRow, c: ContactRow, j: float
) -> None:
    """And leaves the velocities alone: no overlap turns into speed."""
    ready(c, a, b)
    before = [numbers(row, "vx", "vy", "w") for row in (a, b)]
    apply_pseudo_impulse(c, a, b, j)
    assert pseudo_velocity(c, a, b) == pytest.approx(j / c.normal_mass, rel=ROUNDING, abs=ROUNDING)
    assert [numbers(row, "vx", "vy", "w") for row in (a, b)] == before


@given(bodies, bodies, contacts)
def test_what_is_missing_is_counted_from_the_target(a: BodyRow, b: BodyRow, c: ContactRow) -> None:
    """Negative: they do not part fast enough yet. The velocities of motion do not count as push."""
    c.pseudo_speed = 2.5
    a.pseudo_vx, b.pseudo_w = 1.5, -0.5
    vn = velocity_along(ready(c, a, b), a, b, normal_of(c))
    assert missing_velocity(c, a, b) == pytest.approx(vn - c.target_vn, abs=ROUNDING)
    pushed = -1.5 * c.nx - 0.5 * (c.bx * c.ny - c.by * c.nx)
    assert missing_pseudo_velocity(c, a, b) == pytest.approx(pushed - 2.5, abs=ROUNDING)


@given(bodies, bodies, contacts, components, components)
def test_impulses_applied_at_once_are_those_applied_singly(
    a: BodyRow, b: BodyRow, c: ContactRow, jn: float, jt: float
) -> None:
    """Velocities are linear in the impulses."""
    names = ("vx", "vy", "w")
    at_once = [BodyRow(*numbers(row, *names, "inv_m", "inv_i")) for row in (a, b)]
    apply_impulses(ready(c, a, b), *at_once, jn, jt)
    apply_impulse(c, a, b, normal_of(c), jn)
    apply_impulse(c, a, b, tangent_of(c), jt)
    for one, other in zip(at_once, (a, b), strict=True):
        assert numbers(one, *names) == pytest.approx(numbers(other, *names), abs=ROUNDING)


@given(bodies, bodies, contacts)
def test_visit_is_the_normal_impulse_and_then_friction(
    a: BodyRow, b: BodyRow, c: ContactRow
) -> None:
    """Though it reads the velocities once: the skew says how the first changes the second."""
    ready(c, a, b)
    names = ("vx", "vy", "w")
    once = [BodyRow(*numbers(row, *names, "inv_m", "inv_i")) for row in (a, b)]
    jn_before, jt_before = c.normal_impulse, c.tangent_impulse
    n, t = normal_of(c), tangent_of(c)
    missing = velocity_along(c, a, b, n) - c.target_vn
    jn = float(normal_impulse(missing, c.normal_mass, 0.0, jn_before))
    apply_impulse(c, a, b, n, jn - jn_before)
    vt = velocity_along(c, a, b, t)
    jt = float(friction_impulse(vt, c.tangent_mass, c.friction, jn, jt_before))
    apply_impulse(c, a, b, t, jt - jt_before)

    solve_contact(c, *once)
    assert (c.normal_impulse, c.tangent_impulse) == pytest.approx((jn, jt), abs=ROUNDING)
    for measured, expected in zip(once, (a, b), strict=True):
        assert numbers(measured, *names) == pytest.approx(numbers(expected, *names), abs=ROUNDING)


# All visits

COUNTS = [
    *(0, 1, 2, STRIDE, FEWEST_FOR_ORDER - 1),
    *range(FEWEST_FOR_ORDER, FEWEST_FOR_ORDER + 2 * STRIDE + 1),
    *(10 * FEWEST_FOR_ORDER - 1, PART_OF_SWEEP, PART_OF_SWEEP + FEWEST_FOR_ORDER + 3),
]


def with_contacts(count: int, blocks: Sequence[int] = ()) -> World:
    """Return tables with so many contacts, some of which are blocks with the next one."""
    world = world_of(Scene([Body(Circle(1), mass=1)] * 2), 0.01, 1, MixingRule())
    world.contacts.extend(ContactRow(a=0, b=1, feature=k) for k in range(count))
    world.visits.extend(IndexRow() for _ in range(count))
    for k in blocks:
        world.contacts[k].is_block = True
    world.state.contact_count = count
    order_visits(world, EVERY_EFFECT)
    return world


VISITS = ("solve_contact", "solve_manifold", "solve_pseudo_velocity", "solve_pseudo_velocities")


def visits(monkeypatch: pytest.MonkeyPatch, world: World, sweep: str) -> dict[str, list[int]]:
    """Return the contacts that each kind of visit is made to in a sweep, in its order."""
    visited: dict[str, list[int]] = {name: [] for name in VISITS}
    with monkeypatch.context() as patch:
        for name in VISITS:
            note = visited[name].append
            patch.setattr(contact_solver, name, lambda c, *_, note=note: note(c.feature))
        getattr(contact_solver, sweep)(world)
    return visited


def order_of(world: World) -> list[int]:
    """Return the contacts in the order in which a sweep visits them."""
    return [row.index for row in world.visits[: world.state.visit_count]]


def firsts_of(world: World) -> list[int]:
    """Return all contacts but the second points of manifolds."""
    rows = world.contacts[: world.state.contact_count]
    return [k for k in range(len(rows)) if k == 0 or not rows[k - 1].is_block]


@pytest.mark.parametrize(
    ("sweep", "visit"), [("solve", "solve_contact"), ("correct", "solve_pseudo_velocity")]
)
@pytest.mark.parametrize("count", COUNTS)
def test_sweep_visits_every_contact_once(
    monkeypatch: pytest.MonkeyPatch, count: int, sweep: str, visit: str
) -> None:
    """Few in their order; many with a stride that need not divide their number, part by part."""
    visited = visits(monkeypatch, with_contacts(count), sweep)[visit]
    assert sorted(visited) == list(range(count))
    if count < FEWEST_FOR_ORDER:
        assert visited == sorted(visited)


def test_contacts_of_discs_are_visited_in_strides() -> None:
    """Of 68 contacts: 0, 6, ... 66, then 1, 7, ... 67, then 2, 8, ... 62."""
    order = order_of(with_contacts(68))
    assert order[:12] == list(range(0, 68, 6))
    assert order[12:24] == list(range(1, 68, 6))
    assert order[24:35] == list(range(2, 68, 6))


def test_strides_end_one_part_before_the_next() -> None:
    """Of 2,058 contacts: 1,024 in strides, as many again, and the last ten."""
    order = order_of(with_contacts(2_058))
    assert sorted(order[:1_024]) == list(range(1_024))
    assert order[1_024:1_027] == [1_024, 1_030, 1_036]
    assert sorted(order[2_048:]) == list(range(2_048, 2_058))


@pytest.mark.parametrize("apart", [2, 3, 5])
@pytest.mark.parametrize("count", [10, FEWEST_FOR_ORDER, FEWEST_FOR_ORDER + 5])
def test_sweep_solves_the_two_points_of_a_block_together(
    monkeypatch: pytest.MonkeyPatch, count: int, apart: int
) -> None:
    """In whatever order, by colour where most contacts are blocks; no point is visited alone."""
    firsts = list(range(1, count - 1, apart))
    seconds = [k + 1 for k in firsts]
    alone = sorted(set(range(count)) - {*firsts, *seconds})
    world = with_contacts(count, firsts)
    solved = visits(monkeypatch, world, "solve")
    assert sorted(solved["solve_manifold"]) == firsts
    assert sorted(solved["solve_contact"]) == alone
    pushed = visits(monkeypatch, world, "correct")
    assert sorted(pushed["solve_pseudo_velocities"]) == firsts
    assert sorted(pushed["solve_pseudo_velocity"]) == alone


# Colours

BODIES = 40
pairs = st.lists(
    st.tuples(st.integers(0, BODIES - 1), st.integers(0, BODIES - 1)).filter(lambda p: p[0] < p[1]),
    min_size=FEWEST_FOR_ORDER, max_size=200, unique=True,
).map(sorted)  # fmt: skip


def touching(pairs: list[tuple[int, int]], fixed: set[int]) -> World:
    """Return tables in which these pairs touch, two of three in two points; some are static."""
    bodies = [Body(Circle(1), mass=None if i in fixed else 1) for i in range(BODIES)]
    world = world_of(Scene(bodies), 0.01, 1, MixingRule())
    for n, (a, b) in enumerate(pairs):
        if n % 3 < 2:
            world.contacts.append(ContactRow(a=a, b=b, is_block=True))
        world.contacts.append(ContactRow(a=a, b=b))
    world.visits.extend(IndexRow() for _ in world.contacts)
    world.state.contact_count = len(world.contacts)
    order_visits(world, EVERY_EFFECT)
    return world


@given(pairs, st.sets(st.integers(0, BODIES - 1), max_size=BODIES))
def test_contacts_of_one_colour_share_no_body_that_can_be_pushed(
    pairs: list[tuple[int, int]], fixed: set[int]
) -> None:
    """But for the last colour, which takes whatever found no other."""
    world = touching(pairs, fixed)
    order = order_of(world)
    assert sorted(order) == firsts_of(world)
    visited = [world.contacts[k] for k in order]
    pushed = [(c.colour % MOST_COLOURS, i) for c in visited for i in (c.a, c.b) if i not in fixed]
    early = [place for place in pushed if place[0] < MOST_COLOURS - 1]
    assert len(set(early)) == len(early)


@given(pairs, st.sets(st.integers(0, BODIES - 1), max_size=BODIES))
def test_contacts_in_lanes_share_no_body_and_are_of_one_kind(
    pairs: list[tuple[int, int]], fixed: set[int]
) -> None:
    """Four by four: manifolds, colour after colour, then single contacts; never the last colour."""
    world = touching(pairs, fixed)
    state, order = world.state, order_of(world)
    assert state.lanes_of_two % LANES == state.lanes_of_one % LANES == 0
    assert 0 <= state.lanes_of_two <= state.lanes_of_one <= len(order)
    visited = [world.contacts[k] for k in order[: state.lanes_of_one]]
    assert [c.is_block for c in visited] == [n < state.lanes_of_two for n in range(len(visited))]
    assert [c.colour for c in visited] == sorted(c.colour for c in visited)
    for begin in range(0, len(visited), LANES):
        together = [i for c in visited[begin : begin + LANES] for i in (c.a, c.b) if i not in fixed]
        assert len(set(together)) == len(together)


@given(pairs)
def test_no_more_visits_are_left_over_than_do_not_fill_the_lanes(
    pairs: list[tuple[int, int]],
) -> None:
    """Of each colour and kind but the last colour, fewer than there are lanes."""
    world = touching(pairs, fixed=set())
    left = Counter(world.contacts[k].colour for k in order_of(world)[world.state.lanes_of_one :])
    assert all(n < LANES for colour, n in left.items() if (colour + 1) % MOST_COLOURS)


def test_more_contacts_than_colours_on_one_body_are_all_visited() -> None:
    """A body with 39 neighbours: those that find no other colour share the last."""
    world = touching([(0, i) for i in range(1, BODIES)], fixed=set())
    colours = [world.contacts[k].colour % MOST_COLOURS for k in order_of(world)]
    assert colours == [*range(MOST_COLOURS), *[MOST_COLOURS - 1] * (39 - MOST_COLOURS)]


@given(pairs)
def test_contact_takes_no_colour_that_is_higher_than_it_must_be(
    pairs: list[tuple[int, int]],
) -> None:
    """Each lower one is taken by another contact of one of its two bodies."""
    world = touching(pairs, fixed=set())
    rows = [world.contacts[k] for k in firsts_of(world)]
    for c in rows:
        near = {d.colour % MOST_COLOURS for d in rows if {c.a, c.b} & {d.a, d.b} and d is not c}
        assert set(range(c.colour % MOST_COLOURS)) <= near


@pytest.mark.full
@pytest.mark.parametrize("discs", [500, 1_000])
def test_heap_of_discs_comes_to_rest_with_half_the_usual_sweeps(discs: int) -> None:
    """A sweep that worked in four far places of the table in turn left 17 and 38 J after 10 s.

    0.1 J is what one disc of a thousand has at 0.4 m/s.
    """
    pytest.importorskip("numba")
    scene = settled_discs(discs).scene
    engine = EngineStepper(
        scene,
        dt=1 / 60,
        solver="sequential",
        iterations=5,
        substeps=1,
        combine=MixingRule(),
        keep_impulses=False,
        compiled=True,
    )
    engine.advance(600)
    states = engine.states()
    assert Gauge(scene).energy(states) < 0.1
    assert deepest_overlaps(scene, states[None, :, :2], states[None, :, 2])[0] <= 1.5 * SLOP
