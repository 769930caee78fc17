"""The record of impulses: which contacts are written down, and what a row says."""

from __future__ import annotations

import numpy as np
import pytest

from lesson_code import Body, Circle, Material, MixingRule, Polygon, Scene, Segment, simulate
from lesson_code.engine.core.rows import ContactRow, ImpulseRow, World
from lesson_code.engine.core.tables import world_of
from lesson_code.engine.effects import impulse_record
from lesson_code.engine.effects.impulse_record import (
    STEPS_KEPT,
    has_capacity_for_record,
    record_impulses,
)
from lesson_code.engine.stepper import EngineStepper


def touching(room: int, impulses: list[float]) -> World:
    """Return two discs with a contact for each impulse, and so much room in the record."""
    discs = [Body(Circle(1), mass=1), Body(Circle(1), mass=1, position=(1.5, 0))]
    world = world_of(Scene(discs), 0.01, 1, MixingRule())
    for n, impulse in enumerate(impulses):
        world.contacts.append(
            ContactRow(
                a=0, b=1, nx=1.0, ax=1.0, bx=-1.0, penetration=0.5, feature=n,
                normal_impulse=impulse, tangent_impulse=-0.25 * n,
            )
        )  # fmt: skip
    world.state.contact_count = len(impulses)
    world.state.time = 0.75
    world.impulses.extend(ImpulseRow() for _ in range(room))
    return world


def test_row_of_the_record_says_when_where_and_how_strong() -> None:
    """The point is midway between the surfaces, which overlap from 0.5 to 1."""
    world = touching(1, [3.0])
    record_impulses(world)
    assert world.impulses == [ImpulseRow(0.75, 0, 1, 0.75, 0.0, 1.0, 0.0, 3.0, 0.0, 0.5)]


def test_contacts_without_an_impulse_are_left_out() -> None:
    """The others stand one after the other, in the order of the contacts."""
    world = touching(5, [0.0, 3.0, 0.0, 4.0])
    record_impulses(world)
    assert world.state.impulse_count == 2
    kept = [(row.normal_impulse, row.tangent_impulse) for row in world.impulses[:2]]
    assert kept == [(3.0, -0.25), (4.0, -0.75)]
    record_impulses(world)
    assert world.state.impulse_count == 4
    assert [row.normal_impulse for row in world.impulses[:4]] == [3.0, 4.0, 3.0, 4.0]


@pytest.mark.parametrize(("room", "kept", "enough"), [(2, 0, True), (1, 0, False), (3, 2, False)])
def test_room_for_the_record_is_that_for_all_contacts(room: int, kept: int, enough: bool) -> None:
    """Before a step nobody knows which will have an impulse; what is wanted lasts for 32 steps."""
    world = touching(room, [1.0, 1.0])
    world.state.impulse_count = kept
    assert has_capacity_for_record(world) == enough
    assert world.state.impulses_wanted == (0 if enough else STEPS_KEPT * 2)


def lying(keep_impulses: bool) -> EngineStepper:
    """Return a ball that lies on the floor."""
    floor, ball = Body(Segment((-5, 0), (5, 0))), Body(Circle(0.5), mass=1, position=(0, 0.499))
    return EngineStepper(
        Scene([floor, ball], gravity=(0, -10)), solver="sequential", dt=1 / 60, iterations=10,
        substeps=1, combine=MixingRule(), keep_impulses=keep_impulses,
    )  # fmt: skip


def test_record_of_a_long_run_is_complete_and_in_order_of_time(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A table for 48 rows is emptied many times in 500 steps; no step is lost, none is twice."""
    monkeypatch.setattr(impulse_record, "ROWS_KEPT", 0)
    stepper = lying(keep_impulses=True)
    stepper.advance(500)
    times = stepper.events()[:, 0]
    assert times == pytest.approx([(k + 1) / 60 for k in range(500)])
    assert len(stepper.world.impulses) == 48
    assert len(stepper.events()) == 500  # to look at them takes nothing away


@pytest.mark.parametrize(("steps", "rows"), [(10, 48), (500, 750)])
def test_table_has_room_for_the_steps_that_are_ahead(steps: int, rows: int) -> None:
    """For 32 steps at least, and half as many rows again."""
    stepper = lying(keep_impulses=True)
    stepper.advance(steps)
    assert len(stepper.world.impulses) == rows


@pytest.mark.parametrize("seed", range(6))
def test_record_holds_all_that_has_changed_the_momentum(seed: int) -> None:
    """Boxes and pentagons that tumble onto a floor: m dv = m g T and the impulses written down."""
    rng = np.random.default_rng(seed)
    surface = Material(rng.uniform(0, 0.6), rng.uniform(0, 1))
    shapes = Polygon.box(1, 0.6), Polygon.regular(5, 0.5)
    bodies = [
        Body(
            shapes[(seed + n) % 2],
            mass=10 ** rng.uniform(-1, 1),
            material=surface,
            position=(rng.uniform(-0.3, 0.3), 1 + 1.2 * n),
            angle=rng.uniform(0, 6),
            velocity=(rng.uniform(-2, 2), 0),
            angular_velocity=rng.uniform(-2, 2),
        )
        for n in range(3)
    ]
    floor = Body(Segment((-20, 0), (20, 0)), material=surface)
    run = simulate(Scene([floor, *bodies], gravity=(0, -9.81)), 4.0)
    hits, masses = run.contacts, np.array([[body.mass] for body in bodies])
    tangent = np.stack((-hits.normal[:, 1], hits.normal[:, 0]), axis=1)
    given = hits.normal_impulse[:, None] * hits.normal + hits.tangent_impulse[:, None] * tangent
    received = np.zeros((4, 2))
    np.add.at(received, hits.body_b, given)
    np.add.at(received, hits.body_a, -given)
    weight = masses * 4.0 * np.array([0, -9.81])
    change = masses * (run.velocities[-1] - run.velocities[0])[1:]
    np.testing.assert_allclose(
        change, weight + received[1:], rtol=0, atol=1e-11 * abs(weight).max()
    )


def test_run_without_a_record_has_the_same_bits_and_no_impulses() -> None:
    """To write them down changes nothing."""
    with_record, without = lying(keep_impulses=True), lying(keep_impulses=False)
    for stepper in (with_record, without):
        stepper.advance(100)
    assert with_record.states().tobytes() == without.states().tobytes()
    assert without.events().shape == (0, 10)
    assert len(without.world.impulses) == 0
