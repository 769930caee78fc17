"""Slips about sizes: of a vector, of its part along a direction, of a number without its sign."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from lesson_code.course.grading.recognition.trees import Edit, called, like

LENGTHS = ("abs(a) + abs(b)", "max(abs(a), abs(b))", "a + b", "a * a + b * b", "a", "b")
"""What is taken for the length of a vector with two components."""


LESS_FAST = "(a @ a) ** 0.5 - (b @ b) ** 0.5"
"""What is taken for the part of a difference of vectors along a direction."""


def of_sizes(node: ast.AST, parent: ast.AST) -> Iterator[Edit]:
    """Yield what may stand in the place of a node by a slip about a size."""
    match node, parent:
        case (
            ast.Name(id=name, ctx=ast.Load()),
            ast.BinOp(op=ast.Add() | ast.Sub()) | ast.UnaryOp(op=ast.USub()),
        ):
            yield "as_one", {"name": name}, ast.Constant(1)
    match node:
        case ast.Call(args=[ast.Starred(value=way)]) if called(node) == "hypot":
            yield from _lengths(like("a[0]", way), like("a[1]", way))
        case ast.Call(args=[x, y]) if called(node) == "hypot":
            yield from _lengths(x, y)
        case ast.Call(args=[way]) if called(node) == "norm":
            yield from _lengths(like("a[0]", way), like("a[1]", way))
        case ast.Call(args=[one, other]) if called(node) == "dot":
            yield from _along(one, other, node)
            if isinstance(one, ast.BinOp) and isinstance(one.op, ast.Sub):
                yield "along", {}, like(LESS_FAST, one.left, one.right)
        case ast.BinOp(left=one, op=ast.MatMult(), right=other):
            yield from _along(one, other, node)
        case ast.BinOp(left=one, op=ast.Sub(), right=other):
            yield "absolute", {}, like("abs(a - b)", one, other)
            yield "absolute", {}, like("abs(a) - abs(b)", one, other)
            yield "absolute", {}, like("abs(a) + abs(b)", one, other)
            yield from _one_sided(node)
    match node:
        case ast.BinOp(
            left=ast.BinOp(left=a, op=ast.Pow(), right=ast.Constant(value=2) as two),
            op=ast.Add() | ast.Sub() as op,
            right=ast.BinOp(left=b, op=ast.Pow(), right=ast.Constant(value=2)),
        ):
            yield "squares", {}, ast.BinOp(ast.BinOp(a, op, b), ast.Pow(), two)
        case ast.BinOp(
            left=ast.BinOp(left=a, op=ast.Add() | ast.Sub() as op, right=b),
            op=ast.Pow(),
            right=ast.Constant(value=int() | float()) as power,
        ):
            powers = [ast.BinOp(part, ast.Pow(), power) for part in (a, b)]
            yield "squares", {}, ast.BinOp(powers[0], op, powers[1])
        case ast.Call(
            func=function, args=[ast.BinOp(left=a, op=ast.Add() | ast.Sub() as op, right=b)]
        ) if called(node) in ("sqrt", "exp", "log", "sin", "cos"):
            roots = [ast.Call(function, [part], []) for part in (a, b)]
            yield "squares", {}, ast.BinOp(roots[0], op, roots[1])


def of_signs(node: ast.AST, parent: ast.AST) -> Iterator[Edit]:
    """Yield the size of a quantity in the place of the quantity."""
    if isinstance(node, ast.Name) and isinstance(parent, ast.BinOp | ast.UnaryOp):
        yield "absolute", {}, like("abs(a)", node)


def _lengths(x: ast.expr, y: ast.expr) -> Iterator[Edit]:
    """Yield what is taken for the length of a vector."""
    for text in LENGTHS:
        yield "length", {}, like(text, x, y)


def _along(one: ast.expr, other: ast.expr, node: ast.expr) -> Iterator[Edit]:
    """Yield what is taken for the part of one vector along another."""
    yield "absolute", {}, like("abs(a)", node)
    yield from _one_sided(node)
    if ast.dump(one) == ast.dump(other):
        yield "length", {}, like("(a @ a) ** 0.5", one)
        return
    for vector in (one, other):
        for text in ("(a @ a) ** 0.5", "-((a @ a) ** 0.5)", "a[0]", "a[1]"):
            yield "along", {}, like(text, vector)


def _one_sided(node: ast.expr) -> Iterator[Edit]:
    """Yield a number that counts only on one side of 0."""
    yield "one_sided", {}, like("max(0, a)", node)
    yield "one_sided", {}, like("min(0, a)", node)
