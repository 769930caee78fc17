"""Quantities over time: the curves are those of the run, and rounding is not drawn as physics."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from lesson_code import Body, Circle, Run, Scene, Segment, simulate
from lesson_code.view.matplotlib import run_plots, style

READABLE: Any = Callable[[Figure], None]
UP = (0.0, 1.0)
TIMES = [0.0, 0.1, 0.2]


@pytest.fixture
def ax() -> Axes:
    """Return empty axes."""
    return style.figure()[1]  # type: ignore[no-any-return]


@pytest.fixture
def pair(run_of: Any) -> Run:
    """Return bodies of 2 kg and 3 kg that swap 6 kg m/s along x, without gravity."""
    scene = Scene([Body(Circle(1.0), mass=2.0), Body(Circle(1.0), mass=3.0)])
    run: Run = run_of(
        scene,
        TIMES,
        np.zeros((3, 2, 2)),
        velocities=[[(3, 0), (0, 1)], [(0, 0), (2, 1)], [(0, 0), (2, 1)]],
        contacts=[
            (0.1, 0, 1, (0, 0), UP, 2.0, -1.5),
            (0.1, 0, 1, (0, 0), UP, 3.0, 0.5),
            (0.2, 0, 1, (0, 0), UP, 4.0, 0.0),
        ],
    )
    return run


@pytest.fixture
def fall(run_of: Any) -> Run:
    """Return 2 kg that fall from 4 m to 2 m with g = 10 m/s^2, beside a static disc."""
    scene = Scene([Body(Circle(1.0), mass=2.0), Body(Circle(1.0))], gravity=(0, -10))
    run: Run = run_of(
        scene,
        [0.0, 1.0],
        [[(0, 4), (9, 9)], [(0, 2), (9, 9)]],
        velocities=[[(0, 0), (0, 0)], [(0, -3), (0, 0)]],
    )
    return run


def curves(ax: Axes) -> dict[str, list[float]]:
    """Return the heights of each named curve."""
    return {str(line.get_label()): np.asarray(line.get_ydata()).tolist() for line in ax.lines}


def test_energy_is_that_of_motion_that_of_height_and_the_total(ax: Axes, fall: Run) -> None:
    """2 kg at 4 m have 80 J of height; at 2 m and 3 m/s they have 40 J and 9 J."""
    assert run_plots.energy(ax, fall) is ax
    assert curves(ax) == {"kinetic": [0, 9], "of height": [80, 40], "total": [80, 49]}
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("time, s", "energy, J")


def test_energy_without_gravity_is_kinetic_energy_alone(ax: Axes, pair: Run) -> None:
    """Half of m v^2: 9 + 1.5 J, then 6 + 1.5 J."""
    run_plots.energy(ax, pair)
    assert [*curves(ax).values()] == [[10.5, 7.5, 7.5]]
    assert ax.get_ylabel() == "kinetic energy, J"
    assert ax.get_legend() is None


def test_total_momentum_is_drawn_along_both_axes(ax: Axes, pair: Run) -> None:
    """6 kg m/s along x and 3 along y, before and after."""
    run_plots.momentum(ax, pair)
    assert curves(ax) == {"along x": [6, 6, 6], "along y": [3, 3, 3]}


def test_momentum_of_bodies_is_drawn_with_the_total(ax: Axes, pair: Run) -> None:
    """What one loses the other gains, each with its own line and name."""
    run_plots.momentum(ax, pair, bodies=[0, 1], names={0: "A"})
    assert curves(ax) == {"A": [6, 0, 0], "body 1": [0, 6, 6], "total": [6, 6, 6]}
    assert len({line.get_linestyle() for line in ax.lines[:2]}) == 2
    assert ax.get_ylabel() == "momentum along x, kg m/s"


def test_momentum_along_y(ax: Axes, pair: Run) -> None:
    """The other axis."""
    run_plots.momentum(ax, pair, bodies=[1], along="y")
    assert curves(ax) == {"body 1": [3, 3, 3], "total": [3, 3, 3]}


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"bodies": [2]}, "bodies with a mass, got 2"),
        ({"bodies": [-1]}, "bodies with a mass, got -1"),
        ({"bodies": range(6)}, "at most 5 bodies, got 6"),
        ({"bodies": [0], "along": "z"}, 'along must be "x" or "y"'),
    ],
)
def test_momentum_of_what_has_none_is_refused(
    ax: Axes, pair: Run, options: Any, message: str
) -> None:
    """The message says what is right."""
    with pytest.raises(ValueError, match=message):
        run_plots.momentum(ax, pair, **options)


def test_momentum_of_a_static_body_is_refused(ax: Axes, fall: Run) -> None:
    """It has no mass to speak of."""
    with pytest.raises(ValueError, match="bodies with a mass, got 1"):
        run_plots.momentum(ax, fall, bodies=[1])


def test_impulses_of_a_step_are_added_up(ax: Axes, pair: Run) -> None:
    """2 + 3 N s along normals and 1.5 + 0.5 N s along tangents in the first step, then 4 and 0."""
    run_plots.impulses(ax, pair)
    assert curves(ax) == {"normal": [5, 4], "tangent": [2, 0]}
    assert ax.lines[0].get_xdata().tolist() == [0.1, 0.2]  # type: ignore[union-attr]
    markers = [line.get_marker() for line in ax.lines]
    assert len(set(markers)) == 2


def test_impulses_of_a_body_are_those_of_its_contacts(ax: Axes, run_of: Any) -> None:
    """Whether it is a or b in them."""
    contacts = [(0.1, a, b, (0, 0), UP, jn, 0.0) for a, b, jn in ((0, 1, 1), (1, 2, 2), (0, 2, 4))]
    scene = Scene([Body(Circle(1.0), mass=1.0)] * 3)
    run = run_of(scene, TIMES, np.zeros((3, 3, 2)), contacts=contacts)
    run_plots.impulses(ax, run, body=1)
    assert curves(ax) == {"normal": [3]}


def test_run_without_contact_has_no_impulses(ax: Axes, fall: Run) -> None:
    """The axes stand there all the same, over the time of the run."""
    run_plots.impulses(ax, fall)
    assert curves(ax) == {"normal": []}
    low, high = ax.get_xlim()
    assert low < 0 < 1 < high


@pytest.mark.parametrize("body", [-1, 2])
def test_impulses_of_no_body_are_refused(ax: Axes, pair: Run, body: int) -> None:
    """The message says how many there are."""
    with pytest.raises(ValueError, match=f"one of 2 bodies, got {body}"):
        run_plots.impulses(ax, pair, body)


@pytest.mark.parametrize(
    ("radius", "unit", "shown"), [(1.0, "mm", "100"), (1e-3, "µm", "100"), (100.0, "m", "10")]
)
def test_penetration_is_drawn_in_the_unit_that_suits_it(
    ax: Axes, run_of: Any, radius: float, unit: str, shown: str
) -> None:
    """Two equal discs whose overlap is a tenth of their radius, in three sizes."""
    scene = Scene([Body(Circle(radius), mass=1.0)] * 2)
    run = run_of(scene, [0.0, 1.0], [[(0, 0), (3 * radius, 0)], [(0, 0), (1.9 * radius, 0)]])
    run_plots.penetration(ax, run)
    assert ax.get_ylabel() == f"deepest overlap, {unit}"
    assert [*curves(ax).values()] == [pytest.approx([0, 0.1 * radius])]
    assert ax.yaxis.get_major_formatter()(0.1 * radius, 0) == shown


def test_run_without_overlap_has_a_level_penetration(ax: Axes, fall: Run) -> None:
    """At zero, on an axis that begins there."""
    run_plots.penetration(ax, fall)
    assert [*curves(ax).values()] == [[0, 0]]
    assert ax.get_ylim()[0] == 0


@pytest.mark.parametrize(
    ("quantity", "expected", "label"),
    [
        ("energy", [80, 49], "energy, J"),
        ("kinetic energy", [0, 9], "kinetic energy, J"),
        ("momentum x", [0, 0], "momentum along x, kg m/s"),
        ("momentum y", [0, -6], "momentum along y, kg m/s"),
        ("angular momentum", [0, 0], "angular momentum, kg m²/s"),
        ("penetration", [0, 0], "deepest overlap"),
    ],
)
def test_runs_are_compared_in_a_quantity_by_name(
    ax: Axes, fall: Run, quantity: str, expected: list[float], label: str
) -> None:
    """Two runs, two lines that can be told apart where they agree."""
    run_plots.compare(ax, {"ours": fall, "theirs": fall}, quantity)
    assert curves(ax) == {"ours": expected, "theirs": expected}
    assert ax.get_ylabel().startswith(label)
    assert ax.lines[0].get_linestyle() != ax.lines[1].get_linestyle()


def test_runs_are_compared_in_what_a_function_returns(ax: Axes, fall: Run) -> None:
    """With its own label."""
    run_plots.compare(ax, {"ours": fall}, lambda run: run.positions[:, 0, 1], "height, m")
    assert curves(ax) == {"ours": [4, 2]}
    assert ax.get_ylabel() == "height, m"


@pytest.mark.parametrize(
    ("count", "quantity", "message"),
    [
        (0, "energy", "runs must hold at least one run"),
        (4, "energy", "at most 3 curves"),
        (1, "entropy", "quantity must be one of energy, kinetic energy"),
        (1, lambda run: run.times, "label must say"),
    ],
    ids=["none", "too many", "unknown", "without a label"],
)
def test_bad_comparisons_are_refused(
    ax: Axes, fall: Run, count: int, quantity: Any, message: str
) -> None:
    """The message says what is right."""
    with pytest.raises(ValueError, match=message):
        run_plots.compare(ax, {str(n): fall for n in range(count)}, quantity)


@pytest.mark.parametrize("value", [6.0, -6e9, 6e-9])
def test_rounding_of_a_constant_is_drawn_as_a_level_line(
    ax: Axes, run_of: Any, value: float
) -> None:
    """The axis shows at least a twentieth of the value above and below, not 1e-15 of it."""
    scene = Scene([Body(Circle(1.0), mass=1.0)])
    velocities = [[(value, 0)], [(value * (1 + 1e-15), 0)]]
    run = run_of(scene, [0.0, 1.0], np.zeros((2, 1, 2)), velocities=velocities)
    run_plots.compare(ax, {"": run}, "momentum x")
    low, high = ax.get_ylim()
    assert low < value - 0.04 * abs(value) < value + 0.04 * abs(value) < high


def test_axis_of_nothing_has_a_range(ax: Axes, run_of: Any) -> None:
    """A quantity that is zero throughout stands in the middle."""
    run = run_of(Scene([Body(Circle(1.0), mass=1.0)]), TIMES, np.zeros((3, 1, 2)))
    run_plots.energy(ax, run)
    low, high = ax.get_ylim()
    assert low == -high < 0


def test_no_word_is_cut_or_written_over_another(assert_texts_are_clear: READABLE) -> None:
    """All of them side by side, from a ball that bounces."""
    ball = Body(Circle(0.5), position=(0, 2), velocity=(1, 0), mass=1.0)
    run = simulate(Scene([ball, Body(Segment((-5, 0), (5, 0)))], gravity=(0, -9.81)), 1.0)
    figure, (a, b, c, d) = style.figure(4, width=14, height=3.4)
    run_plots.energy(a, run)
    run_plots.momentum(b, run)
    run_plots.impulses(c, run)
    run_plots.penetration(d, run)
    assert_texts_are_clear(figure)
