"""Which functions of a program are compiled in place of their calls, and which are merged.

A call that hands on the whole world copies a hundred words, since Numba passes a tuple of tables
word by word: in a loop over bodies or pairs that takes longer than the function itself. An inlined
function costs nothing. So the functions that a loop calls are inlined in it, with two limits:

- a function that stands in several places is compiled in each of them, so it may not be long;
- a stage with loops that is called once a step stays a function. If all of them are in one function
  the compiler gives up on its loops: a gas with every effect took six times as long.

The remaining functions, which only put stages in order, are merged: each becomes part of its caller
before anything is compiled. So a step of few bodies does not hand on the world a dozen times: a gas
of ten discs takes a sixth less time.
"""

from __future__ import annotations

import ast
from collections import Counter
from functools import cache
from typing import NamedTuple

MOST_NODES = 3000
"""Nodes of the syntax tree that a function may have, summed over all its places.

With two thirds of this a gas with every effect takes twice as long, since the narrow phase stays a
call; with a third the walk over the grid stays one too. With much more nothing gets faster, and
programs of the exact solver take twice as long to compile.
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
    looks = _looks(source)
    repeated = _repeated(looks)
    sites = _sites(looks)
    lengths: dict[str, int] = {}
    chosen: set[str] = set()

    def settle(name: str) -> None:
        """Decide about a function, after those that it calls."""
        calls = looks[name].calls
        known = calls.keys() & looks.keys()
        for callee in known:
            if callee not in lengths:
                settle(callee)
        put_in = sum(calls[callee] * lengths[callee] for callee in known & chosen)
        lengths[name] = looks[name].nodes + put_in
        if name in repeated and sites[name] * lengths[name] <= MOST_NODES:
            chosen.add(name)

    for name in looks:
        if name not in lengths:
            settle(name)
    return frozenset(chosen)


def merged(source: str) -> frozenset[str]:
    r"""Return the names of the functions that become part of the one place that calls them.

    They have no for loop and are not compiled in place: they only put stages in order.

    Examples
    --------
    >>> both = "def both(x):\n    move(x)\n    solve(x)\n"
    >>> sorted(merged(both + "def run(x):\n    both(x)\n"))
    ['both']
    """
    looks = _looks(source)
    sites, in_place = _sites(looks), inlined(source)
    return frozenset(
        name
        for name, look in looks.items()
        if sites[name] == 1 and not look.has_loop and name not in in_place
    )


class _Look(NamedTuple):
    """A function's length, the names that it calls, and those that it calls in for loops."""

    nodes: int
    calls: Counter[str]
    calls_in_loops: set[str]
    has_loop: bool


@cache
def _looks(source: str) -> dict[str, _Look]:
    return {f.name: _look(f) for f in ast.parse(source).body if isinstance(f, ast.FunctionDef)}


def _sites(looks: dict[str, _Look]) -> Counter[str]:
    return sum((look.calls for look in looks.values()), Counter[str]())


def _look(function: ast.FunctionDef) -> _Look:
    nodes, calls, in_loops, has_loop = 0, Counter[str](), set[str](), False
    ahead: list[tuple[ast.AST, bool]] = [(function, False)]
    while ahead:
        node, is_in_loop = ahead.pop()
        nodes += 1
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            calls[node.func.id] += 1
            if is_in_loop:
                in_loops.add(node.func.id)
        has_loop = has_loop or isinstance(node, ast.For)
        within = is_in_loop or isinstance(node, ast.For)
        ahead.extend((child, within) for child in ast.iter_child_nodes(node))
    return _Look(nodes, calls, in_loops, has_loop)


def _repeated(looks: dict[str, _Look]) -> set[str]:
    """Return the functions that for loops call, and those that these call in turn."""
    found: set[str] = set()
    new = {name for look in looks.values() for name in look.calls_in_loops} & looks.keys()
    while new:
        found |= new
        new = {callee for name in new for callee in looks[name].calls} & looks.keys() - found
    return found
