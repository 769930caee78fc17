"""What the figures of chapters 08 to 11 say, which run the engine: the same runs in Python."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from lesson_code import Body, Circle, Material, Scene, Segment, simulate
from lesson_code.engine.core.constants import IMPACT_DEPTH, SLOP
from lesson_code.engine.effects.continuous import fastest_way
from lesson_code.evidence.hard_cases.loads import tower
from lesson_code.evidence.hard_cases.measures import SUNK
from lesson_code.formulas import elastic_1d
from lesson_code.reference.closed_forms import bouncing_ball

from .test_figures_of_chapters import choose, put
from .test_live import opened, seen

if TYPE_CHECKING:
    from pathlib import Path

    from playwright.sync_api import Page

ERRORS = "ch08_what_accuracy_costs/how_wrong"
TOWER = "ch09_hard_cases/tower"
FASTEST = "ch10_only_what_the_scene_needs/fastest"
LEFT_OUT = "ch10_only_what_the_scene_needs/left_out"
THROW = "ch11_the_small_engine/throw"


def dropped(solver: str, rate: int, restitution: float, substeps: int) -> float:
    """Return the largest error of a ball that falls 1 m and bounces, at ten times in 2 s."""
    surface = Material(restitution, 0.0)
    floor = Body(Segment((-30, 0), (30, 0)), material=surface)
    ball = Body(Circle(0.5), mass=1.0, position=(0, 1.5), material=surface)
    times = np.linspace(0, 2, 11)
    scene = Scene([floor, ball], gravity=(0, -10))
    run = simulate(scene, 2.0, solver=solver, dt=1 / rate, substeps=substeps, sample=times)
    heights = bouncing_ball(times, 1.0, restitution, 10.0)
    return float(np.abs(run.positions[:, 1, 1] - 0.5 - heights).max())


@pytest.mark.browser
@pytest.mark.parametrize("rate", [20, 60, 240])
@pytest.mark.parametrize(
    ("method", "solver", "substeps"), [("sweeps", "sequential", 1), ("4 sub-steps", "substep", 4)]
)
def test_error_of_a_bouncing_ball_is_that_of_the_run_in_python(
    page: Page, tmp_path: Path, rate: int, method: str, solver: str, substeps: int
) -> None:
    """To the millimetres that are shown."""
    figure = opened(page, tmp_path, ERRORS)
    choose(figure, "method on the left", method)
    put(figure, {"steps a second": rate, "restitution": 0.7})
    assert f"wrong by up to {dropped(solver, rate, 0.7, substeps):.3f} m." in seen(figure)[1]


@pytest.mark.browser
def test_error_of_a_fall_is_that_of_section_3(page: Page, tmp_path: Path) -> None:
    """Too high by g t dt / 2: 10 / rate after 2 s."""
    figure = opened(page, tmp_path, ERRORS)
    choose(figure, "scene", "a fall without an impact")
    for rate in (20, 50, 200):
        put(figure, {"steps a second": rate})
        assert f"wrong by up to {10 / rate:.3f} m." in seen(figure)[1]


@pytest.mark.browser
def test_steps_split_at_impacts_err_alike_at_all_steps(page: Page, tmp_path: Path) -> None:
    """Each of two impacts is taken where the ball stands in the wall by half of its slop.

    It is that much too deep and has to come back as far: the error is the same at every step.
    """
    figure = opened(page, tmp_path, ERRORS)
    choose(figure, "scene", "a ball between two walls")
    choose(figure, "method on the left", "sweeps, steps split at impacts")
    expected = 2 * 2 * IMPACT_DEPTH * SLOP * 1.0  # m; the ball is 1 m wide
    for rate in (15, 60):
        put(figure, {"steps a second": rate})
        assert f"wrong by up to {expected:.3f} m." in seen(figure)[1]


@pytest.mark.browser
@pytest.mark.parametrize(
    ("boxes", "load", "sweeps"), [(1, 50, 10), (1, 1000, 100), (3, 20, 5), (6, 1, 10)]
)
def test_floor_under_a_tower_carries_what_python_says(
    page: Page, tmp_path: Path, boxes: int, load: int, sweeps: int
) -> None:
    """By momentum: what has not become velocity, the floor has taken up. In tenths of a percent."""
    figure = opened(page, tmp_path, TOWER)
    put(figure, {"boxes": boxes, "mass of the load": load, "sweeps": sweeps})
    masses = np.array([1.0] * boxes + [load])
    scene = tower(masses.tolist(), gap=-SUNK)
    run = simulate(scene, 1 / 60, solver="sequential", iterations=sweeps, sample="end")
    fallen = masses @ run.velocities[-1, 1:, 1] * 60 / (10 * masses.sum())
    assert f"the floor carries {100 * (1 + fallen):.1f} % of all the weight" in seen(figure)[1]


@pytest.mark.browser
def test_law_of_sweeps_holds_for_one_box(page: Page, tmp_path: Path) -> None:
    """Chapter 09: of the load's velocity (M / (M + m))^n is left after n sweeps."""
    figure = opened(page, tmp_path, TOWER)
    put(figure, {"mass of the load": 100, "sweeps": 30})
    left = f"{(100 / 101) ** 30:.3f}"
    assert f"{left} is left; " in seen(figure)[1]
    assert f"power of 30 gives {left}." in seen(figure)[1]


@pytest.mark.browser
@pytest.mark.parametrize(("speed", "mass"), [(0.5, 1.0), (3.0, 0.2), (0.1, 10.0)])
def test_bound_is_the_rules_and_the_hit_the_formulas(
    page: Page, tmp_path: Path, speed: float, mass: float
) -> None:
    """`fastest_way` asks for a step of 1 s: the way in it is the speed."""
    figure = opened(page, tmp_path, FASTEST)
    put(figure, {"speed": speed, "mass": mass, "step": 33 if speed < 1 else 1})
    heavy = Body(Circle(0.5), mass=100.0, position=(-1, 0), velocity=(speed, 0))
    bound, _ = fastest_way(Scene([heavy, Body(Circle(0.1), mass=mass)]), 1.0)
    words = seen(figure)[1]
    assert f"the light ball {elastic_1d(100, speed, mass, 0)[1]:.2f} m/s;" in words
    assert f"faster than {bound:.2f} m/s" in words
    assert ("nobody has to be watched" in words) == (
        1.5 * bound * (0.033 if speed < 1 else 0.001) <= 0.1
    )


def two_discs(
    velocity: tuple[float, float] = (5.0, 0.0),
    gravity: float = 10.0,
    restitution: float = 0.8,
    floor: float = 0.4,
    discs: float = 0.0,
) -> Any:
    """Return the places of both discs of the figure, as Python steps them."""
    fixed, free = Material(restitution, floor), Material(restitution, discs)
    lines = [((-30, 0), (30, 0)), ((5.5, 0), (5.5, 30))]
    bodies = [Body(Segment(*ends), material=fixed) for ends in lines]
    bodies.append(Body(Circle(0.4), mass=1.0, position=(0, 1.6), velocity=velocity, material=free))
    bodies.append(Body(Circle(0.4), mass=1.0, position=(2.6, 0.4), material=free))
    run = simulate(Scene(bodies, gravity=(0, -gravity)), 2.0, solver="sequential")
    return run.positions[:, 2:]


@pytest.mark.browser
@pytest.mark.parametrize(
    ("effect", "without"),
    [
        ("gravity", {"gravity": 0.0}),
        ("restitution", {"restitution": 0.0}),
        ("friction", {"floor": 0.0, "discs": 0.0}),
    ],
)
def test_effect_left_out_moves_the_discs_as_far_as_in_python(
    page: Page, tmp_path: Path, effect: str, without: dict[str, float]
) -> None:
    """Rough discs: all three are called for, and change the paths by so many millimetres."""
    figure = opened(page, tmp_path, LEFT_OUT)
    put(figure, {"friction of the discs": 0.5})
    choose(figure, "leave out", effect)
    way = two_discs(discs=0.5) - two_discs(**({"discs": 0.5} | without))
    apart = np.hypot(way[..., 0], way[..., 1]).max()
    assert f"without {effect}: up to {apart:.3f} m apart." in seen(figure)[1]


@pytest.mark.browser
@pytest.mark.parametrize(
    ("numbers", "named"),
    [
        ({}, "leave out friction or rotation or continuous changes no bit"),
        ({"friction of the discs": 0.5}, "leave out continuous changes no bit"),
        ({"friction of floor": 0}, "leave out friction or rotation or continuous changes no bit"),
        ({"spin": 5}, "leave out friction or continuous changes no bit"),
        ({"gravity": 0}, "leave out gravity or friction or rotation or continuous"),
        ({"along x": 60}, "leave out friction or rotation changes no bit"),
    ],
)
def test_what_can_be_left_out_is_what_the_rules_say(
    page: Page, tmp_path: Path, numbers: dict[str, float], named: str
) -> None:
    """Chapter 10, 3: a pair rubs if both do, smooth discs do not turn, slow ones pass nothing."""
    figure = opened(page, tmp_path, LEFT_OUT)
    put(figure, numbers)
    assert named in seen(figure)[1]


@pytest.mark.browser
@pytest.mark.parametrize(("e", "mu", "spin"), [(0.8, 0.4, 15), (0.5, 0.1, -20), (0.2, 0.9, 30)])
def test_throw_leaves_the_floor_as_in_python(
    page: Page, tmp_path: Path, e: float, mu: float, spin: float
) -> None:
    """The first bounce lies before 0.7 s, the second after it."""
    figure = opened(page, tmp_path, THROW)
    put(figure, {"restitution": e, "friction": mu, "spin": spin})
    rough = Material(e, mu)
    moving = {"position": (0, 2), "velocity": (1.5, 0), "angular_velocity": spin}
    disc = Body(Circle(0.3), mass=1.0, material=rough, **moving)
    scene = Scene([Body(Segment((-90, 0), (90, 0)), material=rough), disc], gravity=(0, -9.81))
    run = simulate(scene, 0.7, solver="sequential", sample="end")
    vx, w = run.velocities[-1, 1, 0], run.angular_velocities[-1, 1]
    words = seen(figure)[1].replace("\N{MINUS SIGN}", "-")
    assert f"first bounce makes {vx:.2f} m/s along the floor and {w:.1f} rad/s" in words
