"""A world that a page makes of a description, against the one that Python makes of a scene."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
import tiers
from every_scene import DT, SCENES

from lesson_code import Body, Circle, Material, Polygon, Scene, Segment
from lesson_code.engine.compiled import as_arrays
from lesson_code.view.browser import programs

from .test_programs import STEPPED, STEPS, as_text, at_work, source_of

if TYPE_CHECKING:
    from playwright.sync_api import Page

WORLD = programs.LOADER.with_name("world.js")

PAGE = """
async ([loader, maker, program, ...given]) => {
    const bytes = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    const text = (buffer) =>
        Array.from(new Uint8Array(buffer), (byte) => String.fromCharCode(byte)).join("");
    const { load } = await import("data:text/javascript;base64," + loader);
    const { scene } = await import("data:text/javascript;base64," + maker);
    const lesson = await load(bytes(program));
    LINES
}
"""
"""In the page: loads both modules and a program; what follows uses them."""

SET_UP = """
    const world = scene(lesson, given[0]);
    const { buffer } = lesson.exports.memory;
    const rows = ({ name, address, length, bytes }) =>
        [name, text(buffer.slice(address, address + length * bytes))];
    return Object.fromEntries(lesson.tables.map(rows));
"""
"""Returns the tables as they are before the first step."""

STATES = """
    const states = () => text(Float64Array.from(
        world.bodies.flatMap(({ x, y, angle, vx, vy, w }) => [x, y, angle, vx, vy, w])).buffer);
    const impulses = () => text(Float64Array.from(
        world.impulses.flatMap((row) => Object.values(row))).buffer);
"""


def in_page(page: Page, solver: str, lines: str, *given: Any) -> Any:
    """Run lines in a page, which have a solver's program as `lesson`."""
    files = [file.read_bytes() for file in (programs.LOADER, WORLD, programs.file_of(solver))]
    return page.evaluate(PAGE.replace("LINES", lines), [*map(as_text, files), *given])


def described(scene: Scene, solver: str) -> dict[str, Any]:
    """Return a scene as a page is given it, to be stepped as `at_work` does."""
    return {
        "bodies": [body_described(body) for body in scene.bodies],
        "gravity": list(scene.gravity),
        "damping": scene.damping,
        "dt": DT,
        "iterations": 4,
        "substeps": 1 if solver == "sequential" else 2,
    }


def body_described(body: Body) -> dict[str, Any]:
    """Return a body as a page is given it; what is left out in Python is left out here."""
    shape = body.shape
    told: dict[str, Any] = {
        "position": list(body.position),
        "angle": body.angle,
        "velocity": list(body.velocity),
        "angular_velocity": body.angular_velocity,
        "mass": body.mass,
        "inertia": body.inertia if body.inertia == math.inf else None,
        "restitution": body.material.restitution,
        "friction": body.material.friction,
    }
    if isinstance(shape, Circle):
        told["circle"] = shape.radius
    elif isinstance(shape, Segment):
        told |= {"segment": [list(shape.start), list(shape.end)], "radius": shape.radius}
    else:
        told["polygon"] = [list(corner) for corner in shape.outline]
    return {name: value for name, value in told.items() if value is not None}


def require_same_tables(
    page: Page,
    lend_functions: Callable[[], None],
    scene: Scene,
    told: dict[str, Any],
    solver: str,
) -> None:
    """Hold a page to make the tables that Python makes, to the last bit."""
    expected = as_arrays(at_work(scene, solver).world, source_of(solver))._asdict()
    lend_functions()
    got = in_page(page, solver, SET_UP, told)
    for name, table in expected.items():
        rows = np.frombuffer(got[name].encode("latin-1"), np.asarray(table).dtype)
        assert len(rows) == len(np.atleast_1d(table)), name
        for field in rows.dtype.names or ():
            if field not in ("mass", "inertia"):  # what a page alone is given
                assert rows[field].tobytes() == np.atleast_1d(table)[field].tobytes(), (name, field)


@pytest.mark.one_in(6)
@pytest.mark.parametrize("solver", STEPPED)
@pytest.mark.parametrize("build", SCENES.values(), ids=SCENES)
def test_tables_that_a_page_makes_have_the_bits_of_python(
    page: Page, lend_functions: Callable[[], None], build: Callable[[], Scene], solver: str
) -> None:
    """All fields of all tables, of every scene of the catalogue."""
    scene = build()
    require_same_tables(page, lend_functions, scene, described(scene, solver), solver)


@pytest.mark.parametrize("seed", range(tiers.share(30)))
def test_tables_of_shapes_that_are_drawn_have_the_bits_of_python(
    page: Page, lend_functions: Callable[[], None], seed: int
) -> None:
    """Sizes from a micrometre to a thousand kilometres; polygons seen from anywhere."""
    rng = np.random.default_rng(seed)
    bodies, corners = [], []
    for _ in range(int(rng.integers(1, 60))):
        size = 10.0 ** rng.uniform(-6, 6)
        count = int(rng.integers(3, 9))
        angles = (np.arange(count) + rng.uniform(0.1, 0.7, count)) * (2 * math.pi / count)
        around = np.stack([np.cos(angles), np.sin(angles)], axis=-1) * rng.uniform(0.5, 2, 2)
        outline = size * (around + rng.choice([0.0, 1.0]) * rng.normal(size=2))
        end = size * rng.normal(size=2)
        shapes = (Circle(size), Polygon(outline), Segment(-end, end, rng.choice([0.0, 0.2]) * size))
        kind = int(rng.integers(3))
        corners.append(outline.tolist() if kind == 1 else None)
        x, y, vx, vy, angle, w = rng.normal(size=6) * 10.0 ** rng.uniform(-3, 3)
        mass = rng.choice([10.0 ** rng.uniform(-3, 3), math.inf], p=[0.8, 0.2])
        body = Body(
            shapes[kind], position=(x, y), velocity=(vx, vy), angle=angle, angular_velocity=w,
            mass=mass, material=Material(rng.uniform(), rng.uniform()),
        )  # fmt: skip
        bodies.append(body)
    scene = Scene(bodies, gravity=rng.normal(size=2), damping=0.1)
    told = described(scene, "sequential")
    for body, outline in zip(told["bodies"], corners, strict=True):
        if outline is not None:
            body["polygon"] = outline  # as it was before Python saw it from its centroid
    require_same_tables(page, lend_functions, scene, told, "sequential")


@pytest.mark.one_in(9)
@pytest.mark.parametrize("solver", STEPPED)
@pytest.mark.parametrize("build", SCENES.values(), ids=SCENES)
def test_world_of_a_page_steps_as_in_python(
    page: Page, lend_functions: Callable[[], None], build: Callable[[], Scene], solver: str
) -> None:
    """States after all steps and the impulses of the last; and again from a state in between.

    The program has been used before, for another scene.
    """
    scene = build()
    lines = f"""
        scene(lesson, given[1]).step(9);
        const world = scene(lesson, given[0]);
        {STATES}
        world.step({STEPS // 2});
        const middle = world.save();
        world.step({STEPS // 2});
        const first = [states(), impulses()];
        world.step(3);
        world.restore(middle);
        world.step({STEPS // 2});
        return [...first, states(), impulses(), world.time];
    """
    run = at_work(scene, solver)
    run.advance(STEPS - 1)
    before = len(run.events())
    run.advance(1)
    other = described(SCENES["mixed heap"](), solver)
    lend_functions()
    states, impulses, *again, time = in_page(page, solver, lines, described(scene, solver), other)
    assert states.encode("latin-1") == run.states().tobytes()
    assert impulses.encode("latin-1") == run.events()[before:].tobytes()
    assert again == [states, impulses]
    assert time == STEPS * DT


def test_mixing_rule_and_coefficients_left_out_are_those_of_python(page: Page) -> None:
    """By their names."""
    combine = {"restitution": "max", "friction": "mean"}
    told = {"bodies": [{"circle": 1, "mass": 2}], "combine": combine}
    lines = """
        const { state, bodies } = scene(lesson, given[0]);
        const [{ restitution, friction, inv_m, inv_i }] = bodies;
        return [state.restitution_rule, state.friction_rule, restitution, friction, inv_m, inv_i];
    """
    rules = [1, 4]  # MAX and MEAN
    assert in_page(page, "sequential", lines, told) == [*rules, -1, -1, 0.5, 1.0]


BOX = [[0, 0], [1, 0], [1, 1], [0, 1]]


@pytest.mark.parametrize(
    ("told", "words"),
    [
        ({"gravity": [0]}, "gravity must be [x, y], got [0]"),
        ({"dt": 0}, "dt must be > 0, got 0"),
        ({"damping": -1}, "damping must be >= 0, got -1"),
        ({"iterations": 1.5}, "iterations must be a whole number > 0, got 1.5"),
        (
            {"combine": {"friction": "most"}},
            "combine.friction must be one of min, max, product, geometric_mean, mean, got most",
        ),
        (
            {"bodies": [{"mass": 1}]},
            "bodies[0].shape must be one of circle, polygon, segment, got none",
        ),
        (
            {"bodies": [{"circle": 1, "polygon": BOX}]},
            "bodies[0].shape must be one of circle, polygon, segment, got circle and polygon",
        ),
        ({"bodies": [{"circle": -1}]}, "bodies[0].circle must be > 0, got -1"),
        ({"bodies": [{"circle": 1, "mass": 0}]}, "bodies[0].mass must be > 0, got 0"),
        (
            {"bodies": [{"circle": 1}, {"circle": 1, "restitution": 1.1}]},
            "bodies[1].restitution must lie between 0 and 1, got 1.1",
        ),
        (
            {"bodies": [{"segment": [[0, 0], [0, 0]]}]},
            "bodies[0].segment must be two ends [x, y] that differ, got [[0,0],[0,0]]",
        ),
        (
            {"bodies": [{"circle": 1}, {"polygon": BOX[::-1]}]},
            "bodies[1]: polygon must be convex, with its corners counter-clockwise",
        ),
        (
            {"bodies": [{"segment": [[0, 0], [1, 0]], "mass": 1}]},
            "bodies[0]: segment with a mass must be centred on its body's position (end = -start)",
        ),
        (
            {"bodies": [{"circle": 1, "mass": 1e-310}]},
            "bodies[0]: mass must be such that 1 / mass and 1 / inertia are numbers",
        ),
    ],
)
def test_description_that_is_no_scene_is_refused_by_name(
    page: Page, told: dict[str, Any], words: str
) -> None:
    """Argument, rule and value."""
    lines = "try { scene(lesson, given[0]); } catch (error) { return error.message; }"
    assert in_page(page, "sequential", lines, told) == words


def test_polygon_that_crosses_itself_is_refused(page: Page) -> None:
    """A pentagram turns the same way at every corner."""
    star = [[math.cos(0.8 * math.pi * k), math.sin(0.8 * math.pi * k)] for k in range(5)]
    lines = "try { scene(lesson, given[0]); } catch (error) { return error.message; }"
    assert "must be convex" in in_page(page, "sequential", lines, {"bodies": [{"polygon": star}]})
