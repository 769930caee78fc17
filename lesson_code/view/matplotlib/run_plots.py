"""Quantities of a run over time: energy, momentum, impulses, penetration; one run against another.

A quantity that stays the same but for rounding is drawn as a level line: the axis does not zoom in
on the rounding.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any, Literal, TypeAlias

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import FuncFormatter
from numpy.typing import NDArray

from lesson_code.engine.core.run import Run
from lesson_code.view.matplotlib import plots, style

Floats: TypeAlias = NDArray[np.float64]
Quantity: TypeAlias = tuple[Callable[[Run], Floats], str]

TIME = "time, s"

LEAST_RANGE = 0.05
"""Of the largest value on an axis: the axis shows at least so much above and below."""

MOST_BODIES = 5
"""More curves than this, and the total, cannot be told apart."""

LINES: tuple[tuple[str, Any], ...] = (
    (style.BLUE, "-"),
    (style.VERMILION, "--"),
    (style.GREEN, ":"),
    (style.PURPLE, "-."),
    (style.ORANGE, (0, (6, 1, 1, 1, 1, 1))),
)
"""Colour and line of the first, second, ... body."""

SINGLE_STEMS = 60
"""So many impulses get a head each; more stand too close."""

QUANTITIES: dict[str, Quantity] = {
    "energy": (lambda run: run.energy, "energy, J"),
    "kinetic energy": (lambda run: run.kinetic_energy, "kinetic energy, J"),
    "momentum x": (lambda run: run.momentum[:, 0], "momentum along x, kg m/s"),
    "momentum y": (lambda run: run.momentum[:, 1], "momentum along y, kg m/s"),
    "angular momentum": (lambda run: run.angular_momentum, "angular momentum, kg m²/s"),
    "penetration": (lambda run: run.max_penetration, "deepest overlap, m"),
}
"""What runs can be compared in: how it is found, and the label of its axis."""


def energy(ax: Axes, run: Run) -> Axes:
    """Draw the kinetic energy over time, the energy of height, and their sum.

    Without gravity there is only the kinetic energy.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    run : Run
        Its bodies that can be pushed; the energy of height is 0 at the origin.
    """
    if not any(run.scene.gravity):
        return _calm(plots.curves(ax, {"": (run.times, run.energy)}, TIME, "kinetic energy, J"))
    parts = {
        "kinetic": (run.times, run.kinetic_energy),
        "of height": (run.times, run.energy - run.kinetic_energy),
        "total": (run.times, run.energy),
    }
    return _calm(plots.curves(ax, parts, TIME, "energy, J"))


def momentum(
    ax: Axes,
    run: Run,
    *,
    bodies: Iterable[int] | None = None,
    along: Literal["x", "y"] = "x",
    names: Mapping[int, str] | None = None,
) -> Axes:
    """Draw the total momentum over time along x and y, or that of some bodies and the total.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    run : Run
        What happened.
    bodies : iterable of int, optional
        Up to five bodies that can be pushed: the momentum of each and that of all, along one
        axis. None: only the total, along both.
    along : "x" or "y"
        Which axis, where `bodies` are given.
    names : mapping of int to str, optional
        Names of bodies in the legend, by number; without one, "body 0".

    Raises
    ------
    ValueError
        There are more than five bodies, one cannot be pushed, or there is no such axis.
    """
    if bodies is None:
        total = {f"along {c}": (run.times, run.momentum[:, k]) for k, c in enumerate("xy")}
        return _calm(plots.curves(ax, total, TIME, "total momentum, kg m/s"))
    if along not in ("x", "y"):
        raise ValueError(f'along must be "x" or "y", got {along!r}')
    axis, chosen = "xy".index(along), [*bodies]
    if len(chosen) > MOST_BODIES:
        raise ValueError(f"bodies must hold at most {MOST_BODIES} bodies, got {len(chosen)}")
    for n, (color, line) in zip(chosen, LINES, strict=False):
        label = (names or {}).get(n, f"body {n}")
        ax.plot(
            run.times,
            _mass(run, n) * run.velocities[:, n, axis],
            color=color,
            linestyle=line,
            label=label,
        )
    ax.plot(run.times, run.momentum[:, axis], color=style.INK, linewidth=2.5, label="total")
    ax.set(xlabel=TIME, ylabel=f"momentum along {along}, kg m/s")
    ax.legend(frameon=False)
    return _calm(ax)


def impulses(ax: Axes, run: Run, body: int | None = None) -> Axes:
    """Draw the impulses of each step as stems: the sum of the normal ones, and of the tangent ones.

    Tangent impulses are added up by size, whichever way they act.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    run : Run
        What happened.
    body : int, optional
        Only the contacts of this body. None: all contacts.

    Raises
    ------
    ValueError
        There is no such body.
    """
    events = run.contacts
    if body is not None and not 0 <= body < len(run.scene.bodies):
        raise ValueError(
            f"body must be the number of one of {len(run.scene.bodies)} bodies, got {body}"
        )
    chosen = np.ones(len(events), dtype=bool)
    if body is not None:
        chosen = (events.body_a == body) | (events.body_b == body)
    times, steps = np.unique(events.time[chosen], return_inverse=True)
    normal = _sums(steps, events.normal_impulse[chosen], len(times))
    tangent = _sums(steps, np.abs(events.tangent_impulse[chosen]), len(times))
    _stems(ax, times, normal, style.BLUE, "o", "normal")
    if tangent.any():
        _stems(ax, times, tangent, style.VERMILION, "x", "tangent")
    ax.set(xlabel=TIME, ylabel="impulse of a step, N s")
    ax.set_xlim(*_with_room(float(run.times.min()), float(run.times.max())))
    ax.set_ylim(0, 1.08 * max(normal.max(initial=0.0), tangent.max(initial=0.0)) or 1.0)
    ax.legend(frameon=False)
    return ax


def penetration(ax: Axes, run: Run) -> Axes:
    """Draw over time how deep the deepest overlap of any two bodies is.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    run : Run
        What happened.
    """
    return compare(ax, {"": run}, "penetration")


def compare(
    ax: Axes, runs: Mapping[str, Run], quantity: str | Callable[[Run], Any], label: str = ""
) -> Axes:
    """Draw one quantity of up to three runs over time.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    runs : mapping of str to Run
        The runs by name. They may have been recorded at different times.
    quantity : str or callable
        "energy", "kinetic energy", "momentum x", "momentum y", "angular momentum" or
        "penetration"; or a function of a run that returns an array of shape (F,).
    label : str
        What the function returns, with the unit.

    Raises
    ------
    ValueError
        There are no runs or more than three, there is no such quantity, or a function comes
        without a label.

    Examples
    --------
    >>> from lesson_code import Body, Circle, Scene, simulate
    >>> run = simulate(Scene([Body(Circle(1.0), mass=2.0, velocity=(3, 0))]), duration=1)
    >>> _, ax = style.figure()
    >>> compare(ax, {"ours": run}, "momentum x").get_ylabel()
    'momentum along x, kg m/s'
    >>> compare(ax, {"ours": run}, lambda run: run.positions[:, 0, 0], "x, m").get_ylabel()
    'x, m'
    """
    if not runs:
        raise ValueError("runs must hold at least one run, got none")
    measure, label = _quantity(quantity, label)
    curves = {name: (run.times, np.asarray(measure(run))) for name, run in runs.items()}
    plots.curves(ax, curves, TIME, label)
    if quantity == "penetration":
        ax.set_ylim(0, 1.08 * max(float(y.max(initial=0.0)) for _, y in curves.values()) or 1.0)
        return _with_small_lengths(ax)
    return _calm(ax)


def _quantity(quantity: str | Callable[[Run], Any], label: str) -> tuple[Callable[[Run], Any], str]:
    """Return how a quantity is found and the label of its axis."""
    if callable(quantity):
        if not label:
            raise ValueError("label must say what the function returns, with the unit, got none")
        return quantity, label
    if quantity not in QUANTITIES:
        raise ValueError(f"quantity must be one of {', '.join(QUANTITIES)}, got {quantity!r}")
    measure, words = QUANTITIES[quantity]
    return measure, label or words


def _mass(run: Run, n: int) -> float:
    """Return the mass of a body that can be pushed, kg."""
    count = len(run.scene.bodies)
    mass = run.scene.bodies[n].mass if 0 <= n < count else None
    if mass is None:
        raise ValueError(f"bodies must hold numbers of bodies with a mass, got {n}")
    return mass


def _sums(steps: Any, sizes: Floats, count: int) -> Floats:
    """Return the sum of what belongs to each of some steps."""
    return np.bincount(steps, sizes, count).astype(float)


def _stems(ax: Axes, times: Floats, sizes: Floats, color: str, marker: str, name: str) -> None:
    """Draw values as lines that stand on zero, with heads where there is room for them."""
    heads = marker if len(times) <= SINGLE_STEMS else ""
    ax.vlines(times, 0, sizes, color=color, linewidth=1.0, alpha=0.7)
    ax.plot(times, sizes, color=color, linestyle="", marker=heads or ".", markersize=4, label=name)


def _calm(ax: Axes) -> Axes:
    """Let an axis show at least a part of its largest value, so that rounding stays unseen."""
    values = np.concatenate([np.ravel(line.get_ydata()) for line in ax.lines])
    low, high = _with_room(float(values.min()), float(values.max()))
    least = LEAST_RANGE * float(np.abs(values).max()) or 1.0
    ax.set_ylim(min(low, float(values.min()) - least), max(high, float(values.max()) + least))
    return ax


def _with_room(low: float, high: float) -> tuple[float, float]:
    """Return limits a little wider than some values."""
    room = 0.05 * (high - low) or 0.5
    return low - room, high + room


def _with_small_lengths(ax: Axes) -> Axes:
    """Write the lengths on the y axis in the unit that suits them."""
    top = ax.get_ylim()[1]
    for size, unit in ((1.0, "m"), (1e-3, "mm"), (1e-6, "µm"), (1e-9, "nm")):
        if top >= 2 * size or unit == "nm":
            ax.yaxis.set_major_formatter(FuncFormatter(lambda y, _, size=size: f"{y / size:g}"))
            ax.set_ylabel(ax.get_ylabel().removesuffix(", m") + f", {unit}")
            break
    return ax
