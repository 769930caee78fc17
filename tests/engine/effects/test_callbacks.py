"""What a scene's callbacks are told, when, and what they can change."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code import Body, Callbacks, Circle, Material, Polygon, Run, Scene, Segment, simulate
from lesson_code.engine.core.callbacks import Touch

ROUNDING = 1e-13
"""Of impulses of some N s: a few dozen operations, each right to 1e-16."""

DT = 0.1
KINDS = ("begin", "pre_solve", "post_solve", "separate")


def told(log: list[tuple[str, Touch]], *kinds: str) -> Callbacks:
    """Return callbacks that write down which of them was called, with a copy of the touch."""

    def note(kind: str) -> Callable[[Touch], None]:
        fields = Touch.__slots__
        return lambda touch: log.append(
            (kind, Touch(**{name: getattr(touch, name) for name in fields}))
        )

    return Callbacks(**{kind: note(kind) for kind in kinds or KINDS})


def meeting(callbacks: Callbacks | None = None, e: float | None = 1.0) -> Scene:
    """Return two discs of 1 m and 2 kg that overlap by 0.1 m after 0.6 s, and meet at 2 m/s."""
    material = Material(restitution=e)
    bodies = [
        Body(Circle(0.5), mass=2, position=(x, 0), velocity=(v, 0), material=material)
        for x, v in ((-1.05, 1), (1.05, -1))
    ]
    return Scene(bodies, callbacks=callbacks)


def resting(callbacks: Callbacks | None = None, speed: float = 0.0, friction: float = 0.5) -> Scene:
    """Return a box of 2 kg that lies on a floor, or slides on it."""
    material = Material(restitution=0, friction=friction)
    return Scene(
        [
            Body(Segment((-50, 0), (50, 0)), material=material),
            Body(
                Polygon.box(1, 1), mass=2, position=(0, 0.499), velocity=(speed, 0),
                material=material,
            ),
        ],
        gravity=(0, -10),
        callbacks=callbacks,
    )  # fmt: skip


# When


@pytest.mark.parametrize(
    ("duration", "kinds"),
    [
        (0.5, ()),
        (0.6, ("begin", "pre_solve", "post_solve")),
        (0.7, ("begin", "pre_solve", "post_solve", "separate")),
        (2.0, ("begin", "pre_solve", "post_solve", "separate")),
    ],
)
def test_calls_of_one_bounce_come_once_each_and_in_order(
    duration: float, kinds: tuple[str, ...]
) -> None:
    """The discs overlap in the sixth step, and in the seventh no longer."""
    log: list[tuple[str, Touch]] = []
    simulate(meeting(told(log)), duration, dt=DT, solver="sequential")
    assert tuple(kind for kind, _ in log) == kinds


def test_calls_of_a_resting_body_begin_once_and_go_on() -> None:
    """Ten steps on the floor: one beginning, ten times each of the others, no end."""
    log: list[tuple[str, Touch]] = []
    simulate(resting(told(log)), 10 / 60, solver="sequential")
    counts = {kind: sum(k == kind for k, _ in log) for kind in KINDS}
    assert counts == {"begin": 1, "pre_solve": 10, "post_solve": 10, "separate": 0}


def test_calls_of_a_ball_that_bounces_twice_begin_twice() -> None:
    """Each touch has a beginning and an end of its own, in turn."""
    log: list[tuple[str, Touch]] = []
    floor = Body(Segment((-5, 0), (5, 0)))
    ball = Body(Circle(0.5), mass=1, position=(0, 1), material=Material(restitution=1))
    scene = Scene([floor, ball], gravity=(0, -10), callbacks=told(log, "begin", "separate"))
    simulate(scene, 1.5, solver="sequential")
    assert [kind for kind, _ in log] == ["begin", "separate"] * 2


def test_calls_of_several_pairs_come_in_the_order_of_their_bodies() -> None:
    """Before the impulses pair by pair, after them pair by pair, and those that part last."""
    log: list[tuple[str, Touch]] = []
    places = {0: (0, 0), 1: (0.9, 0), 2: (0, 9), 3: (0.9, 9)}
    bodies = [
        Body(Circle(0.5), mass=1, position=p, velocity=(6 * (n == 1), 0)) for n, p in places.items()
    ]
    simulate(Scene(bodies, callbacks=told(log)), 2e-2, dt=1e-2, solver="sequential")
    before = [("begin", 0, 1), ("pre_solve", 0, 1), ("begin", 2, 3), ("pre_solve", 2, 3)]
    after = [("post_solve", 0, 1), ("post_solve", 2, 3)]
    last = [("pre_solve", 2, 3), ("post_solve", 2, 3), ("separate", 0, 1)]
    assert [(k, touch.body_a, touch.body_b) for k, touch in log] == before + after + last


def test_calls_of_sub_steps_come_in_each() -> None:
    """Every part of a step has its own contacts and its own time."""
    log: list[tuple[str, Touch]] = []
    simulate(resting(told(log, "pre_solve")), 0.1, dt=0.1, substeps=4, solver="sequential")
    assert [touch.time for _, touch in log] == pytest.approx([0.025, 0.05, 0.075, 0.1])


# What they are told


def test_touch_worked_by_hand_is_told() -> None:
    """2 kg turned from -1 to 1 m/s has received 4 N s along (1, 0), between the two surfaces."""
    log: list[tuple[str, Touch]] = []
    simulate(meeting(told(log)), 1.0, dt=DT, solver="sequential")
    touches = dict(log)
    for touch in touches.values():
        assert (touch.body_a, touch.body_b, touch.normal) == (0, 1, (1.0, 0.0))
        assert touch.time == pytest.approx(0.6)
        assert touch.points == (pytest.approx((0, 0), abs=ROUNDING),)
        assert touch.penetration == pytest.approx(0.1)
        assert (touch.restitution, touch.friction, touch.ignored) == (1.0, 0.0, False)
    impulses = {kind: touch.normal_impulse for kind, touch in touches.items()}
    assert impulses == {
        "begin": 0.0,
        "pre_solve": 0.0,
        "post_solve": pytest.approx(4),
        "separate": pytest.approx(4),
    }


def test_touch_of_a_box_on_a_floor_has_two_points_and_carries_its_weight() -> None:
    """Its weight for a step, m g dt, summed over both corners: 2 kg at 10 m/s^2 for 1/60 s."""
    log: list[tuple[str, Touch]] = []
    simulate(resting(told(log, "post_solve")), 0.5, solver="sequential")
    touch = log[-1][1]
    assert touch.normal_impulse == pytest.approx(2 * 10 / 60, rel=ROUNDING)
    assert touch.tangent_impulse == pytest.approx(0, abs=ROUNDING)
    assert sorted(x for x, _ in touch.points) == pytest.approx([-0.5, 0.5])
    assert touch.normal == (0.0, 1.0)


def test_penetration_of_two_points_is_that_of_the_deeper() -> None:
    """A box leans to one side: its corners lie 0.01 m and 0.01 + sin(0.005) m deep."""
    log: list[tuple[str, Touch]] = []
    scene = resting(told(log, "begin"))
    low = 0.5 * (math.cos(0.005) + math.sin(0.005))
    box = replace(scene.bodies[1], position=(0, low - 0.01 - math.sin(0.005)), angle=0.005)
    simulate(
        Scene([scene.bodies[0], box], callbacks=scene.callbacks), 1e-3, dt=1e-3, solver="sequential"
    )
    touch = log[0][1]
    assert len(touch.points) == 2
    assert touch.penetration == pytest.approx(0.01 + math.sin(0.005))


@given(seed=st.integers(0, 10**6), e=st.floats(0, 1), mu=st.floats(0, 2))
def test_impulse_that_is_told_is_the_change_of_momentum(seed: int, e: float, mu: float) -> None:
    """B gains jn n + jt t, with t = n turned by +90 degrees; A loses it."""
    rng = np.random.default_rng(seed)
    way = rng.uniform(-math.pi, math.pi)
    masses = rng.uniform(0.1, 10, 2)
    bodies = [
        Body(
            Circle(1),
            mass=m,
            position=1.9 * k * np.array([math.cos(way), math.sin(way)]),
            velocity=rng.uniform(-5, 5, 2),
            angular_velocity=rng.uniform(-5, 5),
            material=Material(e, mu),
        )
        for k, m in enumerate(masses)
    ]
    log: list[tuple[str, Touch]] = []
    run = simulate(
        Scene(bodies, callbacks=told(log, "post_solve")), 1e-3, dt=1e-3, solver="sequential"
    )
    touch = log[0][1]
    n = np.array(touch.normal)
    t = np.array([-n[1], n[0]])
    change = masses[:, np.newaxis] * (run.velocities[1] - run.velocities[0])
    impulse = touch.normal_impulse * n + touch.tangent_impulse * t
    np.testing.assert_allclose(change, [-impulse, impulse], atol=100 * ROUNDING)


def test_impulses_that_are_told_are_those_of_the_run() -> None:
    """The callbacks and `run.contacts` are two views of the same steps."""
    log: list[tuple[str, Touch]] = []
    run = simulate(resting(told(log, "post_solve"), speed=1), 1.0, solver="sequential")
    times = np.array([touch.time for _, touch in log])
    for name in ("normal_impulse", "tangent_impulse"):
        recorded = [getattr(run.contacts, name)[run.contacts.time == t].sum() for t in times]
        heard = [getattr(touch, name) for _, touch in log]
        np.testing.assert_allclose(heard, recorded, rtol=ROUNDING)


# What they can change


def same_bits(a: Run, b: Run) -> bool:
    """Return whether two runs passed through the same states."""
    return a.positions.tobytes() + a.velocities.tobytes() == (
        b.positions.tobytes() + b.velocities.tobytes()
    )


def test_callbacks_that_only_listen_change_no_bit() -> None:
    """To look at a collision is not to take part in it."""
    log: list[tuple[str, Touch]] = []
    assert same_bits(
        simulate(resting(told(log), 1), 1.0, solver="sequential"),
        simulate(resting(speed=1), 1.0, solver="sequential"),
    )
    assert log


def test_touch_that_is_ignored_lets_the_bodies_pass() -> None:
    """A sensor: it hears of the touch, and nothing else happens."""
    log: list[tuple[str, Touch]] = []

    def ignore(touch: Touch) -> None:
        touch.ignored = True
        log.append(("pre_solve", touch))

    heard: list[str] = []
    callbacks = Callbacks(
        begin=lambda _: heard.append("begin"),
        pre_solve=ignore,
        post_solve=lambda _: heard.append("post_solve"),
        separate=lambda _: heard.append("separate"),
    )
    run = simulate(meeting(callbacks), 2.0, dt=DT, solver="sequential")
    np.testing.assert_allclose(run.positions[-1, :, 0], [0.95, -0.95], rtol=ROUNDING)
    assert len(run.contacts) == 0
    assert heard == ["begin", "separate"]
    assert all(touch.normal_impulse == 0 for _, touch in log)


def test_touch_ignored_at_first_is_resolved_later() -> None:
    """Ignoring holds for one step: in the next one the callback is asked again."""

    def ignore_at_first(touch: Touch) -> None:
        touch.ignored = touch.time < 0.65

    run = simulate(meeting(Callbacks(pre_solve=ignore_at_first)), 1.0, dt=DT, solver="sequential")
    assert run.contacts.time.tolist() == pytest.approx([0.7])
    np.testing.assert_allclose(run.velocities[-1, :, 0], [-1, 1], rtol=ROUNDING)


def test_touch_of_one_pair_ignored_leaves_the_others() -> None:
    """A ball falls through the first of two floors, and lies on the second."""

    def ignore(touch: Touch) -> None:
        touch.ignored = touch.body_a == 0

    floors = [Body(Segment((-5, y), (5, y))) for y in (0, -3)]
    ball = Body(Circle(0.5), mass=1, position=(0, 1))
    scene = Scene([*floors, ball], gravity=(0, -10), callbacks=Callbacks(begin=ignore))
    passing = Scene(scene.bodies, gravity=(0, -10), callbacks=Callbacks(pre_solve=ignore))
    # `begin` ignores the first step alone: the ball, slow as it is, stays on the first floor.
    assert simulate(scene, 3.0, solver="sequential").positions[-1, 2, 1] > 0.4
    assert simulate(passing, 3.0, solver="sequential").positions[-1, 2, 1] == pytest.approx(
        -2.5, abs=0.02
    )


@pytest.mark.parametrize("kind", ["begin", "pre_solve"])
def test_restitution_that_is_set_acts_at_once(kind: str) -> None:
    """Discs that would stick are given e = 0.5, and part at half their speed."""

    def soften(touch: Touch) -> None:
        touch.restitution = 0.5

    run = simulate(meeting(Callbacks(**{kind: soften}), e=0), 1.0, dt=DT, solver="sequential")
    np.testing.assert_allclose(run.velocities[-1, :, 0], [-0.5, 0.5], rtol=ROUNDING)


def test_friction_that_is_set_acts_in_that_step_only() -> None:
    """Oil under the first six steps; then mu g = 5 m/s^2 as before."""

    def oil(touch: Touch) -> None:
        if touch.time < 0.105:
            touch.friction = 0.0

    run = simulate(resting(Callbacks(pre_solve=oil), speed=2), 0.2, solver="sequential")
    speeds = run.velocities[:, 1, 0]
    np.testing.assert_allclose(speeds[:7], 2, rtol=ROUNDING)
    np.testing.assert_allclose(-np.diff(speeds[6:]), 5 / 60, rtol=1e-9)


@pytest.mark.parametrize("kind", ["post_solve", "separate"])
def test_coefficients_set_after_the_impulses_change_nothing(kind: str) -> None:
    """It is too late for this step, and the next one asks the materials."""

    def late(touch: Touch) -> None:
        touch.restitution, touch.ignored = 1.0, True

    changed = simulate(resting(Callbacks(**{kind: late})), 0.5, solver="sequential")
    assert same_bits(changed, simulate(resting(), 0.5, solver="sequential"))


@pytest.mark.parametrize("wrong", [-0.5, math.nan, math.inf])
@pytest.mark.parametrize("name", ["restitution", "friction"])
def test_coefficient_out_of_range_that_is_set_is_refused_by_name(name: str, wrong: float) -> None:
    """A negative friction would drive the box on, and nan would let it fall through."""
    callbacks = Callbacks(pre_solve=lambda touch: setattr(touch, name, wrong))
    with pytest.raises(ValueError, match=f"{name} must be >= 0 and finite, got {wrong}"):
        simulate(resting(callbacks), 0.1, solver="sequential")


def test_restitution_above_one_may_be_set() -> None:
    """A bumper gives more than it got: the discs meet at 1 m/s each and leave at 1.5."""

    def bump(touch: Touch) -> None:
        touch.restitution = 1.5

    run = simulate(meeting(Callbacks(begin=bump)), 1.0, dt=DT, solver="sequential")
    np.testing.assert_allclose(run.velocities[-1, :, 0], [-1.5, 1.5], rtol=ROUNDING)


def test_error_in_a_callback_reaches_the_caller() -> None:
    """Nobody swallows it."""

    def wrong(touch: Touch) -> None:
        raise RuntimeError("no sound card")

    with pytest.raises(RuntimeError, match="no sound card"):
        simulate(meeting(Callbacks(begin=wrong)), 1.0, solver="sequential")


# The callbacks themselves


class Log(list[Any]):
    """A list that can be called; as long as it is empty it counts as false."""

    def __call__(self, touch: Touch) -> None:
        """Write down when a touch was."""
        self.append(touch.time)


@pytest.mark.parametrize("kind", KINDS)
def test_callback_that_counts_as_false_is_called_too(kind: str) -> None:
    """Wanted is what is not None."""
    log = Log()
    callbacks = Callbacks(**{kind: log})
    assert callbacks.wanted
    simulate(meeting(callbacks), 1.0, dt=DT, solver="sequential")
    assert log == pytest.approx([0.6])


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("wrong", [3, "beep", []])
def test_callback_that_cannot_be_called_is_refused_by_name(kind: str, wrong: Any) -> None:
    """It would otherwise fail only at the first collision."""
    with pytest.raises(TypeError, match=f"{kind} must be callable or None, got"):
        Callbacks(**{kind: wrong})
