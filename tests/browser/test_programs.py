"""The lesson's functions in Chromium, against the same functions in Python: the same bits."""

from __future__ import annotations

import base64
import math
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
import tiers
from every_scene import DT, SCENES

from lesson_code import Body, Circle, MixingRule, Scene
from lesson_code.engine.any_scene import stages_for_any_scene
from lesson_code.engine.compiled import as_arrays
from lesson_code.engine.compiled.arrays import row_kinds
from lesson_code.engine.core.frames import Frames
from lesson_code.engine.core.rows import World
from lesson_code.engine.effects.choice import names_used
from lesson_code.engine.event_driven import ExactSolver
from lesson_code.engine.event_driven.rows import Tables
from lesson_code.engine.event_driven.solver import why_not
from lesson_code.engine.event_driven.tables import exact_arrays_of
from lesson_code.engine.solvers import our_solvers
from lesson_code.engine.stepper import EngineStepper
from lesson_code.formulas.validation import (
    VECTOR_RULES,
    equation,
    mass,
    non_negative,
    polygon_vertices,
    positive,
    unit_interval,
    unit_vector,
)
from lesson_code.geometry.rows import Corner, ManifoldRow
from lesson_code.view.browser import programs
from lesson_code.view.browser.programs.formulas import with_doors
from lesson_code.view.browser.programs.geometry import (
    AxisRow,
    FoundRow,
    Pair,
    ShapeRow,
    look,
    look_ahead,
)

if TYPE_CHECKING:
    from playwright.sync_api import Page

STEPPED = [name for name in programs.names() if "capacity" in programs.program(name).about]
"""The programs that make steps: each has the name of its solver."""

DRAWN = tiers.share(10_000)

PAGE = """
async ([script, program, ...given]) => {
    const bytes = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    const text = (buffer) =>
        Array.from(new Uint8Array(buffer), (byte) => String.fromCharCode(byte)).join("");
    const { load } = await import("data:text/javascript;base64," + script);
    const program_bytes = bytes(program);
    LINES
}
"""
"""In the page: loads program.js; what follows uses it. Bytes come and go as text."""

CALL_ALL = """
    const lesson = await load(program_bytes);
    const [name, taken] = given;
    const numbers = new Float64Array(bytes(taken).buffer);
    const kinds = lesson.about.functions[name].map(([, kind]) => kind);
    const results = [];
    let place = 0;
    const next = {
        number: () => numbers[place++],
        vector: () => [numbers[place++], numbers[place++]],
        polygon: () => Array.from({ length: numbers[place++] }, next.vector),
    };
    while (place < numbers.length) results.push(lesson[name](...kinds.map((kind) => next[kind]())));
    return text(Float64Array.from(results.flat()).buffer);
"""
"""Calls a function with all that was drawn, and returns its results."""

MAKE_STEPS = """
    const [tables, steps] = given;
    const world = await load(program_bytes);
    for (const table of world.tables) {
        const [rows, content] = tables[table.name];
        table.resize(rows);
        new Uint8Array(world.exports.memory.buffer, table.address).set(bytes(content));
    }
    const impulses = [];
    world.advance(steps, (record, count) => {
        for (let k = 0; k < count; k++) {
            const row = record.at(k);
            for (const field in row) if (field !== "place") impulses.push(row[field]);
        }
    });
    const bodies = Array.from({ length: world.bodies.length }, (_, k) => world.bodies.at(k));
    const states = bodies.flatMap(({ x, y, angle, vx, vy, w }) => [x, y, angle, vx, vy, w]);
    const { steps_done, time, contact_count, memory_count, dt_before } = world.state;
    return [
        text(Float64Array.from(states).buffer),
        text(Float64Array.from(impulses).buffer),
        { steps_done, time, contact_count, memory_count, dt_before },
    ];
"""
"""Steps a world with its own tables, and returns states, impulses and counts."""


def in_page(page: Page, name: str, lines: str, *given: Any) -> Any:
    """Run lines in a page, which load a program by its name."""
    files = programs.LOADER.read_bytes(), programs.file_of(name).read_bytes()
    return page.evaluate(PAGE.replace("LINES", lines), [*map(as_text, files), *given])


def as_text(content: bytes) -> str:
    """Return bytes as a page can be given them."""
    return base64.b64encode(content).decode()


def drawn(rule: Any, rng: np.random.Generator) -> Any:
    """Return a value that a rule lets pass: of any size, and now and then on its edge."""
    if rule is unit_vector:
        angle = rng.choice([rng.uniform(-4, 4), 0.0, math.pi / 2])
        return np.array([math.cos(angle), math.sin(angle)])
    if rule in VECTOR_RULES:
        return rng.normal(size=2) * 10.0 ** rng.integers(-3, 4)
    if rule is unit_interval:
        return float(rng.choice([rng.uniform(), 0.0, 1.0], p=[0.8, 0.1, 0.1]))
    if rule in (mass, positive):
        return float(10.0 ** rng.uniform(-3, 3))
    if rule is non_negative:
        return float(rng.choice([10.0 ** rng.uniform(-3, 3), 0.0], p=[0.9, 0.1]))
    if rule is polygon_vertices:
        angles = np.sort(rng.uniform(0, 2 * math.pi, rng.integers(3, 12)))
        around = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
        return (around * rng.uniform(0.5, 2, (len(angles), 1)) + rng.normal(size=2)).tolist()
    return float(rng.choice([rng.normal() * 10.0 ** rng.integers(-3, 4), 0.0], p=[0.9, 0.1]))


def fitting(name: str, values: dict[str, Any], rng: np.random.Generator) -> dict[str, Any]:
    """Return arguments that fit each other, which a rule for one alone cannot see."""
    if "knt" in values:
        values["knt"] = rng.uniform(-0.99, 0.99) * math.sqrt(values["knn"] * values["ktt"])
    if name == "effective_mass":
        values["inv_m_a"] += 1e-3
    if name == "restitution_1d" and values["v1"] == values["v2"]:
        values["v1"] += 1.0
    if name == "rest_time" and values["restitution"] == 1:
        values["restitution"] = 0.5
    if "m2" in values and rng.uniform() < 0.1:
        values["m2"] = math.inf
    return values


def numbers_of(value: Any) -> list[float]:
    """Return an argument as the numbers that the page reads it from."""
    if isinstance(value, list):
        return [len(value), *np.ravel(value)]
    return np.ravel(value).tolist()


@pytest.mark.one_in(7)
@pytest.mark.parametrize("name", with_doors())
def test_formula_in_a_page_has_the_bits_of_python(page: Page, name: str) -> None:
    """For 10,000 arguments, by the equation behind the door."""
    formula = with_doors()[name]
    rng = np.random.default_rng(sum(name.encode()))
    taken: list[float] = []
    expected: list[float] = []
    with np.errstate(over="ignore"):
        for _ in range(DRAWN):
            values = {argument: drawn(rule, rng) for argument, rule in formula.rules.items()}
            values = fitting(name, values, rng)
            for value in values.values():
                taken += numbers_of(value)
            expected += np.ravel(equation(formula)(**values)).tolist()
    got = in_page(page, "formulas", CALL_ALL, name, as_text(np.array(taken).tobytes()))
    results = np.frombuffer(got.encode("latin-1"))
    assert len(results) == len(expected) >= DRAWN
    assert results.tobytes() == np.array(expected).tobytes()


@pytest.mark.parametrize(
    ("call", "words"),
    [
        ("reflect([1, 2])", "normal must be [x, y], got undefined"),
        ("reflect([1, 2, 3], [0, 1])", "incident must be [x, y], got [1,2,3]"),
        ("disc_inertia('1', 2)", 'mass must be a number, got "1"'),
        ("disc_inertia(NaN, 2)", "mass must be a number, got null"),
        ("disc_inertia(1, 2, 3)", "disc_inertia takes 2 arguments, got 3"),
        (
            "polygon_area([[0, 0], [1, 0]])",
            "vertices must be a list of at least three corners [x, y], got [[0,0],[1,0]]",
        ),
    ],
)
def test_call_with_a_wrong_argument_is_refused_by_name(page: Page, call: str, words: str) -> None:
    """In the page too: argument, rule and value."""
    lines = f"const lesson = await load(program_bytes); try {{ lesson.{call}; }}"
    caught = " catch (error) { return error.message; }"
    assert in_page(page, "formulas", lines + caught) == words


def test_page_opened_from_a_folder_has_its_program_in_it(
    page: Page, faults: list[str], tmp_path: Path
) -> None:
    """Nothing is asked for, and a second program of the page has a memory of its own."""
    lines = """
        const [lesson, other] = [await open_program(), await open_program()];
        const reflected = lesson.reflect([3, -4], [0, 1]);
        document.body.textContent = [reflected, other.disc_inertia(4, 0.5)].flat().join(" ");
    """
    script = programs.script_with("formulas", lines)
    html = f'<!doctype html><title>A page</title><body><script type="module">{script}</script>'
    file = tmp_path / "page.html"
    file.write_text(html, encoding="utf-8")
    page.goto(file.as_uri())
    page.wait_for_function("document.body.textContent === '3 4 0.5'")
    assert faults == []


# Geometry

LOOK_AT_ALL = """
    const pair = await load(program_bytes);
    const given_bytes = bytes(given[0]);
    const numbers = new DataView(given_bytes.buffer);
    const seen = [];
    let place = 0;
    while (place < given_bytes.length) {
        pair.corners.resize(numbers.getFloat64(place, true));
        pair.axes.resize(pair.corners.length);
        place += 8;
        const memory = new Uint8Array(pair.exports.memory.buffer);
        const regions = pair.tables.map(({ address, length, bytes }) => [address, length * bytes]);
        for (const [address, size] of regions) {
            memory.set(given_bytes.subarray(place, place + size), address);
            place += size;
        }
        pair.run("look");
        pair.run("look_ahead");
        seen.push(...regions.map(([address, size]) => memory.slice(address, address + size)));
    }
    return new Blob(seen).arrayBuffer().then(text);
"""
"""Sets the tables of one pair after another, and returns all of them after both entries."""


def shape_drawn(rng: np.random.Generator, corners: list[Corner]) -> ShapeRow:
    """Return a polygon, segment or circle somewhere near, in motion; append its corners."""
    count = int(rng.choice([0, 2, 3, 4, 7]))
    size = rng.uniform(0.2, 2.0)
    around = np.sort(rng.uniform(0, 2 * math.pi, count)) if count != 4 else QUARTERS
    first = len(corners)
    corners += [Corner(size * math.cos(angle), size * math.sin(angle)) for angle in around]
    radius = size if count == 0 else rng.uniform(0.0, 0.2) if count == 2 else 0.0
    x, y, angle, vx, vy, w = rng.normal(size=6) * (rng.uniform(size=6) < 0.8)
    moves = {"x": x, "y": y, "angle": angle, "vx": vx, "vy": vy, "w": w}
    reach = {"radius": radius, "bounding_radius": size + radius * (count > 0)}
    return ShapeRow(**moves, **reach, first_corner=first, corner_count=count)


def test_disc_against_a_box_is_seen_in_a_page_as_by_hand(page: Page) -> None:
    """A box of 2 m and a disc of 0.5 m that reaches 0.25 m into its right side, then moves on."""
    lines = """
        const pair = await load(program_bytes);
        const square = [[-1, -1], [1, -1], [1, 1], [-1, 1]];
        pair.corners.resize(square.length);
        pair.axes.resize(square.length);
        square.forEach(([x, y], k) => {
            pair.corners.at(k).local_x = x;
            pair.corners.at(k).local_y = y;
        });
        Object.assign(pair.a, { corner_count: 4 });
        Object.assign(pair.b, { radius: 0.5, x: 1.25 });
        pair.run("look");
        const { nx, ny, penetration0 } = pair.manifold;
        Object.assign(pair.b, { x: 3.5, vx: -4 });
        pair.found.duration = 1;
        pair.run("look");
        pair.run("look_ahead");
        return [nx, ny, penetration0, pair.manifold.count, pair.found.time];
    """
    assert in_page(page, "geometry", lines) == [1, 0, 0.25, 0, 0.5]


PAIRS = tiers.share(10_000, one_in=10)
QUARTERS = np.arange(4) * math.pi / 2


def pair_drawn(rng: np.random.Generator) -> Pair:
    """Return two shapes as a page sets them."""
    corners: list[Corner] = []
    a, b = shape_drawn(rng, corners), shape_drawn(rng, corners)
    found = FoundRow(duration=rng.choice([0.1, 1.0, 9.0]))
    axes = [AxisRow() for _ in corners]
    return Pair(corners, a, b, axes, found, ManifoldRow(), ManifoldRow(), ManifoldRow())


def bytes_of(pair: Pair, source: str) -> bytes:
    """Return the tables as the program lays them out."""
    return b"".join(np.asarray(table).tobytes() for table in as_arrays(pair, source))


def test_geometry_in_a_page_has_the_bits_of_python(
    page: Page, lend_functions: Callable[[], None]
) -> None:
    """Axes, shadows, edges, both stages of the clipping, the manifold and the time of impact."""
    rng = np.random.default_rng(6)
    source = "\n".join(p.source for p in programs.program("geometry").entries.values())
    given, expected, overlaps, impacts = [], [], 0, 0
    for _ in range(PAIRS):
        pair = pair_drawn(rng)
        given += [np.float64(len(pair.corners)).tobytes(), bytes_of(pair, source)]
        look(pair)
        look_ahead(pair)
        expected.append(bytes_of(pair, source))
        overlaps += pair.manifold.count > 0
        impacts += 0.0 < pair.found.time < math.inf
    lend_functions()
    got = in_page(page, "geometry", LOOK_AT_ALL, as_text(b"".join(given)))
    assert got.encode("latin-1") == b"".join(expected)
    assert min(overlaps, impacts) > PAIRS / 9  # not all of them fly by


# The stepped engine

STEPS = 40


def at_work(scene: Scene, solver: str) -> EngineStepper:
    """Return a solver at work on a scene in plain Python, with the effects that the program has."""
    substeps = 2 if our_solvers()[solver].shares_contacts else 1  # else they are steps of their own
    usual: Any = {"dt": DT, "iterations": 4, "combine": MixingRule(), "compiled": False}
    run = EngineStepper(scene, solver=solver, substeps=substeps, **usual)
    run.pipeline = stages_for_any_scene(our_solvers()[solver])
    return run


def source_of(solver: str) -> str:
    """Return the sources of a solver's program, which say what fields its rows have."""
    return "\n".join(entry.source for entry in programs.program(solver).entries.values())


def tables_of(run: EngineStepper, source: str) -> dict[str, list[Any]]:
    """Return a world's tables as the program lays them out: rows, and their bytes."""
    arrays = as_arrays(run.world, source)._asdict()
    return {
        name: [len(np.atleast_1d(table)), as_text(np.asarray(table).tobytes())]
        for name, table in arrays.items()
    }


@pytest.mark.one_in(12)
@pytest.mark.parametrize("solver", STEPPED)
@pytest.mark.parametrize("build", SCENES.values(), ids=SCENES)
def test_engine_in_a_page_has_the_bits_of_python(
    page: Page, lend_functions: Callable[[], None], build: Callable[[], Scene], solver: str
) -> None:
    """All states and impulses, the signs of zeros too; tables grow from nothing in both."""
    run = at_work(build(), solver)
    tables = tables_of(run, source_of(solver))
    run.advance(STEPS)
    lend_functions()
    states, impulses, counts = in_page(page, solver, MAKE_STEPS, tables, STEPS)
    assert states.encode("latin-1") == run.states().tobytes()
    assert impulses.encode("latin-1") == run.events().tobytes()
    assert counts == {name: getattr(run.world.state, name) for name in counts}


@pytest.mark.parametrize(
    ("name", "low", "high"), [("sin", -99, 99), ("cos", -99, 99), ("exp", -9, 0)]
)
def test_function_of_a_page_differs_from_that_of_python_in_the_last_bit_at_most(
    page: Page, name: str, low: float, high: float
) -> None:
    """Each errs by less than one unit in the last place, so that they are neighbours at most.

    V8 brings its own; Python asks the C library, whose bits depend on the processor, too.
    """
    numbers = np.random.default_rng(1).uniform(low, high, 10_000).tolist()
    got = np.array(page.evaluate(f"(numbers) => numbers.map(Math.{name})", numbers))
    wanted = np.array([getattr(math, name)(number) for number in numbers])
    assert (np.abs(got - wanted) <= np.spacing(np.abs(wanted))).all()


LOST = Scene(
    [Body(Circle(1)), Body(Circle(1), mass=1, position=(0, 1.79e308), velocity=(0, 1.7e308))]
)
HEAPED = Scene([Body(Circle(0.5), mass=1) for _ in range(400)])


@pytest.mark.parametrize("solver", STEPPED)
@pytest.mark.parametrize("scene", [LOST, HEAPED], ids=["lost", "heaped"])
def test_scene_that_cannot_go_on_is_refused_in_the_words_of_python(
    page: Page, scene: Scene, solver: str
) -> None:
    """A body beyond all numbers after some steps; 400 bodies in one place."""
    run = at_work(scene, solver)
    tables = tables_of(run, source_of(solver))
    with pytest.raises((FloatingPointError, ValueError)) as refused:
        run.advance(2 * STEPS)
    lines = MAKE_STEPS.replace("world.advance(", "try { world.advance(").replace(
        "    const bodies", "    } catch (error) { return error.message; }\n    const bodies"
    )
    assert in_page(page, solver, lines, tables, 2 * STEPS) == str(refused.value)


@pytest.mark.parametrize(
    ("name", "tables"),
    [*((name, World) for name in STEPPED), ("exact", Tables), ("geometry", Pair)],
)
def test_rows_in_a_page_have_the_fields_and_numbers_of_numpy(
    page: Page, name: str, tables: type
) -> None:
    """Each field of each table is written in the page and read by NumPy, and begins as there."""
    lines = """
        const world = await load(program_bytes);
        const memory = () => world.exports.memory.buffer;
        return world.tables.map((table) => {
            table.resize(2);
            const row = table.at(0);
            const fields = world.about.tables.find(({ name }) => name === table.name).fields;
            Object.entries(fields).forEach(([field, [, kind]], k) => {
                row[field] = kind === "b1" ? k % 2 === 0 : k + 1;
            });
            const end = table.address + 2 * table.bytes;
            return [table.name, text(memory().slice(table.address, end))];
        });
    """
    got = dict(in_page(page, name, lines))
    kinds = row_kinds(tables)
    for table in next(iter(programs.program(name).entries.values())).layout:
        written, fresh = np.frombuffer(got[table.name].encode("latin-1"), table.dtype)
        for k, field in enumerate(table.dtype.names or ()):
            is_flag = table.dtype[field] == np.bool_
            assert written[field] == (k % 2 == 0 if is_flag else k + 1), (table.name, field)
            assert fresh[field] == getattr(kinds[table.name](), field), (table.name, field)


# The exact solver

SECONDS = 2.0
MOMENTS = np.linspace(0.0, SECONDS, 5)
EXACT = {name: build for name, build in SCENES.items() if not why_not(build())}

GO_ON = """
    const [tables, until, moments, bodies] = given;
    const world = await load(program_bytes);
    for (const table of world.tables) {
        const [rows, content] = tables[table.name];
        table.resize(rows);
        new Uint8Array(world.exports.memory.buffer, table.address).set(bytes(content));
    }
    const discs = Array.from({ length: world.discs.length }, (_, k) => world.discs.at(k).body);
    discs.sort((a, b) => a - b);
    world.moments.resize(moments.length);
    moments.forEach((time, k) => (world.moments.at(k).time = time));
    const noted = ["positions", "velocities", "angles", "spins"].map((name) => world[name]);
    for (const table of noted) table.resize(moments.length * bodies);
    world.state.moments = moments.length;
    const impulses = [];
    try {
        world.advanceTo(until, (record, count) => {
            for (let k = 0; k < count; k++) {
                const row = record.at(k);
                for (const field in row) if (field !== "place") impulses.push(row[field]);
            }
        });
    } catch (error) {
        return [error.message, "", ""];
    }
    const states = moments.flatMap((_, k) => discs.flatMap((body) => {
        const [place, velocity, angle, spin] = noted.map((table) => table.at(k * bodies + body));
        return [place.x, place.y, angle.value, velocity.x, velocity.y, spin.value];
    }));
    return ["", text(Float64Array.from(states).buffer), text(Float64Array.from(impulses).buffer)];
"""
"""Lets a world go on, and returns an error's words, the states at all moments, and impulses."""


@pytest.mark.one_in(6)
@pytest.mark.parametrize("build", EXACT.values(), ids=EXACT)
def test_exact_solver_in_a_page_has_the_bits_of_python(
    page: Page, build: Callable[[], Scene]
) -> None:
    """All states and impulses; Python leaves out what a scene does not need, so 0 may be -0."""
    scene = build()
    run = ExactSolver(scene, combine=MixingRule())
    has_grid = "broad_phase" in names_used(run.effects)
    source = programs.program("exact").entries["advance"].source
    start = as_arrays(exact_arrays_of(scene, MixingRule(), has_grid), source)
    tables = {
        name: [len(np.atleast_1d(table)), as_text(np.asarray(table).tobytes())]
        for name, table in start._asdict().items()
    }
    given = (tables, SECONDS, MOMENTS.tolist(), len(scene.bodies))
    error, states, impulses = in_page(page, "exact", GO_ON, *given)
    if error:
        with pytest.raises(RuntimeError, match=error.partition(" at ")[0]):
            run.advance(SECONDS)
        return
    frames = Frames(MOMENTS.tolist(), len(scene.bodies))
    run.note_frames(frames)
    turning = np.stack([frames.angles, frames.spins], axis=-1)
    noted = (frames.positions, turning[..., :1], frames.velocities, turning[..., 1:])
    expected = np.concatenate(noted, axis=-1)[:, scene.columns.is_free]
    assert (np.frombuffer(states.encode("latin-1")) + 0.0).tobytes() == (expected + 0.0).tobytes()
    got = np.frombuffer(impulses.encode("latin-1")).reshape(-1, 10)
    assert (got + 0.0).tobytes() == (run.events() + 0.0).tobytes()
