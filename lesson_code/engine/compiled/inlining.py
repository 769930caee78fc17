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
    calls = {name: _calls(function, functions) for name, function in functions.items()}
    repeated = _repeated(functions, calls)
    sites = sum(calls.values(), Counter[str]())
    lengths: dict[str, int] = {}
    chosen: set[str] = set()

    def settle(name: str) -> None:
        """Decide on a function, after those that it calls."""
        for callee in calls[name]:
            if callee not in lengths:
                settle(callee)
        lengths[name] = sum(1 for _ in ast.walk(functions[name])) + sum(
            count * lengths[callee] for callee, count in calls[name].items() if callee in chosen
        )
        if name in repeated and sites[name] * lengths[name] <= MOST_NODES:
            chosen.add(name)

    for name in functions:
        if name not in lengths:
            settle(name)
    return frozenset(chosen)


def _repeated(
    functions: dict[str, ast.FunctionDef], calls: dict[str, Counter[str]]
) -> frozenset[str]:
    """Return what a for loop calls, and what that calls in turn."""
    found: set[str] = set()
    new = {
        name
        for function in functions.values()
        for loop in ast.walk(function)
        if isinstance(loop, ast.For)
        for name in _calls(loop, functions)
    }
    while new:
        found |= new
        new = {callee for name in new for callee in calls[name]} - found
    return frozenset(found)


def _calls(function: ast.AST, known: dict[str, ast.FunctionDef]) -> Counter[str]:
    """Return which functions of the program a function calls, and from how many places."""
    names = [
        node.func.id
        for node in ast.walk(function)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)
    ]
    return Counter(name for name in names if name in known)
