"""What is known before a run: the functions, stages and flags that a program is made for."""

from __future__ import annotations

import ast
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from lesson_code.formulas.validation import equation


class Known(NamedTuple):
    """The value of an expression that is known before the run."""

    value: Any


def known_value(node: ast.expr, names: Mapping[str, Any]) -> Known | None:
    """Return the value of an expression if it can be known, given those of some names.

    These are known: constants, the names given, attributes of known values, the equation of a known
    formula, and `is`, `not`, `and`, `or` and `if` between such expressions. Nothing in a row is an
    array.

    >>> known_value(ast.parse("a is None or b", mode="eval").body, {"a": None})
    Known(value=True)
    >>> known_value(ast.parse("a + b", mode="eval").body, {"a": 1}) is None
    True
    """
    match node:
        case ast.Constant():
            return Known(node.value)
        case ast.Name():
            return Known(names[node.id]) if node.id in names else None
        case ast.Attribute():
            owner = known_value(node.value, names)
            return owner and Known(getattr(owner.value, node.attr))
        case ast.UnaryOp(op=ast.Not()):
            operand = known_value(node.operand, names)
            return operand and Known(not operand.value)
        case ast.Compare(ops=[ast.Is() | ast.IsNot() as op]):
            left = known_value(node.left, names)
            right = known_value(node.comparators[0], names)
            same = left and right and left.value is right.value
            return None if same is None else Known(same == isinstance(op, ast.Is))
        case ast.BoolOp():
            return _junction(node, names)
        case ast.IfExp():
            test = known_value(node.test, names)
            return test and known_value(node.body if test.value else node.orelse, names)
        case ast.Call(func=ast.Name(id="isinstance")):
            kind = known_value(node.args[1], names)
            return Known(False) if kind and kind.value is np.ndarray else None
        case ast.Call(func=ast.Name() as door, args=[checked]) if names.get(door.id) is equation:
            found = known_value(checked, names)
            return found and Known(equation(found.value))
        case _:
            return None


def _junction(node: ast.BoolOp, names: Mapping[str, Any]) -> Known | None:
    """Return the value of `and` or `or`, if one part decides it or all are known."""
    parts = [known_value(part, names) for part in node.values]
    deciding = isinstance(node.op, ast.Or)
    if any(part and bool(part.value) == deciding for part in parts):
        return Known(deciding)
    return Known(not deciding) if all(parts) else None


def is_stage(value: Any) -> bool:
    """Return whether a program is specialised for a value, so that no call passes the value on."""
    return value is None or callable(value) or hasattr(value, "_fields")
