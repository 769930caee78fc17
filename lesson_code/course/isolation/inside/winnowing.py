"""Fingerprints of functions: the same for code that differs in names, comments and layout.

A function is written as the sequence of its syntax tree's nodes; what its author has named is left
out, as are docstrings and annotations. Of the hashes of every K nodes in a row, the least in each
window of W is kept: two functions that share K + W - 1 nodes in a row share a fingerprint.

References
----------
Schleimer, Wilkerson and Aiken, Winnowing: local algorithms for document fingerprinting, SIGMOD
(2003), section 3: K is the noise threshold, K + W - 1 the guarantee.
"""

from __future__ import annotations

import ast
import hashlib
from collections.abc import Iterator
from functools import cache, lru_cache
from typing import Any

LEFT_OUT = ("annotation", "returns", "ctx", "type_comment", "decorator_list")
"""Fields of a node that say nothing of how its code computes."""

K, W = 10, 6
"""Nodes. `a * b + c` has six, so that a formula alone is noise."""


def fingerprints(body: list[ast.stmt]) -> list[dict[str, Any]]:
    """Return of every function at top level its name, lines, fingerprints, words and own names.

    The words are one hash of all its nodes and of all names in it; its own names are those that
    its author has chosen, in the order in which they come.
    """
    found = []
    for part in body:
        if isinstance(part, ast.FunctionDef):
            nodes, names = _nodes_and_names(part)
            words = " ".join([*nodes, *(name for name, _ in names)])
            own = dict.fromkeys(name for name, is_own in names if is_own)
            found.append(
                {
                    "name": part.name,
                    "lines": [part.lineno, part.end_lineno],
                    "prints": winnowed(nodes),
                    "words": _digest(words),
                    "own": list(own),
                }
            )
    return found


def winnowed(nodes: list[str]) -> list[str]:
    """Return the fingerprints of a sequence, each once, in the order in which they come."""
    hashes = list(map(_hash, _in_a_row(nodes, K)))
    return list(dict.fromkeys(map(min, _in_a_row(hashes, W))))


def _in_a_row(sequence: list[str], count: int) -> Iterator[tuple[str, ...]]:
    """Return all runs of so many in a row, from the first on.

    >>> list(_in_a_row(["a", "b", "c"], 2))
    [('a', 'b'), ('b', 'c')]
    """
    return zip(*(sequence[k:] for k in range(count)), strict=False)


@lru_cache(maxsize=50_000)  # answers of a class have most runs in common
def _hash(run: tuple[str, ...]) -> str:
    """Return the hash of some nodes in a row."""
    return _digest(" ".join(run))


def _digest(text: str) -> str:
    """Return a hash of a text."""
    return hashlib.blake2b(text.encode(errors="replace"), digest_size=6).hexdigest()


def _nodes_and_names(function: ast.FunctionDef) -> tuple[list[str], list[tuple[str, bool]]]:
    """Return a function's nodes from the outside in, and the names among them.

    A node is its kind, and what of it its author cannot name: an attribute, a number. Of a name it
    is said whether it gets its value there.
    """
    nodes: list[str] = []
    names: list[tuple[str, bool]] = []
    left: list[Any] = [function]
    while left:
        node = left.pop()
        kind = node.__class__
        if kind is ast.Name:
            nodes.append("Name")
            names.append((node.id, type(node.ctx) is ast.Store))
        elif kind is ast.Constant:
            nodes.append(f"Constant{node.value!r}")
        else:
            nodes.append(f"{kind.__name__}{node.attr if kind is ast.Attribute else ''}")
            for name in _fields(kind):
                value = getattr(node, name, None)
                if isinstance(value, ast.AST):
                    left.append(value)
                elif isinstance(value, list):
                    left += [p for p in reversed(value) if isinstance(p, ast.AST) and _counts(p)]
    return nodes, names


@cache
def _fields(kind: type[ast.AST]) -> tuple[str, ...]:
    """Return the fields of a kind of node that say how its code computes, the last one first."""
    return tuple(name for name in reversed(kind._fields) if name not in LEFT_OUT)


def _counts(tree: ast.AST) -> bool:
    """Return whether a statement is no docstring, nor another text that does nothing."""
    return not (isinstance(tree, ast.Expr) and isinstance(tree.value, ast.Constant))
