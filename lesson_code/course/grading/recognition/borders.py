"""Slips at borders: where something begins to count, where a limit stands, where a loop ends."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import Any

from lesson_code.course.grading.recognition.trees import Edit, called, like, name_of, rebuilt

STRICT = {ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt}

COARSE = (1e-9, 1e-6, 1e-4, 1e-3, 1e-2, 1e-1)
"""What is taken for nothing in place of exactly 0."""

FINE = 1e-5
"""Up to here a number in a comparison stands for 0 but for rounding."""

WHOLE = ("floor", "ceil", "round", "int")
"""Functions that make a whole number of another."""

LIMITING = ("min", "max", "clip", "minimum", "maximum")

MOST_ROUNDS = (2, 3, 5, 10, 20, 50, 100, 200, 500, 1000, 10_000)
"""After how many rounds somebody may end a loop that should end by itself."""


def at_borders(node: ast.AST, parent: ast.AST) -> Iterator[Edit]:
    """Yield what may stand in the place of a node by a slip about where something ends."""
    match node:
        case ast.Compare():
            yield from _compared(node)
        case ast.Call() if called(node) in WHOLE and len(node.args) == 1:
            for other in {*WHOLE} - {called(node)}:
                yield "whole", {}, like(f"int({_whole(other)})", node.args[0])
        case ast.BinOp(op=ast.FloorDiv()):
            yield "whole", {}, like("round(a / b)", node.left, node.right)
            yield "whole", {}, like("-(-a // b)", node.left, node.right)
        case ast.While():
            for most in MOST_ROUNDS:
                yield "rounds", {}, _at_most(node, most)
        case ast.Return(value=ast.Constant(value=None)):
            yield "nothing", {}, ast.Return(ast.Constant(0.0))
        case ast.Return(value=ast.Constant(value=float())):
            yield "nothing", {}, ast.Return(ast.Constant(None))
        case ast.IfExp(test=test, body=body, orelse=ast.Constant(value=None)):
            yield "nothing", {}, ast.IfExp(test, body, ast.Constant(0.0))
    if not (isinstance(parent, ast.Call) and called(parent) in LIMITING):
        yield from _limited(node)


def _compared(node: ast.Compare) -> Iterator[Edit]:
    """Yield a comparison that takes in its border or not, one of two at once, or a wider border."""
    sides = [node.left, *node.comparators]
    for place, op in enumerate(node.ops):
        if type(op) in STRICT:
            ops = [*node.ops[:place], STRICT[type(op)](), *node.ops[place + 1 :]]
            yield "strict", {}, ast.Compare(node.left, ops, node.comparators)
        if len(node.ops) > 1:
            yield "condition", {}, ast.Compare(sides[place], [op], [sides[place + 1]])
    if len(node.ops) == 1 and type(node.ops[0]) in STRICT:
        for right in _wider(node.comparators[0]):
            yield "threshold", {}, ast.Compare(node.left, node.ops, [right])


def _wider(border: ast.expr) -> Iterator[ast.expr]:
    """Yield what stands a little beside a border."""
    match border:
        case ast.Constant(value=int() | float() as number) if abs(number) < FINE:
            yield from (ast.Constant(sign * number) for number in COARSE for sign in (1, -1))
        case ast.Constant():
            return
        case _:
            for reach in COARSE:
                yield ast.BinOp(border, ast.Add(), ast.Constant(reach))
                yield ast.BinOp(border, ast.Sub(), ast.Constant(reach))


def _whole(function: str) -> str:
    """Return how a number becomes a whole one, where nothing has to be imported."""
    return {"floor": "a // 1", "ceil": "-(-a // 1)", "round": "round(a)", "int": "a"}[function]


def _at_most(loop: ast.While, rounds: int) -> ast.stmt:
    """Return a loop that ends after so many rounds at the latest."""
    stops = ast.If(ast.UnaryOp(ast.Not(), loop.test), [ast.Break()], [])
    return ast.For(
        ast.Name("_", ast.Store()), like(f"range({rounds})"), [stops, *loop.body], loop.orelse
    )


def _limited(node: ast.AST) -> Iterator[Edit]:
    """Yield a limit before a product or quotient that it should follow, and the reverse."""
    match node:
        case ast.Call() if called(node) in LIMITING:
            for factor in _factors_within(node):
                inside = rebuilt(node, factor, factor.left)
                yield "limit", {}, ast.BinOp(inside, factor.op, factor.right)
        case ast.BinOp(left=ast.Call() as limit, op=ast.Mult() | ast.Div() as op, right=other):
            yield from _taken_in(limit, lambda inner: ast.BinOp(inner, op, other))
        case ast.BinOp(left=other, op=ast.Mult() as op, right=ast.Call() as limit):
            yield from _taken_in(limit, lambda inner: ast.BinOp(other, op, inner))


def _factors_within(limit: ast.Call) -> Iterator[ast.BinOp]:
    """Yield the products and quotients that a limit, or one in it, bounds."""
    for argument in limit.args:
        if isinstance(argument, ast.Call) and called(argument) in LIMITING:
            yield from _factors_within(argument)
        if isinstance(argument, ast.BinOp) and isinstance(argument.op, ast.Mult | ast.Div):
            yield argument


def _taken_in(limit: ast.Call, change: Any) -> Iterator[Edit]:
    """Yield a limit with a change made to what it bounds, and not to what comes out of it."""
    if called(limit) not in LIMITING:
        return
    for part in ast.walk(limit):
        is_bounded = isinstance(part, ast.Name) and part.id != name_of(limit.func)
        if is_bounded and any(part in ast.iter_child_nodes(call) for call in ast.walk(limit)):
            yield "limit", {}, rebuilt(limit, part, change(part))
