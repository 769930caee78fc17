"""The lesson's functions in Chromium, against the same functions in Python: the same bits."""

from __future__ import annotations

import base64
import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
import tiers

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
from lesson_code.view.browser import programs
from lesson_code.view.browser.programs.formulas import with_doors

if TYPE_CHECKING:
    from playwright.sync_api import Page

MODULE = Path(programs.FOLDER).with_name("program.js")
DRAWN = tiers.share(10_000)

CALL_ALL = """
async ([script, program, name, taken]) => {
    const { load } = await import("data:text/javascript;base64," + script);
    const bytes = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    const lesson = await load(bytes(program));
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
    const flat = new Uint8Array(Float64Array.from(results.flat()).buffer);
    return Array.from(flat, (byte) => String.fromCharCode(byte)).join("");
}
"""
"""In the page: calls a function with all that was drawn, and returns the bytes of its results."""


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
    if "m2" in values and rng.uniform() < 0.1:
        values["m2"] = math.inf
    return values


def numbers_of(value: Any) -> list[float]:
    """Return an argument as the numbers that the page reads it from."""
    if isinstance(value, list):
        return [len(value), *np.ravel(value)]
    return np.ravel(value).tolist()


@pytest.mark.browser
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
    script, program = MODULE.read_bytes(), programs.file_of("formulas").read_bytes()
    told = [as_text(part) for part in (script, program)]
    got = page.evaluate(CALL_ALL, [*told, name, as_text(np.array(taken).tobytes())])
    results = np.frombuffer(got.encode("latin-1"))
    assert len(results) == len(expected) >= DRAWN
    assert results.tobytes() == np.array(expected).tobytes()


@pytest.mark.browser
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
    script, program = MODULE.read_bytes(), programs.file_of("formulas").read_bytes()
    lines = f"try {{ lesson.{call}; }} catch (error) {{ return error.message; }}"
    got = page.evaluate(
        f"""async ([script, program]) => {{
            const {{ load }} = await import("data:text/javascript;base64," + script);
            const letters = atob(program);
            const lesson = await load(Uint8Array.from(letters, (letter) => letter.charCodeAt(0)));
            {lines}
        }}""",
        [as_text(script), as_text(program)],
    )
    assert got == words
