"""From a solver's steps to a run: which states are kept, and what is made of the impulses."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from numpy.typing import NDArray

from lesson_code import Body, Circle, Material, Run, Scene, Segment, simulate
from lesson_code.engine.core.frames import STATE_NUMBERS
from lesson_code.engine.core.plan import Plan
from lesson_code.engine.core.recording import Stepper, moved_on, record

ROUNDING = 1e-12
"""s and m: a time is a product of a step and its number, and up to 100."""

REASON = "for these tests"
DISC = Body(Circle(1), mass=1, velocity=(2, 0))


class Counter(Stepper):
    """A solver that counts: x is the number of its steps, v = (1, -1), w = 0.5."""

    def __init__(self, dt: float = 0.25, bodies: int = 1) -> None:
        self.dt = dt
        self.done = 0
        self._bodies = bodies

    def advance(self, steps: int) -> None:
        """Count."""
        assert steps >= 0
        self.done += steps

    def states(self) -> NDArray[np.float64]:
        """Return x = y = angle = the number of steps."""
        n = float(self.done)
        return np.array([(n, n, n, 1.0, -1.0, 0.5)] * self._bodies).reshape(-1, STATE_NUMBERS)

    def states_after(self, duration: float) -> NDArray[np.float64]:
        """Return the states moved on at their velocities."""
        return moved_on(self.states(), duration)

    def events(self) -> NDArray[np.float64]:
        """Return one event for each step."""
        times = self.dt * np.arange(1, self.done + 1)
        rest = (0, 1, 0.5, -0.5, 1.0, 0.0, 3.0, -1.0, 0.1)
        return np.column_stack([times, *[np.full(self.done, number) for number in rest]])

    def plan(self, reason: str) -> Plan:
        """Return how it ran."""
        return Plan("counter", reason)


def recorded(duration: float, sample: Any = None, dt: float = 0.25) -> tuple[Counter, Run]:
    """Return a counter that has run for a while, and what was recorded."""
    counter = Counter(dt)
    return counter, record(counter, Scene([DISC]), duration, sample, REASON)


# Every step


@pytest.mark.parametrize(
    ("duration", "times"),
    [
        (1.0, [0, 0.25, 0.5, 0.75, 1.0]),
        (0.6, [0, 0.25, 0.5, 0.6]),
        (0.1, [0, 0.1]),
        (0.0, [0]),
    ],
    ids=["whole steps", "steps and a rest", "less than a step", "no time"],
)
def test_times_without_a_sample_are_those_of_every_step_and_the_end(
    duration: float, times: list[float]
) -> None:
    """The first state is the scene's, the last that at the duration."""
    _, run = recorded(duration)
    assert run.times.tolist() == times


@given(steps=st.integers(0, 400), dt=st.floats(1e-3, 10))
def test_times_of_whole_steps_have_no_rest_that_is_only_rounding(steps: int, dt: float) -> None:
    """0.1 + 0.1 + 0.1 s are three steps of 0.1 s and not three and a bit."""
    counter, run = recorded(steps * dt, dt=dt)
    assert len(run.times) == steps + 1
    assert counter.done == steps
    assert run.times[-1] == pytest.approx(steps * dt, rel=ROUNDING)


@example(duration=0.3, dt=0.1)  # 3 x 0.1 = 0.30000000000000004
@given(duration=st.floats(0, 5), dt=st.floats(0.01, 1))
def test_times_never_lie_beyond_the_duration(duration: float, dt: float) -> None:
    """So that a run's own times may be asked for again."""
    _, run = recorded(duration, dt=dt)
    assert (np.diff(run.times) > 0).all()
    assert run.times[-1] <= duration
    _, again = recorded(duration, run.times, dt=dt)
    np.testing.assert_array_equal(again.positions, run.positions)


# Between the steps


def test_state_between_two_steps_is_the_earlier_moved_on() -> None:
    """At 0.6 s: two steps of 0.25 s, and 0.1 s at (1, -1) m/s and 0.5 rad/s."""
    _, run = recorded(0.6)
    np.testing.assert_allclose(run.positions[-1, 0], (2.1, 1.9), rtol=ROUNDING)
    assert run.angles[-1, 0] == pytest.approx(2.05)
    assert run.velocities[-1, 0].tolist() == [1.0, -1.0]


def test_state_between_two_steps_changes_nothing_that_follows() -> None:
    """To look more often is not to simulate otherwise: the same bits at the steps."""
    floor = Body(Segment((-5, 0), (5, 0)))
    ball = Body(Circle(0.5), mass=1, position=(0, 1), material=Material(0.9))
    scene = Scene([floor, ball], gravity=(0, -10))
    plain = simulate(scene, 1.0, dt=1 / 64, solver="sequential")
    often = simulate(scene, 1.0, dt=1 / 64, sample=np.linspace(0, 1, 256 + 1), solver="sequential")
    np.testing.assert_array_equal(often.positions[::4], plain.positions)
    np.testing.assert_array_equal(often.velocities[::4], plain.velocities)


# Samples

GIVEN = {
    "in order": [0.1, 0.6, 1.0],
    "unsorted": [1.0, 0.0, 0.6, 0.1],
    "repeated": [0.5, 0.5, 0.5],
    "the beginning": [0.0],
    "the end": [1.0],
    "none": [],
}


@pytest.mark.parametrize("sample", GIVEN.values(), ids=GIVEN)
def test_states_at_given_times_come_in_the_order_that_was_given(sample: list[float]) -> None:
    """One frame for each time, and x = t / dt for the whole steps and 1 m/s for the rest."""
    _, run = recorded(1.0, sample)
    steps = np.floor(np.array(sample) / 0.25)
    assert run.times.tolist() == sample
    np.testing.assert_allclose(
        run.positions[:, 0, 0] if sample else [],
        steps + (np.array(sample) - 0.25 * steps),
        rtol=ROUNDING,
    )


@pytest.mark.parametrize("sample", [*GIVEN.values(), "end", None])
def test_run_goes_on_to_its_end_whatever_is_sampled(sample: Any) -> None:
    """The impulses after the last state that was asked for belong to the run as well."""
    counter, run = recorded(1.0, sample)
    assert counter.done == len(run.contacts) == 4


def test_sample_end_keeps_the_first_and_the_last_state() -> None:
    """Two frames, however long the run."""
    _, run = recorded(25.1, "end")
    assert run.times.tolist() == [0.0, 25.1]
    np.testing.assert_allclose(run.positions[:, 0, 0], [0, 100.1], rtol=ROUNDING)


def test_sample_of_no_time_at_all_keeps_the_same_state_twice() -> None:
    """A duration of 0 is allowed: nothing happens."""
    counter, run = recorded(0.0, "end")
    assert (run.times.tolist(), counter.done, len(run.contacts)) == ([0.0, 0.0], 0, 0)


@pytest.mark.parametrize(
    ("sample", "message"),
    [
        ("every", "sample must be None, \"end\" or an array of times, got 'every'"),
        ([0.5, 1.1], "sample must be <= duration = 1.0 s, got 1.1"),
        ([-0.1], "sample must be >= 0 and finite, got -0.1"),
        ([0.0, float("nan")], "sample must be >= 0 and finite, got nan"),
        ([float("inf")], "sample must be >= 0 and finite, got inf"),
        (0.5, r"sample must have shape \(F,\), got shape \(\)"),
        ([[0.5]], r"sample must have shape \(F,\), got shape \(1, 1\)"),
    ],
)
def test_sample_that_makes_no_sense_is_refused_by_name(sample: Any, message: str) -> None:
    """The error names the rule and the value."""
    with pytest.raises(ValueError, match=message):
        recorded(1.0, sample)


@pytest.mark.parametrize("sample", [["now"], {"at": 0.5}])
def test_sample_of_another_kind_is_refused_by_name(sample: Any) -> None:
    """Times are numbers."""
    with pytest.raises(TypeError, match="sample must be a real number or an array of them"):
        recorded(1.0, sample)


# Arrays


@pytest.mark.parametrize("bodies", [0, 1, 3])
@pytest.mark.parametrize("sample", [None, "end", [], [0.3]])
def test_arrays_have_the_shapes_that_the_run_promises(bodies: int, sample: Any) -> None:
    """F frames of N bodies, and K impulses; also where F, N or K is 0."""
    run = record(Counter(bodies=bodies), Scene([DISC] * bodies), 1.0, sample, REASON)
    frames, events = len(run.times), 4
    assert run.positions.shape == run.velocities.shape == (frames, bodies, 2)
    assert run.angles.shape == run.angular_velocities.shape == (frames, bodies)
    hits = run.contacts
    assert hits.point.shape == hits.normal.shape == (events, 2)
    for name in ("time", "body_a", "body_b", "normal_impulse", "tangent_impulse", "penetration"):
        assert getattr(hits, name).shape == (events,)
    assert hits.body_a.dtype == hits.body_b.dtype == np.int64


def test_impulses_arrive_in_their_columns() -> None:
    """The order of an event: time, bodies, point, normal, impulses, penetration."""
    hits = recorded(0.25)[1].contacts
    assert [column.tolist() for column in vars(hits).values()] == [
        *([0.25], [0], [1], [[0.5, -0.5]], [[1.0, 0.0]], [3.0], [-1.0], [0.1]),
    ]


@pytest.mark.parametrize("name", ["times", "positions", "velocities", "angles"])
def test_states_cannot_be_changed(name: str) -> None:
    """A figure cannot spoil the run it is drawn from."""
    array = getattr(recorded(1.0)[1], name)
    with pytest.raises(ValueError, match="read-only"):
        array[...] = 0


@pytest.mark.parametrize("name", ["time", "body_a", "point", "normal_impulse"])
def test_impulses_cannot_be_changed(name: str) -> None:
    """Nor what happened in it."""
    array = getattr(recorded(1.0)[1].contacts, name)
    with pytest.raises(ValueError, match="read-only"):
        array[...] = 0


def test_state_beyond_floating_point_is_refused_with_its_body_and_time() -> None:
    """A run holds numbers, never nan or infinity."""

    class Runaway(Counter):
        """Its second body is lost after three steps."""

        def states(self) -> NDArray[np.float64]:
            lost = float("nan") if self.done >= 3 else 0.0
            return np.array([(0.0,) * 6, (0.0, 0.0, 0.0, lost, 0.0, 0.0)])

    with pytest.raises(FloatingPointError, match=r"body 1 has left the range .* at 0\.75 s"):
        record(Runaway(bodies=2), Scene([DISC] * 2), 1.0, None, REASON)


def test_duration_of_more_steps_than_a_day_holds_is_refused() -> None:
    """A mistaken unit is named, instead of filling the memory."""
    with pytest.raises(ValueError, match=r"duration must be at most 1e\+09 dt, got 1e\+30 s"):
        simulate(Scene(), 1e30, solver="sequential")
