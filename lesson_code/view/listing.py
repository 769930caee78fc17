"""Parts of a program's text: single functions out of it, to be read in a notebook."""

from __future__ import annotations

import ast
import inspect
from types import ModuleType


def functions(source: str) -> dict[str, str]:
    r"""Return the text of each function of a program, by its name, without its docstring.

    Parameters
    ----------
    source : str
        The text of a module, such as ``run.plan.source()``.

    Raises
    ------
    SyntaxError
        It is no program.

    Examples
    --------
    >>> print(functions('def f(x: int) -> int:\n    "Say why."\n    return x')["f"])
    def f(x: int) -> int:
        return x
    """
    lines = source.splitlines()
    return {
        node.name: _text_of(node, lines)
        for node in ast.parse(source).body
        if isinstance(node, ast.FunctionDef)
    }


def listing(source: str | ModuleType, *names: str) -> str:
    """Return the text of some functions of a program or a module, an empty line between them.

    Raises
    ------
    ValueError
        The program has no function of that name.
    """
    found = functions(inspect.getsource(source) if isinstance(source, ModuleType) else source)
    for name in names:
        if name not in found:
            raise ValueError(f"names must be those of functions in the program, got {name!r}")
    return "\n\n".join(found[name] for name in names)


def _text_of(node: ast.FunctionDef, lines: list[str]) -> str:
    """Return a function's text without its docstring."""
    kept = lines[node.lineno - 1 : node.body[0].lineno - 1]
    body = node.body[1:] if ast.get_docstring(node) is not None else node.body
    if body:
        kept += lines[body[0].lineno - 1 : node.end_lineno]
    return "\n".join(kept).rstrip()
