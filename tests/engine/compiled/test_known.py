"""What is known before a run: of an expression, given the values of some names."""

from __future__ import annotations

import ast
from typing import Any

import numpy as np
import pytest

from lesson_code.engine.compiled.known import Known, is_stage, known_value
from lesson_code.engine.core.rows import BodyRow
from lesson_code.engine.effects.flags import Effects

STAGES = Effects(outlines=True, manifolds=False)
NAMES = {"none": None, "yes": True, "no": False, "f": len, "g": sum, "stages": STAGES, "np": np}


def known(expression: str) -> Any:
    """Return what is known of an expression."""
    return known_value(ast.parse(expression, mode="eval").body, NAMES)


@pytest.mark.parametrize(
    ("expression", "value"),
    [
        ("1.5", 1.5),
        ("none", None),
        ("stages.outlines", True),
        ("stages.manifolds", False),
        ("not yes", False),
        ("f is g", False),
        ("f is not g", True),
        ("none is None", True),
        ("none is not None", False),
        ("x or yes", True),
        ("x and no", False),
        ("yes and not no", True),
        ("no or none is not None", False),
        ("isinstance(x, np.ndarray)", False),
    ],
)
def test_expression_that_is_decided_has_its_value(expression: str, value: Any) -> None:
    """Also when one part of `and` or `or` decides it, whatever the other is."""
    assert known(expression) == Known(value)


@pytest.mark.parametrize(
    "expression",
    ["x", "x.y", "not x", "x is None", "x and yes", "x or no", "yes == no", "1 + 1", "f(1)",
     "stages[0]", "isinstance(x, y)", "x < 1", "none is x"],
)  # fmt: skip
def test_expression_that_is_not_decided_is_unknown(expression: str) -> None:
    """Sums and comparisons are left to the run, even of constants: nothing is computed here."""
    assert known(expression) is None


def test_value_that_is_none_is_known_all_the_same() -> None:
    """Known(None) says yes where None says no."""
    assert known("none")
    assert not known("x")


@pytest.mark.parametrize(
    ("value", "expected"),
    [(None, True), (len, True), (STAGES, True), (1.0, False), (True, False), (BodyRow(), False)],
    ids=["None", "function", "named tuple", "number", "flag", "row"],
)
def test_stages_are_functions_tuples_of_them_and_none(value: Any, expected: bool) -> None:
    """Numbers and rows are handed over in a call."""
    assert is_stage(value) == expected
