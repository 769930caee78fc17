"""What the figures of chapters 08 to 11 say, which run the engine: the same runs in Python."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from lesson_code import Body, Circle, Material, Scene, Segment, simulate
from lesson_code.engine.core.constants import IMPACT_DEPTH, SLOP
from lesson_code.evidence.hard_cases.loads import tower
from lesson_code.evidence.hard_cases.measures import SUNK
from lesson_code.reference.closed_forms import bouncing_ball

from .test_figures_of_chapters import choose, put
from .test_live import opened, seen

if TYPE_CHECKING:
    from pathlib import Path

    from playwright.sync_api import Locator, Page

    from lesson_code.engine.core.run import Run

ERRORS = "ch08_what_accuracy_costs/how_wrong"
TOWER = "ch09_hard_cases/tower"
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


RUBBER = Material(0.8, 0.8)
GROUNDS = {"asphalt": RUBBER, "ice": Material(0.8, 0.0), "sand": Material(0.0, 0.8)}


def thrown_rubber(
    ground: str,
    velocity: tuple[float, float] = (3.0, 0.0),
    spin: float = 0.0,
    balls: int = 1,
    **changed: float,
) -> Run:
    """Return two seconds of the rubber balls; `changed` is a coefficient that all have instead."""
    fixed, free = (replace(material, **changed) for material in (GROUNDS[ground], RUBBER))
    lines = [((-30, 0), (30, 0)), ((5.5, 0), (5.5, 30))]
    bodies = [Body(Segment(*ends), material=fixed) for ends in lines]
    thrown: Any = {"position": (0, 1.6), "velocity": velocity, "angular_velocity": spin}
    moving = (thrown, {"position": (2.6, 0.4)})[:balls]
    bodies += [Body(Circle(0.4), mass=1.0, material=free, **given) for given in moving]
    return simulate(Scene(bodies, gravity=(0, -10)), 2.0, solver="sequential")


def without(figure: Locator, effect: str) -> tuple[str, str]:
    """Return what the figure says of an effect: what the plan does with it, and what changes."""
    found = re.search(rf"Without {effect} \(plan: ([a-z ]+)\) (.*?)\.(?= |$)", seen(figure)[1])
    assert found
    return found[1], found[2]


@pytest.mark.browser
@pytest.mark.parametrize("effect", ["friction", "restitution"])
@pytest.mark.parametrize("ground", [*GROUNDS])
@pytest.mark.parametrize("balls", [1, 2])
def test_effect_left_out_moves_the_balls_as_far_as_in_python(
    page: Page, tmp_path: Path, effect: str, ground: str, balls: int
) -> None:
    """Where the path changes, by so many millimetres; where it does not, by not one bit."""
    figure = opened(page, tmp_path, LEFT_OUT)
    choose(figure, "ground and wall", ground)
    choose(figure, "balls", ["one ball", "two balls"][balls - 1])
    whole = thrown_rubber(ground, balls=balls)
    other = thrown_rubber(ground, balls=balls, **{effect: 0.0})
    way = (whole.positions - other.positions)[:, 2:]
    apart = np.hypot(way[..., 0], way[..., 1]).max()
    said = without(figure, effect)[1]
    if whole.positions.tobytes() == other.positions.tobytes():
        assert said == "not one bit changes"
    else:
        assert said.endswith(f" bits change, up to {apart:.3f} m")


@pytest.mark.browser
@pytest.mark.parametrize("ground", [*GROUNDS])
@pytest.mark.parametrize("balls", [1, 2])
@pytest.mark.parametrize("spin", [0, 5])
def test_plan_of_the_figure_is_that_of_the_engine(
    page: Page, tmp_path: Path, ground: str, balls: int, spin: int
) -> None:
    """And what it leaves out changes no bit."""
    figure = opened(page, tmp_path, LEFT_OUT)
    choose(figure, "ground and wall", ground)
    choose(figure, "balls", ["one ball", "two balls"][balls - 1])
    put(figure, {"spin": spin})
    plan = thrown_rubber(ground, spin=spin, balls=balls).plan
    for effect in ("friction", "rotation", "restitution", "continuous"):
        said, changed = without(figure, effect)
        assert (said == "needed") is plan.effect(effect).used, effect
        assert said == "needed" or changed == "not one bit changes", effect


@pytest.mark.browser
def test_plan_of_the_figure_may_call_for_too_much(page: Page, tmp_path: Path) -> None:
    """Chapter 10, 3: a ball that drops straight down rubs nothing; one that flies askew does."""
    figure = opened(page, tmp_path, LEFT_OUT)
    choose(figure, "ground and wall", "asphalt")
    put(figure, {"along x": 0})
    for effect in ("friction", "rotation", "continuous"):
        assert without(figure, effect) == ("needed", "not one bit changes")
    put(figure, {"along x": 0.1})
    assert " bits change" in without(figure, "friction")[1]
    assert " bits change" in without(figure, "rotation")[1]


@pytest.mark.browser
def test_watch_for_fast_balls_matters_to_a_fast_one(page: Page, tmp_path: Path) -> None:
    """At 60 m/s a ball of 0.8 m makes 1 m in a step: unwatched, it ends beyond the wall."""
    figure = opened(page, tmp_path, LEFT_OUT)
    put(figure, {"along x": 60})
    assert " bits change" in without(figure, "continuous")[1]


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
