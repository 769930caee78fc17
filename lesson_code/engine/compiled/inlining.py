"""Which functions of a program are compiled in place of their calls.

A call that hands on the whole world copies a hundred words, since Numba passes a tuple of tables
word by word: in a loop over bodies or pairs that takes longer than what is called. A function in
place of its calls costs nothing. So what a loop calls is put into it, but for two limits:

- a function that stands in several places is compiled in each of them, so it may not be long;
- a stage that is called once a step stays a function. With all of them in one the compiler gives up
  on its loops: a gas with every effect took six times as long.
"""

from __future__ import annotations

import ast
from collections import Counter
from functools import cache
from typing import NamedTuple

MOST_NODES = 3000
"""Nodes of the syntax tree that a function may have in all its places together.

With two thirds of it a gas with every effect takes twice as long, since the narrow phase stays a
call; with a third the walk over the grid does. With much more nothing gets faster, and programs of
the exact solver compile twice as long.
"""


@cache
def inlined(source: str) -> frozenset[str]:
    r"""Return the names of the functions of a program that are compiled in place of their calls.

    Parameters
    ----------
    source : str
        A module of functions that do not call themselves.

    Examples
    --------
    >>> double = "def double(x):\n    return x + x\n"
    >>> inlined(double + "def run(x):\n    for _ in range(3):\n        x = double(x)\n")
    frozenset({'double'})
    """
    functions = {f.name: f for f in ast.parse(source).body if isinstance(f, ast.FunctionDef)}
    looks = {name: _look(function) for name, function in functions.items()}
    repeated = _repeated(looks)
    sites = sum((look.calls for look in looks.values()), Counter[str]())
    lengths: dict[str, int] = {}
    chosen: set[str] = set()

    def settle(name: str) -> None:
        """Decide on a function, after those that it calls."""
        nodes, calls, _ = looks[name]
        known = calls.keys() & looks.keys()
        for callee in known:
            if callee not in lengths:
                settle(callee)
        lengths[name] = nodes + sum(calls[callee] * lengths[callee] for callee in known & chosen)
        if name in repeated and sites[name] * lengths[name] <= MOST_NODES:
            chosen.add(name)

    for name in functions:
        if name not in lengths:
            settle(name)
    return frozenset(chosen)


class _Look(NamedTuple):
    """What counts of a function: its length, and which names it calls, also only in for loops."""

    nodes: int
    calls: Counter[str]
    calls_in_loops: set[str]


def _look(function: ast.FunctionDef) -> _Look:
    """Return it, from one walk through the function."""
    nodes, calls, in_loops = 0, Counter[str](), set[str]()
    ahead: list[tuple[ast.AST, bool]] = [(function, False)]
    while ahead:
        node, is_in_loop = ahead.pop()
        nodes += 1
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            calls[node.func.id] += 1
            if is_in_loop:
                in_loops.add(node.func.id)
        within = is_in_loop or isinstance(node, ast.For)
        ahead.extend((child, within) for child in ast.iter_child_nodes(node))
    return _Look(nodes, calls, in_loops)


def _repeated(looks: dict[str, _Look]) -> set[str]:
    """Return what a for loop calls, and what that calls in turn."""
    found: set[str] = set()
    new = {name for look in looks.values() for name in look.calls_in_loops} & looks.keys()
    while new:
        found |= new
        new = {callee for name in new for callee in looks[name].calls} & looks.keys() - found
    return found
