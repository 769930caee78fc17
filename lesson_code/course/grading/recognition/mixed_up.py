"""Slips by which one thing is taken for another: a base, an argument, what goes in, a curve."""

from __future__ import annotations

import ast
import builtins
import math
from collections.abc import Iterator
from itertools import combinations

from lesson_code.course.grading.recognition.edits import MASSES, is_no_factor, parts_of, renamed
from lesson_code.course.grading.recognition.trees import Edit, called, like, name_of

LOGARITHMS = {"log": math.e, "log10": 10, "log2": 2}
"""Functions that are taken for each other, and their bases."""

STRAIGHT = {"sin": "a", "tan": "a", "exp": "1 + a", "log1p": "a"}
"""Curves, and the straight line that is taken for each, which is right near 0."""

TOGETHER = ("(a + b)", "(a + b) / 2", "1 / (a + b)", "a * b", "(a * b) ** 0.5", "a", "b")
"""What is taken for the mass that counts in a meeting of two."""

NUMBERS = {2: (3, 6), 3: (2, 4), 4: (3, 6), 6: (2, 4), 12: (3, 4, 8)}
"""Numbers in formulas, and those that are taken for them; twice and half of one is a factor."""

OF_MANY = ("sum", "max", "min", "amax", "amin", "mean")
"""Functions of many values, of which one may be passed over."""

MOST_ARGUMENTS = 9

LIMITS = 3
"""Arguments of `clip`: a value, and its limits."""


def mixed_up(node: ast.AST, parent: ast.AST) -> Iterator[Edit]:
    """Yield what may stand in the place of a node by a slip that takes it for another thing."""
    match node:
        case ast.Call():
            yield from _called(node)
        case ast.Tuple(elts=[ast.Call(args=[one]) as low, ast.Call(args=[other]) as high]) if (
            called(low),
            called(high),
        ) == ("min", "max"):
            yield "ends", {}, like("(a[0], b[-1])", one, other)
        case ast.BinOp(op=ast.Div(), left=left, right=right):
            if not isinstance(parent, ast.BinOp):  # a small term would be lost as a whole
                yield "whole", {}, like("a // b", left, right)
            yield "ratio", {}, like("a - b", left, right)
            if not isinstance(right, ast.Constant):
                yield "twice", {}, like("a / b / b", left, right)
            yield from _together(left, right)
        case ast.BinOp(op=ast.Mult(), left=left, right=right):
            for factor in (left, right):
                if not isinstance(factor, ast.Constant):
                    yield "twice", {}, like("a * b * c", left, right, factor)
        case ast.BinOp(op=ast.Add() | ast.Sub() as op, left=left, right=right):
            for change in ("2 * a", "a / 2"):
                if isinstance(left, ast.BinOp) and isinstance(left.op, ast.Mult):
                    yield "factor", {}, ast.BinOp(like(change, left), op, right)
                if isinstance(right, ast.BinOp) and isinstance(right.op, ast.Mult):
                    yield "factor", {}, ast.BinOp(left, op, like(change, right))
        case ast.BinOp(op=ast.Pow(), left=ast.Constant(value=0.5), right=power):
            yield "base", {}, like(f"{math.e} ** -a", power)
            yield "straight", {}, like(f"1 - {math.log(2)} * a", power)
            yield "straight", {}, like("1 - a", power)
        case ast.BinOp(op=ast.Pow(), left=left, right=ast.Constant(value=2)):
            yield "power_less", {"name": name_of(left)}, like("a ** 0.5", left)
        case ast.Constant(value=int(number)) if number in NUMBERS and not is_no_factor(parent):
            yield from (("number", {}, ast.Constant(other)) for other in NUMBERS[number])
        case ast.Subscript(slice=ast.Name() as place):
            yield "index", {}, ast.Subscript(node.value, like("1 - a", place), node.ctx)


def _together(left: ast.expr, right: ast.expr) -> Iterator[Edit]:
    """Yield c / (1 / a + 1 / b) with the two put together in another way."""
    match right:
        case ast.BinOp(
            op=ast.Add(),
            left=ast.BinOp(op=ast.Div(), left=ast.Constant(value=1), right=one),
            right=ast.BinOp(op=ast.Div(), left=ast.Constant(value=1), right=other),
        ):
            for way in TOGETHER:
                yield "together", {}, ast.BinOp(left, ast.Mult(), like(way, one, other))


def _called(node: ast.Call) -> Iterator[Edit]:
    """Yield the slips in a call: another base, exchanged arguments, what goes in for what comes."""
    name = called(node)
    if name in LOGARITHMS and len(node.args) == 1:
        for other, base in LOGARITHMS.items():
            if other != name:
                yield "base", {}, like(f"a * {math.log(LOGARITHMS[name], base)}", node)
    if name == "clip" and len(node.args) == LIMITS:
        for other, limit in (("maximum", 1), ("minimum", 2)):
            one_sided = ast.Call(renamed(node.func, other), [node.args[0], node.args[limit]], [])
            yield "clamp", {}, one_sided
    if name in STRAIGHT and len(node.args) == 1:
        yield "straight", {}, like(STRAIGHT[name], node.args[0])
    if name in OF_MANY and len(node.args) == 1:
        for part in ("[1:]", "[:-1]"):
            values = like(f"list(a){part}", node.args[0])
            yield "count", {}, ast.Call(node.func, [values], node.keywords)
    if len(node.args) in range(3, MOST_ARGUMENTS + 1):
        for i, k in combinations(range(len(node.args)), 2):
            moved = list(node.args)
            moved[i], moved[k] = moved[k], moved[i]
            names = {"first": name_of(node.args[i]), "second": name_of(node.args[k])}
            kind = "gate" if name == "where" else "exchanged"
            yield kind, names, ast.Call(node.func, moved, node.keywords)
    if name_of(node.func) and not hasattr(builtins, name) and name != "count_round":
        yield from _given(node)


def _given(node: ast.Call) -> Iterator[Edit]:
    """Yield what goes into a function of the course for what comes out, and an endless mass."""
    for place, argument in enumerate(node.args):
        if not isinstance(argument, ast.Starred | ast.Constant):
            yield "not_called", {}, argument
        if {*parts_of(name_of(argument))} & MASSES:
            others = [*node.args[:place], ast.Constant(math.inf), *node.args[place + 1 :]]
            fixed = ast.Call(node.func, others, node.keywords)
            yield "fixed", {"name": name_of(argument)}, fixed
