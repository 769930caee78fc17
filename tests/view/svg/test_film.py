"""A run as it is played: recorded states only, on an even clock, as whole tenths of a pixel."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code import Body, Circle, Run, Scene, Segment
from lesson_code.view.framing import View
from lesson_code.view.svg.film import clock_of, differences, fastest_speed, film_of
from lesson_code.view.svg.scene_svg import Sheet

SHEET = Sheet(View(0, 10, 0, 10), 10.0, ("",))
"""10 px a metre: 1 cm is a tenth of a pixel, and places are easily read."""

BALL = Body(Circle(1.0), mass=1.0)
FLOOR = Body(Segment((-5, 0), (5, 0)))
UP = (0.0, 1.0)


def flight(run_of: Any, times: Any) -> Run:
    """Return a ball that moves along x and turns at 1 rad/s; its velocity is said to be (1, 2)."""
    places = [[(0, 0), (time, 2.0)] for time in times]
    run: Run = run_of(
        Scene([FLOOR, BALL]),
        times,
        places,
        angles=[[0, time] for time in times],
        velocities=[[(0, 0), (1, 2)] for _ in times],
    )
    return run


def test_clock_runs_as_long_as_the_run_took(run_of: Any) -> None:
    """61 states in a second, 30 pictures a second: every second state."""
    clock = clock_of([flight(run_of, np.arange(61) / 60)], None, 30.0)
    assert (clock.start, clock.duration, clock.seconds, clock.frames) == (0, 1, 1, 31)
    assert clock.times == pytest.approx(np.arange(31) / 30)


def test_slow_motion_shows_more_states_but_never_more_than_there_are(run_of: Any) -> None:
    """Played four times slower, all 61 states are shown, and no more."""
    assert clock_of([flight(run_of, np.arange(61) / 60)], 4.0, 30.0).frames == 61


def test_clock_of_several_runs_spans_them_all(run_of: Any) -> None:
    """From the earliest to the latest time."""
    runs = [flight(run_of, [0.5, 1.0]), flight(run_of, [0.0, 0.75])]
    clock = clock_of(runs, None, 30.0)
    assert (clock.start, clock.duration) == (0.0, 1.0)


def test_single_state_is_a_single_picture(run_of: Any) -> None:
    """A run of no duration does not divide by it."""
    clock = clock_of([flight(run_of, [2.0])], None, 30.0)
    assert (clock.times.tolist(), clock.decimals) == ([2.0], 0)


@pytest.mark.parametrize(
    ("duration", "decimals"), [(60.0, 1), (5.0, 2), (1.0, 2), (0.5, 3), (0.002, 5), (1000.0, 0)]
)
def test_times_are_written_with_three_figures_or_so(
    run_of: Any, duration: float, decimals: int
) -> None:
    """Neighbouring pictures have different times on the clock."""
    assert clock_of([flight(run_of, [0.0, duration])], 1.0, 30.0).decimals == decimals


def test_too_many_pictures_are_refused(run_of: Any) -> None:
    """A notebook should not grow by megabytes by accident."""
    with pytest.raises(ValueError, match=r"seconds \* fps must be <= 3000 pictures"):
        clock_of([flight(run_of, np.arange(4000.0))], None, 30.0)


@pytest.mark.parametrize("seconds", [0.0, -1.0, float("nan")])
def test_playing_takes_a_time(run_of: Any, seconds: float) -> None:
    """It is positive."""
    with pytest.raises(ValueError, match="seconds must be"):
        clock_of([flight(run_of, [0.0, 1.0])], seconds, 30.0)


def test_picture_at_a_time_is_the_nearest(run_of: Any) -> None:
    """None is the start; a time outside is refused."""
    clock = clock_of([flight(run_of, np.arange(11) / 10)], None, 30.0)
    assert [clock.frame_at(time) for time in (None, 0.0, 0.26, 1.0)] == [0, 0, 3, 10]
    with pytest.raises(ValueError, match="still must lie between 0 and 1 s, got 2"):
        clock.frame_at(2.0)


def test_places_are_tenths_of_a_pixel_and_angles_tenths_of_a_degree(run_of: Any) -> None:
    """1.5 m to the right is 150 tenths; 1 rad counter-clockwise is -573 tenths of a degree."""
    run = flight(run_of, [0.0, 1.0])
    film = film_of(run, clock_of([run], None, 30.0), SHEET, 0.0, contacts=False)
    assert film.places[:, 1].tolist() == [[0, 800], [100, 800]]
    assert film.turns[:, 1].tolist() == [0, -573]
    assert not film.arrows.any()
    assert film.contacts == []


def test_each_picture_shows_the_last_state_before_it(run_of: Any) -> None:
    """Between states nothing is made up: at 0.5 s of a run recorded at 0, 0.4 and 1 s it is 0.4."""
    run = flight(run_of, [0.0, 0.4, 1.0])
    film = film_of(run, clock_of([run], None, 30.0), SHEET, 0.0, contacts=False)
    assert film.places[:, 1, 0].tolist() == [0, 40, 100]


def test_states_out_of_order_are_played_in_order(run_of: Any) -> None:
    """A run may be sampled at times in any order."""
    run = flight(run_of, [1.0, 0.0, 0.5])
    film = film_of(run, clock_of([run], None, 30.0), SHEET, 0.0, contacts=False)
    assert film.places[:, 1, 0].tolist() == [0, 50, 100]


def test_run_that_begins_later_waits_in_its_first_state(run_of: Any) -> None:
    """Beside one that begins at 0 s, a run from 0.5 s on stands still until then."""
    late = flight(run_of, [0.5, 1.0])
    clock = clock_of([late, flight(run_of, [0.0, 0.25, 0.5, 0.75, 1.0])], None, 30.0)
    film = film_of(late, clock, SHEET, 0.0, contacts=False)
    assert film.places[:, 1, 0].tolist() == [50, 50, 50, 50, 100]


def test_arrows_are_velocities_with_y_down(run_of: Any) -> None:
    """At 20 px for 1 m/s, (1, 2) m/s is 200 tenths to the right and 400 up."""
    run = flight(run_of, [0.0, 1.0])
    film = film_of(run, clock_of([run], None, 30.0), SHEET, 20.0, contacts=False)
    assert film.arrows[:, 1].tolist() == [[200, -400], [200, -400]]
    assert [len(path) for path in film.paths()] == [5]


def test_only_bodies_that_move_have_a_path(run_of: Any) -> None:
    """The floor has none; the ball's is x, y and angle."""
    run = flight(run_of, [0.0, 1.0])
    film = film_of(run, clock_of([run], None, 30.0), SHEET, 0.0, contacts=False)
    assert film.paths() == [[[0, 100], [800], [0, -573]]]


def test_fastest_speed_is_that_of_any_body_at_any_time(run_of: Any) -> None:
    """Of all runs; 0 when there are no bodies."""
    slow, fast = flight(run_of, [0.0, 1.0]), flight(run_of, [0.0, 1.0])
    fast.velocities[1, 1] = (3, -4)
    assert fastest_speed([slow, fast]) == 5
    assert fastest_speed([run_of(Scene(), [0.0], [])]) == 0


TOUCHES = [
    (0.1, 0, 1, (1, 0), UP, 1.0, 0.0),
    (0.1, 0, 1, (2, 0), UP, 1.0, 0.0),
    (0.2, 0, 1, (3, 0), UP, 1.0, 0.0),
]


def touching(run_of: Any, states: int) -> Run:
    """Return a ball and a floor over 1 s, with two contact points and then one other."""
    run: Run = run_of(
        Scene([FLOOR, BALL]),
        np.linspace(0, 1, states),
        np.zeros((states, 2, 2)),
        contacts=TOUCHES,
    )
    return run


def test_contact_points_stay_for_a_tenth_of_a_second(run_of: Any) -> None:
    """Both points of 0.1 s are shown until the next of the same pair takes their place."""
    run = touching(run_of, 21)
    film = film_of(run, clock_of([run], None, 30.0), SHEET, 0.0, contacts=True)
    two, one = [10, 100, 20, 100], [30, 100]
    assert film.contacts[:8] == [[], [], two, two, one, one, [], []]
    assert film.state(2).contacts == two


def test_contact_between_two_pictures_is_shown_on_the_next(run_of: Any) -> None:
    """At 2 pictures a second no contact is lost."""
    run = touching(run_of, 3)
    film = film_of(run, clock_of([run], None, 30.0), SHEET, 0.0, contacts=True)
    assert film.contacts == [[], [30, 100], []]


@given(st.lists(st.integers(-9999, 9999), min_size=1, max_size=30))
def test_differences_add_up_to_the_numbers(numbers: list[int]) -> None:
    """What is left out at the end is only zeros."""
    kept = differences(np.array(numbers))
    assert 1 <= len(kept) <= len(numbers)
    padded = kept + [0] * (len(numbers) - len(kept))
    assert np.cumsum(padded).tolist() == numbers
