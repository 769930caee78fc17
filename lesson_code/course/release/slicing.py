"""The part of a module that a student's copy needs: some names, and all that these use.

A module of tasks holds the explanation of a wrong answer beside the right answer. Only the
explanation goes into a student's copy.
"""

from __future__ import annotations

import ast
from collections.abc import Collection, Iterable, Iterator, Mapping
from typing import TypeAlias

Names: TypeAlias = dict[str, set[str]]
"""Names that are wanted, by their module."""


IMPORT = ("import ", "from ")


def sliced(source: str, wanted: Iterable[str]) -> str:
    """Return those statements of a module that define some names, and what these use.

    Raises
    ------
    ValueError
        A name is not defined there.

    Examples
    --------
    >>> lines = ['import math', 'R = 2.0', 'def f(x):', '    return R * x', 'def g(x):', '    pass']
    >>> print(sliced(chr(10).join(lines), {"f"}))
    R = 2.0
    <BLANKLINE>
    <BLANKLINE>
    def f(x):
        return R * x
    """
    body = ast.parse(source).body
    needed = _closure(body, set(wanted))
    kept = [
        text
        for i, statement in enumerate(body)
        if (text := _kept(body, i, statement, needed, source))
    ]
    return "\n".join(_spaced(kept))


def replaced(source: str, function: str, text: str) -> str:
    r"""Return a module with some text in place of one of its functions.

    Examples
    --------
    >>> replaced("A = 1\ndef f():\n    return A\nB = 2", "f", "f = None").splitlines()
    ['A = 1', 'f = None', 'B = 2']
    """
    lines = source.splitlines()
    for statement in ast.parse(source).body:
        if isinstance(statement, ast.FunctionDef) and statement.name == function:
            lines[statement.lineno - 1 : statement.end_lineno] = [text]
    return "\n".join(lines)


def used_names(source: str, modules: Collection[str]) -> Names:
    """Return which names some code uses of some modules.

    Examples
    --------
    >>> used_names("from physics.tasks import draw; draw.speed()", ["physics.tasks.draw"])
    {'physics.tasks.draw': {'speed'}}
    """
    found: Names = {}
    if not any(module.rpartition(".")[0] in source for module in modules):
        return found  # most code imports none of them, and need not be taken apart
    tree = ast.parse(source)
    for module, name, called in _imported(tree):
        if f"{module}.{name}" in modules:
            attributes = {
                node.attr
                for node in ast.walk(tree)
                if isinstance(node, ast.Attribute)
                and isinstance(node.value, ast.Name)
                and node.value.id == called
            }
            found.setdefault(f"{module}.{name}", set()).update(attributes)
        elif module in modules:
            found.setdefault(module, set()).add(name)
    return found


def all_needed(sources: Mapping[str, str], wanted: Names) -> Names:
    """Return the names needed from each module: those wanted, and those that they use elsewhere."""
    needed: Names = {module: set() for module in wanted}
    waiting = [(module, name) for module, names in wanted.items() for name in sorted(names)]
    while waiting:
        module, name = waiting.pop()
        if name in needed.setdefault(module, set()):
            continue
        needed[module].add(name)
        for other, names in used_names(sliced(sources[module], {name}), sources).items():
            waiting += [(other, used) for used in sorted(names)]
    return needed


def _imported(tree: ast.AST) -> Iterator[tuple[str, str, str]]:
    """Yield module, name and what it is called here, for each name imported from a module."""
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.module:
            for alias in node.names:
                yield node.module, alias.name, alias.asname or alias.name


def _closure(body: list[ast.stmt], wanted: set[str]) -> set[str]:
    """Return the names that are wanted, and all that their definitions use."""
    defining = {name: statement for statement in body for name in _defined(statement)}
    needed, waiting = set[str](), list(wanted)
    while waiting:
        name = waiting.pop()
        if name in needed:
            continue
        if name not in defining:
            if name in wanted:
                raise ValueError(f"{name} is not defined in this module")
            continue
        needed.add(name)
        waiting += [n.id for n in ast.walk(defining[name]) if isinstance(n, ast.Name)]
    return needed


def _defined(statement: ast.stmt) -> Iterator[str]:
    """Yield the names that a statement defines."""
    if isinstance(statement, ast.FunctionDef | ast.ClassDef):
        yield statement.name
    elif isinstance(statement, ast.Import | ast.ImportFrom):
        yield from (alias.asname or alias.name.partition(".")[0] for alias in statement.names)
    elif isinstance(statement, ast.Assign | ast.AnnAssign):
        targets = statement.targets if isinstance(statement, ast.Assign) else [statement.target]
        yield from (n.id for t in targets for n in ast.walk(t) if isinstance(n, ast.Name))


def _kept(
    body: list[ast.stmt], place: int, statement: ast.stmt, needed: set[str], source: str
) -> str:
    """Return what is kept of a statement: all, some imported names, or nothing."""
    if isinstance(statement, ast.ImportFrom) and statement.module == "__future__":
        return ast.unparse(statement)
    if isinstance(statement, ast.Import | ast.ImportFrom):
        statement.names = [
            a for a in statement.names if (a.asname or a.name.partition(".")[0]) in needed
        ]
        return ast.unparse(statement) if statement.names else ""
    # A docstring is that of the module, or of the constant before it.
    is_docstring = isinstance(statement, ast.Expr)
    owner = body[place - 1] if is_docstring else statement
    if not (is_docstring and place == 0) and not set(_defined(owner)) & needed:
        return ""
    if isinstance(statement, ast.FunctionDef | ast.ClassDef) and statement.decorator_list:
        first = statement.decorator_list[0].lineno - 1
        return "\n".join(source.splitlines()[first : statement.end_lineno])
    return ast.get_source_segment(source, statement) or ""


def _spaced(statements: list[str]) -> Iterator[str]:
    """Yield statements with the blank lines that stand between definitions."""
    before = ""
    for text in statements:
        if before and (_is_definition(text) or _is_definition(before)):
            yield "\n"
        elif before.startswith(('"""', "from __future__")) or (
            before.startswith(IMPORT) and not text.startswith(IMPORT)
        ):
            yield ""
        yield text
        before = text


def _is_definition(text: str) -> bool:
    """Return whether a statement is a function or class."""
    return text.startswith(("def ", "class ", "@"))
