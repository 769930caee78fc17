"""The slips that may be made at one place of a syntax tree: what may stand there instead."""

from __future__ import annotations

import ast
import copy
import math
import re
from collections.abc import Iterator
from itertools import combinations

from lesson_code.course.grading.recognition.trees import Edit, called, name_of

PAIRS = {
    "1": "2", "a": "b", "x": "y", "low": "high", "start": "end", "inner": "outer", "n": "t",
    "i": "j", "width": "height", "light": "heavy", "left": "right", "earlier": "later",
    "before": "after", "position": "velocity", "positions": "velocities", "angles": "rates",
}  # fmt: skip
OPPOSITE = PAIRS | {other: one for one, other in PAIRS.items()}
"""Parts of names that tell one of a pair from the other."""

MASSES = {"m", "mass", "masses", "inertia"}
"""Parts of the names of what lets nothing move where it is endless."""

CALLS = {
    "min": ("max", "minmax"), "argmin": ("argmax", "minmax"), "fmin": ("fmax", "minmax"),
    "minimum": ("maximum", "minmax"), "sin": ("cos", "sine"), "cross": ("dot", "cross"),
    "all": ("any", "and_or"), "floor": ("ceil", "count"),
}  # fmt: skip
EXCHANGED_CALLS = CALLS | {other: (one, kind) for one, (other, kind) in CALLS.items()}
"""Functions that are taken for each other, and the kind of that slip."""

LEFT_OUT = {
    "sqrt": "root", "exp": "root", "log": "root", "log1p": "root", "hypot": "root",
    "abs": "absolute", "absolute": "absolute", "radians": "degrees", "ceil": "not_whole",
}  # fmt: skip
"""Functions whose argument may be taken as it is, and the kind of that slip."""

ROOTS = ("hypot", "norm", "dist", "abs")
"""Functions that take a root, which may be left out."""

OF_A_COUNT = ("full", "ones", "range", "repeat", "round", "tile", "zeros")
"""Functions to which a 2 says how many, and not how much."""

IN_RADIANS = ("sin", "cos", "tan")
TURNED = {
    ast.Lt: ast.GtE, ast.LtE: ast.Gt, ast.Gt: ast.LtE, ast.GtE: ast.Lt, ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq, ast.Is: ast.IsNot, ast.IsNot: ast.Is, ast.In: ast.NotIn, ast.NotIn: ast.In,
}  # fmt: skip


def edits(node: ast.AST, parent: ast.AST, known: set[str]) -> Iterator[Edit]:
    """Yield what may stand in the place of a node by a slip."""
    match node:
        case ast.Assign() | ast.AugAssign() | ast.Return(value=ast.expr()):
            yield from _ignoring(node, known)
    match node:
        case ast.BinOp():
            yield from _arithmetic(node, parent)
        case ast.UnaryOp(op=ast.USub()):
            yield "sign", {}, node.operand
        case ast.UnaryOp(op=ast.Not()):
            yield "gate", {}, node.operand
        case ast.Constant(value=bool() | str() | None):
            pass
        case ast.Constant(value=value) if value in (2, 0.5):
            if not is_no_factor(parent):
                yield "factor", {}, ast.Constant(1)
                yield "factor", {}, ast.Constant(2 * value)
        case ast.Constant(value=value) if value in (3, 6, 12, 24):
            yield "factor", {}, ast.Constant(2 * value)
            yield "factor", {}, ast.Constant(value / 2)
        case ast.Name(ctx=ast.Load()):
            for other in others_of(node.id, known):
                yield "other", {"wrong": other, "right": node.id}, ast.Name(other, ast.Load())
        case ast.Subscript(slice=ast.Constant(value=int(index))) if index in (0, 1):
            yield "index", {}, ast.Subscript(node.value, ast.Constant(1 - index), node.ctx)
        case ast.Call():
            yield from _calls(node)
        case ast.Compare(ops=[op], left=left, comparators=[right]):
            if type(op) in TURNED:
                yield "gate", {}, ast.Compare(left, [TURNED[type(op)]()], [right])
            if isinstance(parent, ast.If | ast.IfExp | ast.comprehension | ast.BoolOp):
                yield "gate", {}, ast.Constant(True)
                yield "gate", {}, ast.Constant(False)
        case ast.BoolOp(op=op, values=values):
            other_op = ast.Or() if isinstance(op, ast.And) else ast.And()
            yield "and_or", {}, ast.BoolOp(other_op, values)
            for index in range(len(values)):
                kept = [*values[:index], *values[index + 1 :]]
                yield "condition", {}, kept[0] if len(kept) == 1 else ast.BoolOp(op, kept)
        case ast.While():
            stops = ast.If(ast.UnaryOp(ast.Not(), node.test), [ast.Break()], [])
            once = ast.Tuple([ast.Constant(0)], ast.Load())
            round_ = ast.For(ast.Name("_", ast.Store()), once, [stops, *node.body], [])
            yield "once", {}, round_
            for end in [part for part in ast.walk(node) if isinstance(part, ast.Return)][:1]:
                yield "once", {}, ast.If(ast.Constant(True), [round_, end], [])
        case ast.Tuple(ctx=ast.Load(), elts=elements) if isinstance(parent, ast.Return):
            for i, k in combinations(range(len(elements)), 2):
                moved = list(elements)
                moved[i], moved[k] = moved[k], moved[i]
                yield "order", {}, ast.Tuple(moved, ast.Load())
        case ast.Assign(targets=[ast.Name(id=name)]) if _uses(node.value, name):
            yield "step", {}, ast.Pass()
        case ast.AugAssign(op=ast.Mult() | ast.Div()):
            yield "step", {}, ast.Pass()
        case ast.AugAssign(op=ast.Add() | ast.Sub() as op):
            yield "step", {}, ast.Pass()
            turned = ast.Sub() if isinstance(op, ast.Add) else ast.Add()
            yield "sign", {}, ast.AugAssign(node.target, turned, node.value)
    if isinstance(node, ast.expr) and _is_a_value(node, parent):
        yield "factor", {}, ast.BinOp(ast.Constant(2), ast.Mult(), node)
        yield "factor", {}, ast.BinOp(node, ast.Div(), ast.Constant(2))
        yield "sign", {}, ast.UnaryOp(ast.USub(), node)


def is_no_factor(parent: ast.AST) -> bool:
    """Return whether a 2 below a node is a power, an end of a slice, or counts values."""
    if isinstance(parent, ast.BinOp):
        parts = (parent.left, parent.right)
        return isinstance(parent.op, ast.Pow) or any(
            isinstance(part, ast.Tuple | ast.List) for part in parts
        )
    return isinstance(parent, ast.Slice) or (
        isinstance(parent, ast.Call) and called(parent) in OF_A_COUNT
    )


def _is_a_value(node: ast.expr, parent: ast.AST) -> bool:
    """Return whether a node is all that gets a name or is returned, alone or in a tuple."""
    if isinstance(node, ast.Constant | ast.Tuple | ast.List | ast.Compare | ast.BoolOp):
        return False
    if isinstance(parent, ast.Tuple):
        return isinstance(parent.ctx, ast.Load)
    return isinstance(parent, ast.Assign | ast.Return) and not isinstance(node, ast.Name)


def _ignoring(node: ast.Assign | ast.AugAssign | ast.Return, known: set[str]) -> Iterator[Edit]:
    """Yield a statement in whose value one of the names does not count."""
    value = node.value or ast.Constant(None)
    for name in sorted({part.id for part in ast.walk(value) if isinstance(part, ast.Name)} & known):
        without = copy.copy(node)
        without.value = _Without(name).visit(copy.deepcopy(value))
        yield "ignored", {"name": name}, without


class _Without(ast.NodeTransformer):
    """Puts 0 times a name in its place, where it is a quantity: not a condition, nor a number."""

    def __init__(self, name: str) -> None:
        self._name = name

    def visit_Compare(self, node: ast.Compare) -> ast.expr:
        return node

    def visit_Subscript(self, node: ast.Subscript) -> ast.expr:
        return ast.Subscript(self.visit(node.value), node.slice, node.ctx)

    def visit_Name(self, node: ast.Name) -> ast.expr:
        if node.id != self._name or not isinstance(node.ctx, ast.Load):
            return node
        return ast.BinOp(ast.Constant(0), ast.Mult(), node)


def _uses(node: ast.AST, name: str) -> bool:
    """Return whether a name stands in an expression."""
    return any(isinstance(part, ast.Name) and part.id == name for part in ast.walk(node))


def _arithmetic(node: ast.BinOp, parent: ast.AST) -> Iterator[Edit]:
    """Yield the slips in a sum, product, quotient or power."""
    left, right = node.left, node.right
    in_range = isinstance(parent, ast.Call) and called(parent) == "range"
    match node.op:
        case ast.Add() | ast.Sub():
            turned = ast.Sub() if isinstance(node.op, ast.Add) else ast.Add()
            yield "sign", {}, ast.BinOp(left, turned, right)
            yield "count" if in_range or _is_one(right) else "term", {}, left
            yield "term", {}, right
            if isinstance(node.op, ast.Sub):
                yield "sign", {}, ast.BinOp(right, ast.Sub(), left)
            elif not in_range:
                yield "product", {}, ast.BinOp(left, ast.Mult(), right)
                if _is_one(left):
                    yield "one_plus", {}, ast.BinOp(ast.Constant(2), ast.Mult(), right)
        case ast.Mult():
            yield "product", {}, ast.BinOp(left, ast.Add(), right)
            yield "quotient", {}, ast.BinOp(left, ast.Div(), right)
            yield _factor(right), {"of": name_of(right)}, left
            if isinstance(left, ast.UnaryOp):
                without = ast.UnaryOp(left.op, right)
                yield _factor(left.operand), {"of": name_of(left.operand)}, without
            yield _factor(left), {"of": name_of(left)}, right
            yield from _without_brackets(left, node.op, right)
            yield from _not_projected(left, right)
        case ast.Div():
            yield "quotient", {}, ast.BinOp(left, ast.Mult(), right)
            yield "upside_down", {}, ast.BinOp(right, ast.Div(), left)
            yield "factor" if _is_two(right) else "divisor", {"by": name_of(right)}, left
            yield from _halves(left, right)
            yield from _without_brackets(left, node.op, right)
        case ast.Pow():
            yield "power", {}, left
            yield "power", {}, ast.BinOp(left, ast.Mult(), right)
            if isinstance(right, ast.BinOp) and isinstance(right.op, ast.Mult):
                for one, other in ((right.left, right.right), (right.right, right.left)):
                    power = ast.BinOp(left, ast.Pow(), one)
                    yield "power", {}, ast.BinOp(power, ast.Mult(), other)


def _not_projected(left: ast.expr, right: ast.expr) -> Iterator[Edit]:
    """Yield (v . n) n as v."""
    for number, direction in ((left, right), (right, left)):
        match number:
            case ast.Call(args=[one, other]) if called(number) == "dot":
                pass
            case ast.BinOp(left=one, op=ast.MatMult(), right=other):
                pass
            case _:
                continue
        for vector, axis in ((one, other), (other, one)):
            if ast.dump(axis) == ast.dump(direction):
                yield "projection", {}, vector


def _halves(left: ast.expr, right: ast.expr) -> Iterator[Edit]:
    """Yield c a / (a + b) as c / 2."""
    match right:
        case ast.BinOp(left=a, op=ast.Add(), right=b):
            parts = [ast.dump(a), ast.dump(b)]
            if ast.dump(left) in parts:
                yield "share", {}, ast.Constant(0.5)
            elif isinstance(left, ast.BinOp) and isinstance(left.op, ast.Mult):
                for one, other in ((left.left, left.right), (left.right, left.left)):
                    if ast.dump(one) in parts:
                        yield "share", {}, ast.BinOp(other, ast.Div(), ast.Constant(2))


def _without_brackets(left: ast.expr, op: ast.operator, right: ast.expr) -> Iterator[Edit]:
    """Yield (a + b) / c as a + b / c, and the like."""
    match left:
        case ast.BinOp(left=a, op=ast.Add() | ast.Sub() as plus, right=b):
            yield "precedence", {}, ast.BinOp(a, plus, ast.BinOp(b, op, right))
    match right:
        case ast.BinOp(left=a, op=ast.Add() | ast.Sub() as plus, right=b):
            yield "precedence", {}, ast.BinOp(ast.BinOp(left, op, a), plus, b)
        case ast.BinOp(left=a, op=ast.Mult() as times, right=b) if isinstance(op, ast.Div):
            yield "precedence", {}, ast.BinOp(ast.BinOp(left, op, a), times, b)


def _calls(node: ast.Call) -> Iterator[Edit]:
    """Yield the slips in the call of a function."""
    name = called(node)
    if name in EXCHANGED_CALLS:
        other, kind = EXCHANGED_CALLS[name]
        yield kind, {}, ast.Call(renamed(node.func, other), node.args, node.keywords)
    if name in ROOTS:
        yield "root", {}, ast.BinOp(node, ast.Pow(), ast.Constant(2))
    if name == "range":
        *first, last = node.args[:2]
        for step in (ast.Add(), ast.Sub()):
            yield (
                "count",
                {},
                ast.Call(node.func, [*first, ast.BinOp(last, step, ast.Constant(1))], []),
            )
    if name in LEFT_OUT and len(node.args) == 1:
        yield LEFT_OUT[name], {}, node.args[0]
    if name in ("min", "max", "clip"):
        for argument in node.args:
            yield "clamp", {}, argument
    if name in IN_RADIANS:
        degrees = ast.BinOp(node.args[0], ast.Mult(), ast.Constant(180 / math.pi))
        yield "degrees", {}, ast.Call(node.func, [degrees], [])
    if len(node.args) == 2 and name not in ("dot", "min", "max", "hypot"):
        one, two = node.args
        kind = "cross" if name == "cross" else "exchanged"
        names = {"first": name_of(one), "second": name_of(two)}
        yield kind, names, ast.Call(node.func, [two, one], node.keywords)
    for place, given in enumerate(node.keywords):
        if (
            given.arg == "axis"
            and isinstance(given.value, ast.Constant)
            and given.value.value in (0, 1)
        ):
            other_axis = ast.keyword("axis", ast.Constant(1 - given.value.value))
            keywords = [*node.keywords[:place], other_axis, *node.keywords[place + 1 :]]
            yield "axis", {}, ast.Call(node.func, node.args, keywords)
    for index, argument in enumerate(node.args):
        if isinstance(argument, ast.Starred | ast.Constant | ast.GeneratorExp):
            continue
        turned = [*node.args[:index], ast.UnaryOp(ast.USub(), argument), *node.args[index + 1 :]]
        yield "sign", {}, ast.Call(node.func, turned, node.keywords)


def renamed(function: ast.expr, name: str) -> ast.expr:
    """Return another function of the same module."""
    if isinstance(function, ast.Attribute):
        return ast.Attribute(function.value, name, ast.Load())
    return ast.Name(name, ast.Load())


def _is_one(node: ast.expr) -> bool:
    return isinstance(node, ast.Constant) and node.value == 1


def _is_two(node: ast.expr) -> bool:
    return isinstance(node, ast.Constant) and node.value in (2, 0.5)


def _factor(node: ast.expr) -> str:
    """Return what kind of slip it is to leave a factor out."""
    return "factor" if _is_two(node) else "factor_missing"


def others_of(name: str, known: set[str]) -> list[str]:
    """Return the names that differ from one in which of a pair it is of.

    >>> sorted(others_of("v1", {"v1", "v2", "m1", "v1_after"}))
    ['v2']
    """
    parts, found = parts_of(name), []
    for i, part in enumerate(parts):
        other = "".join([*parts[:i], OPPOSITE.get(part, part), *parts[i + 1 :]])
        if other != name and other in known:
            found.append(other)
    return found


def parts_of(name: str) -> list[str]:
    """Return the parts of a name: v1_after is v, 1, _, after."""
    return re.findall(r"\d|[A-Za-z]+|\W|_", name)
