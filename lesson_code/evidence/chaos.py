"""Chaos in the gas of chapter 07: how fast two almost identical runs separate.

The same discs start twice; the second time, one of them is displaced by a tiny amount. Both runs
are exact, so the laws of motion alone drive them apart. At first the distance grows by about the
same factor with each collision:

    error = displacement exp(rate hits),    ln error = ln displacement + rate hits

    displacement   how far one disc was moved at the start, m
    error          largest distance between a disc and the same disc in the other run, m
    hits           collisions per disc so far, on average

    rate           growth rate, per collision of a disc; each one multiplies the error by exp(rate)
"""

from __future__ import annotations

import functools
import math
from collections.abc import Iterable
from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray
from rich.table import Table

from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Scene
from lesson_code.evidence.ensembles import simulate_many
from lesson_code.evidence.scenes.events import WALLS
from lesson_code.evidence.scenes.gas import DIAMETER, disc_gas
from lesson_code.formulas.validation import Vector, one_number, positive
from lesson_code.simulation import simulate

VERSION = 1
"""Version of the form that :meth:`Chaos.as_dict` writes; it grows when a key changes."""

DISPLACEMENTS = tuple(10.0**power for power in range(-12, -5))
"""m: how far a disc is moved. The smallest is a thousand times the rounding error of a position in
the box, 1e-15 m; the largest still leaves room to grow."""

RUNS = 28
"""Four for each displacement: enough for a median and its quartiles, in a few seconds."""

SIDE, COVERED = 8, 0.5
"""Rows of discs, and the share of the box that they cover: the gas of chapter 07."""

DURATION, SAMPLES = 9.0, 181
"""s, and times at which two runs are compared. Each disc has hit 66 others by then; even runs that
began 1e-12 m apart separated long before."""

SETTLED, SATURATED = 10.0, 0.01 * DIAMETER
"""The rate is fitted from this many displacements to this many metres: before that one disc's error
has not spread to the others, and later the box leaves no room to grow."""

LOST = 0.1 * DIAMETER
"""m: with an error this large, the two runs have nothing in common."""


@dataclass(frozen=True)
class Parting:
    """How one run departed from the undisturbed one.

    Attributes
    ----------
    displacement : float
        Of one disc at the start, m.
    rate : float
        Growth rate of the error, per collision of a disc.
    lost_after : float
        Collisions of a disc after which the error is over a tenth of a diameter; ``math.inf``
        where it never is.
    """

    displacement: float
    rate: float
    lost_after: float


@dataclass(frozen=True)
class Spread:
    """Median and quartiles of an ensemble; each is the value of an actual run."""

    median: float
    lower_quartile: float
    upper_quartile: float


@dataclass(frozen=True)
class Chaos:
    """How an ensemble of runs departed from the undisturbed one.

    Attributes
    ----------
    discs : int
        Number of discs in the box.
    covered : float
        Share of the box that they cover.
    seed : int
        Seed that drew the gas and the displacements.
    partings : tuple of Parting
        One for each run.
    """

    discs: int
    covered: float
    seed: int
    partings: tuple[Parting, ...]

    @property
    def rate(self) -> Spread:
        """Growth rate per collision, over all runs."""
        return spread(parting.rate for parting in self.partings)

    def by_displacement(self) -> dict[float, list[Parting]]:
        """Return the runs of each displacement, the smallest first."""
        sizes = sorted({parting.displacement for parting in self.partings})
        return {size: [p for p in self.partings if p.displacement == size] for size in sizes}

    def as_dict(self) -> dict[str, Any]:
        """Return the result as one JSON object; None means never."""
        return {
            "version": VERSION,
            "command": "measure chaos",
            "discs": self.discs,
            "covered": self.covered,
            "seed": self.seed,
            "runs": len(self.partings),
            "growth_rate_per_collision": _plain(self.rate),
            "displacements": [
                {
                    "displacement": size,
                    "runs": len(partings),
                    "growth_rate_per_collision": _plain(spread(p.rate for p in partings)),
                    "collisions_until_lost": _plain(spread(p.lost_after for p in partings)),
                }
                for size, partings in self.by_displacement().items()
            ],
        }

    def as_table(self) -> Table:
        """Return the result as a table: for each displacement the median, and the quartiles."""
        table = Table(
            "moved by, m",
            "runs",
            "error grows by, a collision",
            "collisions until it is lost",
            title=f"Two runs of {self.discs} discs that began almost alike",
            caption=f"Lost: a disc is over {LOST:g} diameters off. Medians; in brackets quartiles.",
        )
        rows = [(f"{size:.0e}", group) for size, group in self.by_displacement().items()]
        for name, group in [*rows, ("all", list(self.partings))]:
            factors = spread(math.exp(parting.rate) for parting in group)
            lost = spread(parting.lost_after for parting in group)
            until = "" if name == "all" else _written(lost, "{:.0f}")
            table.add_row(name, str(len(group)), _written(factors, "{:.2f}"), until)
        return table


def measure_chaos(
    runs: int = RUNS,
    *,
    side: int = SIDE,
    covered: float = COVERED,
    duration: float = DURATION,
    seed: int = 1,
    workers: int | None = None,
    cluster: str | None = None,
    progress: str | None = None,
) -> Chaos:
    """Disturb a gas in many ways, and measure how fast each run parts from the undisturbed one.

    The displacements of :data:`DISPLACEMENTS` take turns. Each run draws separately which disc is
    moved, and in which direction.

    Parameters
    ----------
    runs : int
        Disturbed runs, >= 1.
    side, covered, seed
        As :func:`lesson_code.evidence.scenes.gas.disc_gas` takes them.
    duration : float
        Of each run, s, > 0.
    workers, cluster, progress
        As :func:`lesson_code.parallel.map_tasks` takes them.

    Raises
    ------
    ValueError
        An argument is out of range, or the runs are too short for a rate to be fitted.
    """
    if runs < 1:
        raise ValueError(f"runs must be >= 1, got {runs}")
    gas = disc_gas(side, covered, seed=seed)
    times = np.linspace(0, one_number("duration", duration, positive), SAMPLES)
    undisturbed = simulate(gas, duration, solver="exact", sample=times)
    sizes = [DISPLACEMENTS[number % len(DISPLACEMENTS)] for number in range(runs)]
    errors = simulate_many(
        [_disturbed(gas, size, (seed, number)) for number, size in enumerate(sizes)],
        duration,
        solver="exact",
        sample=times,
        measure=functools.partial(farthest_apart, undisturbed.positions),
        workers=workers,
        cluster=cluster,
        progress=progress,
    )
    hits = hits_in_time(undisturbed)
    partings = (
        Parting(size, growth_rate(hits, error, size), lost_after(hits, error))
        for size, error in zip(sizes, errors, strict=True)
    )
    return Chaos(side * side, covered, seed, tuple(partings))


def displaced(scene: Scene, body: int, by: Vector) -> Scene:
    """Return the scene with one body displaced by a vector, m.

    >>> from lesson_code import Body, Circle
    >>> displaced(Scene([Body(Circle(1.0), position=(1, 2))]), 0, by=(0.5, 0)).bodies[0].position
    (1.5, 2.0)
    """
    bodies = list(scene.bodies)
    (x, y), (dx, dy) = bodies[body].position, by
    bodies[body] = replace(bodies[body], position=(x + dx, y + dy))
    return Scene(bodies, scene.gravity, scene.damping, scene.callbacks)


def farthest_apart(positions: NDArray[np.float64], run: Run) -> NDArray[np.float64]:
    """Return how far a run's farthest body is from given positions, shape (F,), m."""
    apart = np.hypot(*np.moveaxis(run.positions - positions, -1, 0))
    return np.asarray(apart.max(axis=1), dtype=float)


def hits_in_time(run: Run) -> NDArray[np.float64]:
    """Return the average number of collisions per disc of a gas so far, shape (F,)."""
    when = np.sort(run.contacts.time[run.contacts.body_a >= WALLS])
    so_far = np.searchsorted(when, run.times, side="right")
    return 2 * so_far / (len(run.scene.bodies) - WALLS)


def growth_rate(
    hits: NDArray[np.float64], error: NDArray[np.float64], displacement: float
) -> float:
    """Return the growth rate of an error, per collision: the slope of the line through ln error.

    Least squares, through the states whose error is over ten displacements and under a hundredth
    of a diameter.

    Parameters
    ----------
    hits, error : ndarray, shape (F,)
        Collisions of a disc so far, and the error then, m, >= 0.
    displacement : float
        m, > 0.

    Raises
    ------
    ValueError
        There are not two such states with different `hits`.

    Examples
    --------
    An error that doubles with each collision grows by ln 2 = 0.693.

    >>> hits = np.arange(12.0)
    >>> round(growth_rate(hits, 1e-6 * 2**hits, displacement=1e-6), 3)
    0.693
    """
    growing = (error > SETTLED * displacement) & (error < SATURATED)
    if not growing.any() or np.ptp(hits[growing]) == 0:
        raise ValueError("duration must be longer: the runs have not parted enough for a rate")
    slope, _ = np.polyfit(hits[growing], np.log(error[growing]), 1)
    return float(slope)


def lost_after(hits: NDArray[np.float64], error: NDArray[np.float64]) -> float:
    """Return after how many collisions of a disc an error is over a tenth of a diameter.

    >>> lost_after(np.array([0.0, 1.0, 2.0]), np.array([0.01, 0.09, 0.2]))
    2.0
    """
    over = np.flatnonzero(error > LOST)
    return float(hits[over[0]]) if over.size else math.inf


def spread(values: Iterable[float]) -> Spread:
    """Return median and quartiles: the smallest values that a half, a quarter, ... do not exceed.

    >>> spread([4.0, 1.0, 3.0, 2.0])
    Spread(median=2.0, lower_quartile=1.0, upper_quartile=3.0)
    """
    shares = (0.5, 0.25, 0.75)
    return Spread(*np.quantile(list(values), shares, method="inverted_cdf").tolist())


def _disturbed(gas: Scene, size: float, seed: tuple[int, int]) -> Scene:
    """Return a gas with one disc moved by a length, m, both drawn by a seed of its own."""
    draw = np.random.default_rng(seed)
    disc = int(draw.integers(WALLS, len(gas.bodies)))
    x, y = draw.uniform(-1, 1, 2).tolist()  # no sine: its last digit differs between machines
    factor = size / math.sqrt(x * x + y * y)
    return displaced(gas, disc, by=(factor * x, factor * y))


def _plain(values: Spread) -> dict[str, float | None]:
    """Return a spread as JSON can hold it."""
    return {name: value if math.isfinite(value) else None for name, value in asdict(values).items()}


def _written(values: Spread, form: str) -> str:
    """Return a spread as text."""
    median, lower, upper = (
        form.format(value) if math.isfinite(value) else "never"
        for value in (values.median, values.lower_quartile, values.upper_quartile)
    )
    return f"{median} ({lower} to {upper})"
