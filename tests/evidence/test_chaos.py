"""How fast two gases part: the fit, the disturbance, and the law that a dilute gas parts faster."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import pytest
from rich.console import Console

from lesson_code import Body, Circle, Material, Scene, simulate
from lesson_code.evidence import chaos
from lesson_code.evidence.chaos import Chaos, Parting, Spread
from lesson_code.evidence.scenes.events import WALLS
from lesson_code.evidence.scenes.gas import disc_gas, hits_a_disc

ROUNDING = 1e-12
"""A straight line fitted to a dozen points: some hundred roundings of 1e-16."""

SECOND_ORDER = 1e-5
"""Relative: the shift is 1e-6 of a diameter, and what the linear law leaves out is its square."""

HALF = 0.5
"""Relative: a median of four runs, whose start and end are no part of the exponential growth."""


def small(runs: int = 7, **options: Any) -> Chaos:
    """Return what 25 discs do in some seconds."""
    return chaos.measure_chaos(runs, side=5, **options)


# The fit


@pytest.mark.parametrize("factor", [1.5, 2.0, 20.0])
def test_growth_rate_of_an_exact_power_is_its_logarithm(factor: float) -> None:
    """An error that is multiplied by the same factor at each collision, from 1e-12 m on."""
    hits = np.linspace(0, 20 / math.log(factor), 60)
    rate = chaos.growth_rate(hits, 1e-12 * factor**hits, displacement=1e-12)
    assert rate == pytest.approx(math.log(factor), rel=ROUNDING)


def test_growth_rate_leaves_out_the_start_and_what_has_saturated() -> None:
    """Before ten displacements, and beyond a hundredth of a diameter, anything may happen."""
    hits = np.arange(30.0)
    error = np.minimum(np.maximum(1e-6 * 2**hits, 9e-6), 0.9e3)
    error[:3], error[20:] = 1e-6, 7.0
    assert chaos.growth_rate(hits, error, 1e-6) == pytest.approx(math.log(2), rel=ROUNDING)


@pytest.mark.parametrize("error", [[1e-6, 2e-6, 3e-6], [1e-6, 1e-4, 1.0], [0.0, 0.0, 0.0]])
def test_growth_rate_of_runs_that_have_not_parted_is_refused(error: list[float]) -> None:
    """Through less than two points there is no line."""
    with pytest.raises(ValueError, match="duration must be longer"):
        chaos.growth_rate(np.arange(3.0), np.array(error), displacement=1e-6)


@pytest.mark.parametrize(
    ("error", "expected"), [([0.0, 0.2, 0.05], 2.0), ([0.3, 0.4, 0.5], 1.0), ([0.1] * 3, math.inf)]
)
def test_lost_after_is_where_the_error_first_exceeds_a_tenth(
    error: list[float], expected: float
) -> None:
    """And never where it only comes up to it."""
    assert chaos.lost_after(np.array([1.0, 2.0, 3.0]), np.array(error)) == expected


@pytest.mark.parametrize(
    ("values", "expected"),
    [
        ([7.0], Spread(7.0, 7.0, 7.0)),
        ([5.0, 1.0, 4.0, 2.0, 3.0], Spread(3.0, 2.0, 4.0)),
        ([1.0, math.inf, 2.0, math.inf], Spread(2.0, 1.0, math.inf)),
    ],
)
def test_spread_is_made_of_values_that_are_there(values: list[float], expected: Spread) -> None:
    """So a run that is never lost makes no nan of the others."""
    assert chaos.spread(values) == expected


# The disturbance


def test_displaced_moves_one_body_and_nothing_else() -> None:
    """The scene that was given stays as it was."""
    gas = disc_gas(3, 0.4, seed=1)
    moved = chaos.displaced(gas, WALLS + 2, by=(0.25, -0.5))
    before, after = gas.bodies[WALLS + 2], moved.bodies[WALLS + 2]
    assert after.position == (before.position[0] + 0.25, before.position[1] - 0.5)
    assert after.velocity == before.velocity
    assert [n for n, body in enumerate(moved.bodies) if body is not gas.bodies[n]] == [WALLS + 2]


def test_hits_in_time_begin_with_none_and_end_with_all() -> None:
    """They never fall, and hits on walls do not count."""
    run = simulate(disc_gas(4, 0.4, seed=1), 3.0, solver="exact", sample=np.linspace(0, 3, 31))
    hits = chaos.hits_in_time(run)
    assert (hits[0], hits[-1]) == (0.0, hits_a_disc(run))
    assert (np.diff(hits) >= 0).all()
    assert hits[-1] > 5


def test_error_after_one_hit_grows_by_the_flight_over_the_diameter() -> None:
    """A disc 1 m wide hits another head on at 1 m/s; a shift d aside turns the normal by d.

    The disc that was hit flies along the normal: a time t after the hit it is t d off. The other
    one keeps what it has along the tangent, d times 1 m/s: it is d + t d off, the other way.
    """
    ball = {"mass": 1.0, "material": Material(restitution=1.0)}
    scene = Scene(
        [
            Body(Circle(0.5), position=(-2, 0), velocity=(1, 0), **ball),
            Body(Circle(0.5), **ball),
        ]
    )
    times, shift = np.array([0.0, 3.0, 6.0]), 1e-6
    straight = simulate(scene, 6.0, solver="exact", sample=times)
    aside = simulate(chaos.displaced(scene, 0, (0, shift)), 6.0, solver="exact", sample=times)
    error = chaos.farthest_apart(straight.positions, aside)
    assert error == pytest.approx([shift, 3 * shift, 6 * shift], rel=SECOND_ORDER)


# The ensemble


def test_dilute_gas_parts_faster_at_each_collision() -> None:
    """A longer flight between hits makes more of the same turn (Krylov)."""
    rates = [
        small(covered=covered, duration=duration).rate.median
        for covered, duration in ((0.1, 60.0), (0.3, 24.0), (0.5, 9.0))
    ]
    assert rates[0] > 2 * rates[1] > 2 * rates[2] > 0


def test_start_a_million_times_better_is_lost_some_collisions_later() -> None:
    """By ln(1e6) over the growth rate: exponential growth buys time at a poor price."""
    measured = small(14, covered=0.3, duration=24.0)
    lost = [
        chaos.spread(parting.lost_after for parting in group).median
        for group in measured.by_displacement().values()
    ]
    later = math.log(1e6) / measured.rate.median
    assert lost[0] - lost[-1] == pytest.approx(later, rel=HALF)


def test_ensemble_is_the_same_for_one_worker_and_for_two() -> None:
    """Every digit of what is printed as JSON; another seed draws another gas."""
    one, two, other = (
        json.dumps(small(3, covered=0.3, duration=20.0, workers=workers, seed=seed).as_dict())
        for workers, seed in ((1, 1), (2, 1), (1, 2))
    )
    assert one == two
    assert one != other


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"runs": 0}, "runs must be >= 1, got 0"),
        ({"duration": 0.0}, "duration must be > 0"),
        ({"duration": 0.01}, "duration must be longer"),
        ({"covered": 1.0}, "covered must be so small that rows of 5 fit"),
    ],
)
def test_ensemble_that_cannot_be_measured_is_refused(options: Any, words: str) -> None:
    """The error names the argument."""
    with pytest.raises(ValueError, match=words):
        small(**{"runs": 1, "workers": 1, **options})


# What is printed


def two_partings() -> Chaos:
    """Return an ensemble of two runs, of which one is never lost."""
    return Chaos(64, 0.5, 1, (Parting(1e-6, math.log(2), math.inf), Parting(1e-12, 0.5, 40.0)))


def test_json_has_no_infinity() -> None:
    """JSON knows none: what never happens is null. The smallest displacement comes first."""
    report = json.loads(json.dumps(two_partings().as_dict(), allow_nan=False))
    assert (report["version"], report["command"], report["runs"]) == (1, "measure chaos", 2)
    assert [row["displacement"] for row in report["displacements"]] == [1e-12, 1e-6]
    assert report["displacements"][0]["collisions_until_lost"]["median"] == 40.0
    assert report["displacements"][1]["collisions_until_lost"]["median"] is None


def test_table_shows_the_factor_of_each_collision() -> None:
    """exp(rate), and "never" in words."""
    console = Console(width=120)
    with console.capture() as capture:
        console.print(two_partings().as_table())
    text = capture.get()
    assert "2.00 (2.00 to 2.00)" in text
    assert "never" in text
    assert "40 (40 to 40)" in text
