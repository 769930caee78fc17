"""The live world: what a player does to it, and that it is the engine's own."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tiers import share

from lesson_code import Body, Circle, Material, Polygon, Scene, Segment, simulate
from lesson_code.engine.core.callbacks import Callbacks, Touch
from lesson_code.engine.core.penetration import deepest_overlaps
from lesson_code.engine.live_world import TIME_STEP, LiveWorld

ROUNDING = 1e-12
"""Of numbers around 1: an impulse and its effect are a handful of roundings apart."""

BOUNCY = Material(restitution=1.0, friction=0.3)


def crowd(count: int = 8) -> list[Body]:
    """Return a floor, balls and boxes that fall on one another."""
    floor = Body(Segment((-5, 0), (5, 0)), material=BOUNCY)
    shapes = [Circle(0.3) if k % 2 else Polygon.box(0.5, 0.4) for k in range(count)]
    return [floor] + [
        Body(
            shape,
            position=(0.31 * (k % 3), 0.5 + 0.7 * k),
            velocity=(0.2 * k - 0.5, 0.0),
            mass=1.0 + k,
            material=BOUNCY,
        )
        for k, shape in enumerate(shapes)
    ]


@pytest.mark.parametrize("solver", ["direct", "sequential"])
def test_step_of_a_live_world_is_the_engines_bit_for_bit(solver: str) -> None:
    """Sixty steps end where simulate() ends: the direct solver, or sweeps that are asked for."""
    sweeps = 10 if solver == "sequential" else None
    world = LiveWorld(crowd(), gravity=(0.0, -9.81), iterations=sweeps)
    for _ in range(60):
        world.step()
    run = simulate(Scene(crowd(), gravity=(0, -9.81)), 1.0, solver=solver, sample="end")
    states = world.states()
    assert (states[:, 0:2] == run.positions[-1]).all()
    assert (states[:, 5] == run.angular_velocities[-1]).all()


@pytest.mark.parametrize("sweeps", [None, 10])
def test_compiled_world_is_the_plain_one_bit_for_bit(sweeps: int | None) -> None:
    """Machine code may take over between two steps, and nothing changes: sub-steps, and sweeps."""
    plain, fast = (LiveWorld(crowd(30), gravity=(0.0, -9.81), iterations=sweeps) for _ in range(2))
    for world in (plain, fast):
        for _ in range(40):
            world.step()
    fast.compile()
    for world in (plain, fast):
        for _ in range(40):
            world.step()
    assert (plain.states() == fast.states()).all()
    plain.add(Body(Circle(0.2), position=(3, 3), mass=1.0))
    fast.add(Body(Circle(0.2), position=(3, 3), mass=1.0))
    for world in (plain, fast):
        world.push(3, (0.5, 0.0), (0.0, 0.1))
        for _ in range(60):
            world.step()
    assert (plain.compiled, fast.compiled) == (False, True)
    assert plain.solver == ("sequential" if sweeps else "substep")
    assert (plain.states() == fast.states()).all()
    assert (plain.impulses == fast.impulses).all()
    assert plain.touching() == fast.touching()


def test_world_that_grows_stays_in_machine_code() -> None:
    """One in sub-steps that is compiled, and gets eighty bodies more."""
    world = LiveWorld(crowd(30), gravity=(0.0, -9.81))
    assert not world.wants_code  # nobody has let time pass
    world.step()
    assert world.wants_code
    world.compile()
    assert (world.compiled, world.wants_code) == (True, False)
    for k in range(80):
        world.add(Body(Circle(0.2), position=(20 + k, 3), mass=1.0))
    assert (world.solver, world.compiled, world.wants_code) == ("substep", True, False)


@settings(max_examples=share(20, 4))
@given(seed=st.integers(0, 2**32 - 1), before=st.integers(1, 40), e=st.floats(0.3, 1.0))
def test_discs_that_fly_go_on_in_machine_code_with_the_same_bits(
    seed: int, before: int, e: float
) -> None:
    """From any step on, and also after one of them is pushed, which ends what was foreseen."""
    random = np.random.default_rng(seed)
    places, velocities = np.mgrid[0:12, 0:9].reshape(2, -1).T, random.normal(0, 2, (108, 2))
    discs = [
        Body(Circle(0.3), mass=1.0, position=tuple(p), velocity=tuple(v), material=Material(e))
        for p, v in zip(places.tolist(), velocities.tolist(), strict=True)
    ]
    plain, fast = LiveWorld(discs), LiveWorld(discs)
    for world in (plain, fast):
        for _ in range(before):
            world.step()
    assert (fast.solver, fast.wants_code) == ("exact", True)
    fast.compile()
    assert (fast.compiled, fast.wants_code) == (True, False)
    for world in (plain, fast):
        for _ in range(20):
            world.step()
        world.push(7, (0.01, 0.02))
        for _ in range(20):
            world.step()
    assert fast._in_flight().solver.plan("").code == "compiled"
    assert plain._in_flight().solver.plan("").code == "plain Python"
    assert (plain.states() == fast.states()).all()


def pit(seed: int, e: float, mu: float, speed: float) -> list[Body]:
    """Return a pit, and 17 to 59 discs and boxes above its floor, thrown at random."""
    random, material = np.random.default_rng(seed), Material(e, mu)
    bodies = [
        Body(Polygon.box(6, 1), position=(0, -0.5), material=material),
        *(Body(Polygon.box(1, 40), position=(x, 15), material=material) for x in (-2.5, 2.5)),
    ]
    for k in range(random.integers(17, 60)):
        size = random.uniform(0.1, 0.2)
        box = Polygon.box(2 * size, random.uniform(1, 2) * size)
        bodies.append(
            Body(
                Circle(size) if random.random() < 0.5 else box,
                mass=size * size,
                position=(-1.5 + 0.6 * (k % 6), 0.4 + 0.6 * (k // 6)),
                velocity=tuple(random.normal(0, speed, 2)),
                material=material,
            )
        )
    return bodies


@settings(max_examples=share(30, 10))
@given(
    seed=st.integers(0, 2**32 - 1),
    e=st.floats(0, 0.95),
    mu=st.floats(0, 1),
    speed=st.floats(0, 1.5).map(lambda power: 10**power),
)
def test_crowd_that_falls_is_never_far_inside_anybody(
    seed: int, e: float, mu: float, speed: float
) -> None:
    """For three seconds, thrown at 1 to 30 m/s: nobody is in another by a tenth of a radius.

    Of sixty draws the deepest overlap was 0.003 m: springs give way, and an impact that goes
    through many bodies leaves some speed. Where contacts were sought once a step it was 0.084 m.
    """
    world = LiveWorld(pit(seed, e, mu, speed), gravity=(0.0, -9.81))
    world.compile()
    states = []
    for _ in range(180):
        world.step()
        states.append(world.states())
    found = np.array(states)
    depths = deepest_overlaps(Scene(world.bodies()), found[..., :2], found[..., 2])
    assert world.solver == "substep"
    assert depths.max() < 0.01
    assert np.quantile(depths, 0.9) < 0.002


def test_push_changes_momentum_by_the_impulse_and_spin_by_its_moment() -> None:
    """M dv = J, I dw = r x J."""
    world = LiveWorld([Body(Circle(0.5), mass=2.0, velocity=(1, 0))])
    world.push(0, (3.0, -1.0), (0.0, 0.5))
    assert world.velocity(0) == pytest.approx((2.5, -0.5), rel=ROUNDING)
    assert world.spin(0) == pytest.approx(-0.5 * 3.0 / 0.25, rel=ROUNDING)


def test_push_of_a_wall_does_nothing() -> None:
    """Nothing can push what has no mass."""
    world = LiveWorld([Body(Segment((0, 0), (1, 0)))])
    world.push(0, (3.0, 3.0), (1.0, 0.0))
    assert (world.velocity(0), world.spin(0)) == ((0.0, 0.0), 0.0)


def test_add_and_remove_leave_the_others_as_they_are() -> None:
    """Numbers stay, and so does every bit of a state."""
    world = LiveWorld(crowd())
    for _ in range(20):
        world.step()
    before = world.states()[1:]
    new = world.add(Body(Circle(0.1), position=(9, 9), mass=1.0))
    assert new == 9
    world.remove(0)
    assert world.numbers == (*range(1, 9), 9)
    assert (world.states()[:-1] == before).all()
    assert world.position(new) == (9.0, 9.0)


def test_body_that_was_removed_is_gone() -> None:
    """It is not in the world, and nobody can ask for it."""
    world = LiveWorld(crowd())
    world.remove(3)
    assert 3 not in world
    assert len(world) == 8
    with pytest.raises(KeyError):
        world.position(3)


def test_empty_world_steps_and_has_no_momentum() -> None:
    """Where nothing is, nothing happens."""
    world = LiveWorld(crowd())
    world.clear()
    world.step()
    assert (len(world), world.momentum(), world.kinetic_energy()) == (0, (0.0, 0.0), 0.0)
    assert world.angular_momentum() == 0.0


def test_mechanics_are_those_of_the_bodies() -> None:
    """Two bodies by hand: p, L about the origin, T with spin; a wall counts nowhere."""
    world = LiveWorld(
        [
            Body(Circle(1.0), mass=2.0, position=(0, 3), velocity=(1, 0), angular_velocity=2.0),
            Body(Circle(1.0), mass=1.0, position=(5, 0), velocity=(0, 4)),
            Body(Segment((0, 0), (1, 0)), velocity=(9, 9)),
        ]
    )
    assert world.momentum() == pytest.approx((2.0, 4.0), rel=ROUNDING)
    assert world.angular_momentum() == pytest.approx(-6.0 + 1.0 * 2.0 + 20.0, rel=ROUNDING)
    assert world.kinetic_energy() == pytest.approx(1.0 + 8.0 + 0.5 * 1.0 * 4.0, rel=ROUNDING)


def test_callbacks_hear_begin_touch_and_part_once_each() -> None:
    """A ball that bounces once: one begin with the impulse, one separate."""
    told: list[tuple[str, Touch]] = []
    callbacks = Callbacks(
        begin=lambda touch: told.append(("begin", touch)),
        post_solve=lambda touch: told.append(("touch", touch)),
        separate=lambda touch: told.append(("part", touch)),
    )
    ball = Body(Circle(0.5), position=(0, 0.52), velocity=(0, -2), mass=3.0, material=BOUNCY)
    floor = Body(Segment((-1, 0), (1, 0)), material=BOUNCY)
    world = LiveWorld([floor, ball], callbacks=callbacks)
    for _ in range(10):
        world.step()
    assert [name for name, _ in told] == ["begin", "touch", "part"]
    touch = told[0][1]
    assert (touch.body_a, touch.body_b, touch.normal) == (0, 1, (0.0, 1.0))
    assert touch.normal_impulse == pytest.approx(3.0 * 4.0, rel=ROUNDING)
    assert (touch.restitution, touch.friction) == pytest.approx((1.0, 0.3))


def test_ball_of_any_speed_stays_between_two_walls() -> None:
    """A step of 1/60 s is 1,000 m at 60 km/s: the wall is met all the same."""
    walls = [Body(Segment((x, -1), (x, 1)), material=BOUNCY) for x in (-1.0, 1.0)]
    ball = Body(Circle(0.1), velocity=(60_000, 0), mass=1.0, material=BOUNCY)
    world = LiveWorld([*walls, ball])
    for _ in range(3):
        world.step()
        assert abs(world.position(2)[0]) <= 0.9 + 0.01


def test_lost_body_is_named() -> None:
    """A body that leaves the range of floating point is an error with its number."""
    world = LiveWorld([Body(Circle(1.0), mass=1.0), Body(Circle(1.0), position=(9, 0), mass=1.0)])
    world.throw(1, (1.7e308, 1.7e308))
    world.move(1, (1.797e308, 0.0))
    with pytest.raises(FloatingPointError, match="body 1"):
        world.step()


def test_coat_and_pull_change_what_is_to_come() -> None:
    """Another restitution and another gravity act from the next step on."""
    world = LiveWorld(crowd())
    world.coat(restitution=0.25)
    assert {body.material for _, body in world.items()} == {Material(0.25, 0.3)}
    world.pull((0.0, -6.0))
    world.throw(8, (0.0, 0.0))
    world.move(8, (50.0, 50.0))
    world.step()
    assert world.velocity(8) == pytest.approx((0.0, -6.0 * TIME_STEP), rel=ROUNDING)


def test_impulses_of_many_impacts_in_one_step_are_all_told() -> None:
    """A ball that goes to and fro in one step is pushed as often as it turns."""
    walls = [Body(Segment((x, -1), (x, 1)), material=BOUNCY) for x in (-1.0, 1.0)]
    ball = Body(Circle(0.1), velocity=(1800.0, 0), mass=1.0, material=BOUNCY)
    world = LiveWorld([*walls, ball])
    world.step()
    # 30 m in the step, the first wall after 0.9 m, the others 1.8 m apart
    assert len(world.impulses) == 1 + int((30 - 0.9) / 1.8)
    assert world.impulses[:, 7] == pytest.approx(2 * 1800.0, rel=ROUNDING)


# Laws


def gas(count: int, restitution: float = 1.0, speed: float = 3.0) -> list[Body]:
    """Return discs of three sizes in a room of 8 x 6, none of which overlap."""
    surface = Material(restitution, 0.0)
    columns = math.ceil(math.sqrt(count * 8 / 6))
    step = 8 / columns
    discs = [
        Body(
            Circle(step * (0.2 + 0.1 * (k % 3))),
            position=(step * (k % columns + 0.5), step * (k // columns + 0.5)),
            velocity=(speed * math.cos(2.4 * k), speed * math.sin(2.4 * k)),
            mass=1.0 + k % 5,
            material=surface,
        )
        for k in range(count)
    ]
    return [*box(surface), *discs]


def box(surface: Material) -> list[Body]:
    """Return four walls round 8 x 6."""
    corners = [(-1, -1), (9, -1), (9, 7), (-1, 7)]
    sides = zip(corners, corners[1:] + corners[:1], strict=True)
    return [Body(Segment(a, b, 1.0), material=surface) for a, b in sides]


def energy(world: LiveWorld) -> float:
    """Return kinetic and potential energy, J."""
    falls = sum((b.mass or 0.0) * world.position(n)[1] for n, b in world.items() if b.mass)
    return world.kinetic_energy() - world.gravity[1] * falls


def deepest(world: LiveWorld) -> float:
    """Return the deepest overlap of two discs, or of a disc and a wall of the room, in radii."""
    discs = [(world.position(n), b.shape.bounding_radius) for n, b in world.items() if b.mass]
    p, r = np.array([place for place, _ in discs]), np.array([radius for _, radius in discs])
    gaps = np.hypot(*(p[:, None] - p[None]).T) - r[:, None] - r[None]
    np.fill_diagonal(gaps, np.inf)
    walls = np.minimum(p - r[:, None], (8.0, 6.0) - p - r[:, None]).min(axis=1)
    return float(-np.minimum(gaps.min(axis=1), walls).min() / r.min())


@pytest.mark.parametrize("gravity", [0.0, -9.81])
@pytest.mark.parametrize("count", [1, 12, 40, 150])
def test_elastic_discs_keep_energy_and_stay_apart(count: int, gravity: float) -> None:
    """To 1e-12 of the energy in 300 steps, whichever solver moves them; no overlap but rounding."""
    world = LiveWorld(gas(count), gravity=(0.0, gravity))
    before, worst = energy(world), -1.0
    for _ in range(300):
        world.step()
        worst = max(worst, deepest(world))
    assert energy(world) == pytest.approx(before, rel=1e-12)
    assert worst < 1e-9


@pytest.mark.parametrize("restitution", [0.0, 0.6])
def test_pile_of_a_few_discs_loses_energy_only_and_nobody_sinks_in(restitution: float) -> None:
    """Twelve discs fall into a heap: 1 % of a radius is the bound, and energy never grows."""
    world = LiveWorld(gas(12, restitution), gravity=(0.0, -9.81))
    last = energy(world)
    for _ in range(300):
        world.step()
        assert energy(world) <= last * (1 + 1e-12)
        assert deepest(world) < 0.01
        last = energy(world)


def test_world_whose_discs_touch_takes_off_once_they_have_parted() -> None:
    """Discs that overlap are stepped until they are apart, and then fly."""
    bodies = gas(30)
    for y, speed in ((5.0, -1.0), (5.1, 1.0)):
        bodies.append(
            Body(
                Circle(0.1),
                position=(7.85, y),
                velocity=(0.0, speed),
                mass=1.0,
                material=Material(1.0, 0.0),
            )
        )
    world = LiveWorld(bodies)
    assert world.plan().solver == "direct"
    for _ in range(120):
        world.step()
    assert world.plan().solver == "exact"


def test_held_body_stands_still_and_takes_nothing_from_those_that_hit_it() -> None:
    """It is a wall to them; released, it has its mass again."""
    world = LiveWorld(gas(12))
    held = world.numbers[6]
    world.hold(held)
    place, before = world.position(held), world.kinetic_energy()
    for _ in range(300):
        world.step()
    assert world.position(held) == place
    assert world.kinetic_energy() == pytest.approx(before, rel=1e-12)
    world.release(held, (2.0, 0.0))
    mass = world.body(held).mass
    assert mass == 1.0 + 2 % 5
    assert world.kinetic_energy() == pytest.approx(before + mass * 2.0, rel=1e-12)


def test_flight_tells_of_impulses_at_their_times() -> None:
    """Two discs of 17 meet after half a second: mass times 2 m/s, at t = 0.5 s."""
    far = [
        Body(Circle(0.1), position=(0, 10 + k), mass=1.0, material=Material(1.0)) for k in range(15)
    ]
    pair = [
        Body(Circle(0.5), position=(x, 0), velocity=(v, 0), mass=1.0, material=Material(1.0))
        for x, v in ((0.0, 2.0), (2.0, 0.0))
    ]
    world = LiveWorld([*pair, *far])
    rows = []
    for _ in range(60):
        world.step()
        rows += world.impulses.tolist()
    assert world.plan().solver == "exact"
    assert len(rows) == 1
    assert rows[0][:3] == pytest.approx([0.5, 0, 1], abs=1e-12)
    assert rows[0][7] == pytest.approx(2.0, rel=1e-12)


def test_what_is_told_of_a_world_follows_every_change() -> None:
    """Momentum is asked for before and after each change: none is told twice."""
    world = LiveWorld([Body(Circle(0.5), mass=2.0), Body(Circle(0.5), position=(5, 0), mass=1.0)])
    told = []
    for change in (
        lambda: world.throw(0, (1.0, 0.0)),
        lambda: world.push(1, (3.0, 0.0)),
        lambda: world.weigh(0, 4.0),
        lambda: world.pull((0.0, -6.0)),
        world.step,
        lambda: world.remove(1),
        lambda: world.hold(0),
        lambda: world.release(0, (0.0, 1.0)),
    ):
        change()
        told.append(world.momentum())
    assert told[:4] == [(2.0, 0.0), (5.0, 0.0), (7.0, 0.0), (7.0, 0.0)]
    assert told[4:6] == [pytest.approx((7.0, -0.5)), pytest.approx((4.0, -0.4))]
    assert told[6:] == [(0.0, 0.0), (0.0, 4.0)]
