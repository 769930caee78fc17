"""WebAssembly: what a module says of itself, and when it has to be built again."""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import pytest

from lesson_code.engine.compiled import webassembly
from lesson_code.engine.compiled.arrays import dtype_of
from lesson_code.engine.compiled.program import program_of
from lesson_code.engine.compiled.webassembly import (
    MAGIC,
    WebProgram,
    built,
    described,
    formula_program,
    told_by,
)
from lesson_code.engine.core.rows import ContactRow, State, World
from lesson_code.formulas import bounce, disc_inertia, polygon_inertia

DOUBLE = '''def double(x):
    """Return twice x."""
    return 2.0 * x  # as it stands
'''


class Nothing(NamedTuple):
    """No tables."""


def fingerprint(source: str) -> str:
    """Return the sum over a program of one function."""
    return WebProgram({"double": program_of(source, "double", Nothing)}, {}).fingerprint


@pytest.mark.parametrize(
    "source",
    [
        DOUBLE.replace("  # as it stands", ""),
        DOUBLE.replace("twice x", "x and x"),
        DOUBLE.replace('    """Return twice x."""\n', ""),
        DOUBLE.replace("2.0 * x", "(2.0*x)"),
    ],
    ids=["comment", "docstring", "no docstring", "spaces"],
)
def test_fingerprint_is_the_same_whatever_does_not_run(source: str) -> None:
    """Who improves a sentence need not have a linker."""
    assert source != DOUBLE
    assert fingerprint(source) == fingerprint(DOUBLE)


@pytest.mark.parametrize(
    "lines", ["2.0 * y", "2 * x", "x * 2.0", "-2.0 * x", "2.0 + x", "'2.0 * x'"]
)
def test_fingerprint_is_another_where_a_line_is(lines: str) -> None:
    """A constant, its kind, the order, a name."""
    assert fingerprint(DOUBLE.replace("2.0 * x", lines)) != fingerprint(DOUBLE)


def test_fingerprint_is_another_where_tables_lie_otherwise() -> None:
    """A field that comes first moves all others."""
    about = {"tables": described(program_of(".vx .w", "f", World), World)}
    moved = {"tables": described(program_of(".vx .vy .w", "f", World), World)}
    program = WebProgram({}, about)
    assert program.fingerprint != replace(program, about=moved).fingerprint


def test_tables_are_described_as_numpy_lays_them_out() -> None:
    """Every field of the world's rows, with what it begins with unless that is zero."""
    used = frozenset(("next_static", "case", "friction", "is_block"))
    program = program_of(" ".join(f".{name}" for name in used), "f", World)
    tables = {table["name"]: table for table in described(program, World)}
    dtype = dtype_of(ContactRow, used)
    assert tables["contacts"]["bytes"] == dtype.itemsize
    assert tables["contacts"]["fields"] == {
        "friction": [dtype.fields["friction"][1], "f8"],
        "is_block": [dtype.fields["is_block"][1], "b1"],
        "next_static": [dtype.fields["next_static"][1], "i4", -1],
        "case": [dtype.fields["case"][1], "i4", 3],
    }
    assert [name for name, table in tables.items() if table["single"]] == ["state", "manifold"]
    assert set(tables["state"]["fields"]) == set(State.__slots__)
    assert tables["state"]["fields"]["thinnest"][2] == "Infinity"


def test_functions_are_described_by_their_arguments() -> None:
    """Name, kind, and what it is if it is left out."""
    formulas = {f.__name__: f for f in (bounce, disc_inertia, polygon_inertia)}
    assert formula_program(formulas).about["functions"] == {
        "bounce": [
            ["velocity", "vector"],
            ["normal", "vector"],
            ["restitution", "number"],
            ["friction", "number", 0.0],
        ],
        "disc_inertia": [["mass", "number"], ["radius", "number"]],
        "polygon_inertia": [["mass", "number"], ["vertices", "polygon"]],
    }


@pytest.mark.parametrize("size", [0, 100, 20_000, 3_000_000])
def test_module_says_what_it_was_made_of(size: int) -> None:
    """Behind other sections, and however long it is."""
    program = WebProgram({}, {"words": "x" * size})
    code = bytes([1, 3, 7, 7, 7])
    told = told_by(MAGIC + code + webassembly._section(program))
    assert (told["sources"], told["words"]) == (program.fingerprint, "x" * size)


def test_module_that_says_nothing_is_refused() -> None:
    """It is not one of ours."""
    with pytest.raises(ValueError, match="must have a section named workbook"):
        told_by(MAGIC)


def test_without_the_linker_it_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    """And how to get it."""
    monkeypatch.setattr(webassembly, "makers", lambda: {"numba": "1", "ziglang": ""})
    with pytest.raises(
        RuntimeError, match=r"^ziglang is not installed: pip install -e '.\[wasm\]'$"
    ):
        built(WebProgram({}, {}))
