"""Small tools for syntax trees: what is called, and trees made of a text with holes."""

from __future__ import annotations

import ast
import copy
from typing import Any, TypeAlias

Edit: TypeAlias = tuple[str, dict[str, str], ast.AST]
"""The kind of a slip, the names that its hint holds, and what stands in a node's place."""


def called(node: ast.Call) -> str:
    """Return the name of the function that is called, without its module."""
    return node.func.attr if isinstance(node.func, ast.Attribute) else name_of(node.func)


def name_of(node: ast.expr) -> str:
    """Return a name that is an expression by itself, else nothing."""
    return node.id if isinstance(node, ast.Name) else ""


def like(text: str, *parts: ast.expr) -> Any:
    """Return an expression as a text says, with parts in the place of the names a, b, c.

    >>> ast.unparse(like("abs(a) + b", ast.Constant(1), ast.Name("x")))
    'abs(1) + x'
    """
    return _Filled(dict(zip("abc", parts, strict=False))).visit(ast.parse(text, mode="eval").body)


class _Filled(ast.NodeTransformer):
    """Puts expressions in the place of names."""

    def __init__(self, parts: dict[str, ast.expr]) -> None:
        self._parts = parts

    def visit_Name(self, node: ast.Name) -> ast.expr:
        return self._parts.get(node.id, node)


def rebuilt(tree: ast.expr, node: ast.AST, other: ast.AST) -> Any:
    """Return a copy of a tree in which another node stands in the place of one.

    >>> tree = ast.parse("min(a / k, b)", mode="eval").body
    >>> ast.unparse(rebuilt(tree, tree.args[0], tree.args[0].left))
    'min(a, b)'
    """
    return copy.deepcopy(tree, {id(node): other})


def names_in(node: ast.AST) -> list[ast.Name]:
    """Return the names that are read in a tree, the places that are written to left out."""
    if isinstance(node, ast.Assign | ast.AugAssign):
        return names_in(node.value)
    return [
        part
        for part in ast.walk(node)
        if isinstance(part, ast.Name) and isinstance(part.ctx, ast.Load)
    ]
