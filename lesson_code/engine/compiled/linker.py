"""The linker: one program out of the engine's functions, as readable source.

A run needs few of the engine's functions: one broad phase, one solver, perhaps no listener. The
linker begins at one function, follows every call, and writes the functions that it meets into one
module, each after those that it calls. What is decided before the run is worked out:

- an argument that is bound to a function, a tuple of stages or None disappears, and a call through
  it becomes a call of that function;
- a branch that can no longer be reached disappears too;
- constants are at the top of the module, with the values that they have now.

Nothing else is changed. A function in which nothing had to be worked out is copied as it stands,
comments and all, so that the program is made of the very lines that the lesson shows.
"""

from __future__ import annotations

import ast
import functools
import inspect
import math
import re
import sys
import types
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple, TypeAlias

from lesson_code.engine.compiled import lanes
from lesson_code.engine.compiled.known import is_stage, known_value

PROJECT = "lesson_code."
"""Functions are taken into a program if their module's name begins like this."""

PROGRAMS_REMEMBERED = 64
"""Programs that a process holds as text, some 50 kB each."""

FUNCTION = re.compile(r"^def (\w+)\(.*?(?=^[^\s)]|\Z)", re.MULTILINE | re.DOTALL)
"""A function of a module: it ends where the next line begins at the margin."""

Names: TypeAlias = Mapping[str, Any]
Read: TypeAlias = list[tuple[Names, dict[str, Any]]]
"""What names have been looked up while linking: in which module, and what they stood for."""

Key: TypeAlias = tuple[Any, ...]


def link(entry: Callable[..., Any], **bound: Any) -> str:
    """Return the source of the program that a function needs, some of its arguments bound.

    Parameters
    ----------
    entry : callable
        Where the program begins: a function of a module of this project. It keeps its name.
    **bound : object
        Values for some of its parameters: functions, named tuples of functions and flags, None.

    Returns
    -------
    str
        A module in which `entry` has lost the parameters that are bound.

    Raises
    ------
    TypeError
        A function uses a name that stands for neither a function, a class nor a constant.

    Examples
    --------
    >>> from lesson_code.engine.event_driven.motion import velocity_at
    >>> print(link(velocity_at))
    from __future__ import annotations
    <BLANKLINE>
    <BLANKLINE>
    def velocity_at(disc: DiscRow, time: float) -> Pair:
        \"\"\"Return a disc's velocity at a time, m/s.\"\"\"
        t = time - disc.time
        return (disc.vx + disc.ax * t, disc.vy + disc.ay * t)
    <BLANKLINE>
    """
    key = entry, tuple(sorted(bound.items()))
    if not _linked(*key).is_current():
        _linked.cache_clear()
    return _linked(*key).text


class Linked(NamedTuple):
    """A program, and what it was made of: the values that its functions' global names had."""

    text: str
    read: Read

    def is_current(self) -> bool:
        """Return whether all those names still stand for the same."""
        return all(
            now.get(name) is value for now, names in self.read for name, value in names.items()
        )


@functools.lru_cache(maxsize=PROGRAMS_REMEMBERED)
def _linked(entry: Callable[..., Any], bound: tuple[tuple[str, Any], ...]) -> Linked:
    """Return a program, which is made once."""
    from lesson_code.engine.compiled import sources  # a small run links nothing

    given = dict(bound) | _stages_by_default(entry, set(dict(bound)))
    if (kept := sources.find(entry, given)) is not None:
        return kept
    program = _Program()
    program.add(entry, given)
    linked = Linked(program.source(), program.read)
    sources.keep(entry, given, linked)
    return linked


class _Program:
    """A module under construction: its imports, constants and functions, each once."""

    def __init__(self) -> None:
        self.read: Read = []
        self._imports: set[str] = set()
        self._constants: dict[str, Any] = {}
        self._functions: dict[str, str] = {}
        self._names: dict[Key, str] = {}

    def source(self) -> str:
        """Return the module as text."""
        head = "\n".join(["from __future__ import annotations", "", *sorted(self._imports)])
        constants = "\n".join(f"{name} = {_text(v)}" for name, v in self._constants.items())
        top = "\n\n".join(part for part in (head.rstrip(), constants) if part)
        return "\n\n\n".join([top, *self._functions.values()]) + "\n"

    def add(self, function: Any, bound: Names) -> str:
        """Add a function and all that it calls; return its name in the program."""
        function = inspect.unwrap(function)
        key: tuple[Any, ...] = (
            function,
            tuple((name, id(value)) for name, value in sorted(bound.items())),
        )
        if key not in self._names:
            name = self._free_name(function)
            self._names[key] = name
            known = function.__globals__
            names = function.__code__.co_names
            self.read.append((known, {n: known[n] for n in names if n in known}))
            text = _functions_of(function.__module__)[function.__name__]
            tree = _definition(text)
            tree.name = name
            _Specialised(self, function, bound, tree).rewrite()
            is_same = _are_alike(tree, _original(text))
            self._functions[name] = text if is_same else ast.unparse(tree)
        return self._names[key]

    def use(self, name: str, value: Any, user: str) -> None:
        """Take a name that a function uses into the program."""
        if isinstance(value, types.ModuleType):
            own = "" if name == value.__name__ else f" as {name}"
            self._imports.add(f"import {value.__name__}{own}")
        elif isinstance(value, type):
            self._imports.add(f"from {value.__module__} import {value.__name__}")
        elif not isinstance(value, (bool, int, float, str, tuple)):
            raise TypeError(f"{name} in {user} must be a function, class or constant: {value!r}")
        elif self._constants.setdefault(name, value) != value:
            raise TypeError(f"{name} in {user} must have one value in the whole program: {value!r}")

    def take_in(self, function: Any) -> str:
        """Import a function under a name that says where it comes from, and return that."""
        module, name = function.__module__, function.__name__
        own = f"{module.rpartition('.')[2]}_{name}"
        self._imports.add(f"from {module} import {name} as {own}")
        return own

    def hold(self, name: str, value: Any) -> str:
        """Take in what a stage outside the program is given, and return its name.

        A function is imported; a list that the stages of a run share begins empty.
        """
        if not isinstance(value, list):
            return self.take_in(value)
        self._constants[name] = []
        return name

    def _free_name(self, function: Any) -> str:
        """Return a function's name; if it is taken, with that of its module in front."""
        name: str = function.__name__
        while name in self._names.values():
            name = f"{function.__module__.rpartition('.')[2]}_{name}"
        return name


class _Specialised(ast.NodeTransformer):
    """Rewrites one function for the values that some of its names are bound to."""

    def __init__(
        self, program: _Program, function: Any, bound: Names, tree: ast.FunctionDef
    ) -> None:
        self._program, self._function, self._tree = program, function, tree
        local = _local_names(function.__code__)
        self._global = {n: v for n, v in function.__globals__.items() if n not in local}
        self._known = self._global | dict(bound)
        self._bound = bound

    def rewrite(self) -> None:
        """Rewrite the function in place."""
        arguments = self._tree.args
        kept = [arg for arg in arguments.args if arg.arg not in self._bound]
        free = len(arguments.args) - len(arguments.defaults)
        arguments.defaults = [
            self.visit(default)
            for arg, default in zip(arguments.args[free:], arguments.defaults, strict=True)
            if arg in kept
        ]
        arguments.args = kept
        self._tree.body = self._block(self._tree.body)

    def _block(self, body: list[ast.stmt]) -> list[ast.stmt]:
        """Return the statements of a block that remain."""
        kept: list[ast.stmt] = []
        for statement in body:
            if kept and isinstance(kept[-1], ast.Return):
                break  # what follows cannot be reached
            if isinstance(statement, ast.If) and (test := self._value(statement.test)):
                kept += self._block(statement.body if test.value else statement.orelse)
            elif not (isinstance(statement, ast.Assign) and self._is_about_stages(statement)):
                kept.append(self.visit(statement))
        return kept

    def _is_about_stages(self, node: ast.Assign) -> bool:
        """Note which names stand for stages; return whether the assignment can be dropped."""
        if len(node.targets) > 1:  # a = b = value
            return False
        (target,) = node.targets
        pairs = [(target, node.value)]
        if isinstance(target, ast.Tuple) and isinstance(node.value, ast.Tuple):
            pairs = list(zip(target.elts, node.value.elts, strict=True))
        left = []
        for name, value in pairs:
            if isinstance(name, ast.Name) and self._is_stage(value):
                self._known[name.id] = known_value(value, self._known).value  # type: ignore[union-attr]
            else:
                left.append((name, value))
        if len(left) == 1 and len(pairs) > 1:
            node.targets, node.value = [left[0][0]], left[0][1]
        elif len(left) < len(pairs):
            node.targets = [ast.Tuple([name for name, _ in left], ast.Store())]
            node.value = ast.Tuple([value for _, value in left], ast.Load())
        return not left

    def _value(self, node: ast.expr) -> Any:
        """Return what is known of an expression."""
        return known_value(node, self._known)

    def _is_stage(self, node: ast.expr) -> bool:
        """Return whether an expression stands for a function or a tuple of stages."""
        found = None if isinstance(node, ast.Constant) else self._value(node)
        return found is not None and is_stage(found.value)

    # What ast.NodeTransformer calls, by the kind of node

    def generic_visit(self, node: ast.AST) -> ast.AST:
        """Visit the parts of a node; its blocks of statements as blocks."""
        for name, part in ast.iter_fields(node):
            if isinstance(part, list) and part and isinstance(part[0], ast.stmt):
                block = self._block(part)
                setattr(node, name, block or ([ast.Pass()] if name == "body" else []))
            elif isinstance(part, list):
                part[:] = [self.visit(item) for item in part]
            elif isinstance(part, ast.AST) and name not in ("annotation", "returns"):
                setattr(node, name, self.visit(part))
        return node

    def visit_BoolOp(self, node: ast.BoolOp) -> ast.expr:
        """Remove the operands of `and` and `or` that are known and do not decide."""
        if found := self._value(node):
            return ast.Constant(found.value)
        node.values = [self.visit(part) for part in node.values if not self._value(part)]
        return node if len(node.values) > 1 else node.values[0]

    def visit_IfExp(self, node: ast.IfExp) -> ast.AST:
        """Choose the branch if the condition is known."""
        if test := self._value(node.test):
            chosen: ast.AST = self.visit(node.body if test.value else node.orelse)
            return chosen
        return self.generic_visit(node)

    def visit_Call(self, node: ast.Call) -> ast.AST:
        """Call the function of the program that a call of the project's stands for."""
        found = self._value(node.func)
        if found and _is_outside(found.value):
            return self._imported(node, found.value)
        if not (found and isinstance(found.value, types.FunctionType) and _is_ours(found.value)):
            return self.generic_visit(node)
        called = inspect.unwrap(found.value)
        given = list(zip(_parameters_of(called), node.args, strict=False))
        bound = {name: self._value(arg).value for name, arg in given if self._is_stage(arg)}
        by_name = {word.arg: word.value for word in node.keywords if word.arg}
        bound |= {n: self._value(arg).value for n, arg in by_name.items() if self._is_stage(arg)}
        node.args = [self.visit(arg) for name, arg in given if name not in bound]
        node.keywords = [word for word in node.keywords if word.arg not in bound]
        for keyword in node.keywords:
            keyword.value = self.visit(keyword.value)
        bound |= _stages_by_default(called, {name for name, _ in given} | set(by_name))
        name = self._program.add(called, bound)
        if not (isinstance(node.func, ast.Name) and node.func.id == name):
            node.func = ast.Name(name, ast.Load())
        return node

    def _imported(self, node: ast.Call, stage: Any) -> ast.Call:
        """Call a function that stays outside the program.

        Its defaults stand for known arguments; those of a partial function are written out here.
        """
        given = stage.keywords if isinstance(stage, functools.partial) else {}
        function = stage.func if given else stage
        node.func = ast.Name(self._program.take_in(function), ast.Load())
        node.args = [self.visit(arg) for arg in node.args if not self._is_stage(arg)]
        node.keywords = [
            ast.keyword(name, ast.Name(self._program.hold(name, value), ast.Load()))
            for name, value in given.items()
        ]
        return node

    def visit_Attribute(self, node: ast.Attribute) -> ast.AST:
        """Write a flag of a tuple of stages as its value."""
        owner = self._value(node.value)
        if owner and hasattr(owner.value, "_fields"):
            return ast.Constant(getattr(owner.value, node.attr))
        return self.generic_visit(node)

    def visit_Name(self, node: ast.Name) -> ast.Name:
        """Take a name of the function's module into the program."""
        if isinstance(node.ctx, ast.Load) and node.id in self._global:
            self._program.use(node.id, self._global[node.id], self._function.__name__)
        return node


def _stages_by_default(function: Any, given: set[str]) -> dict[str, Any]:
    """Return the stages that a function takes for parameters that are not given."""
    return {
        name: parameter.default
        for name, parameter in _parameters_of(function).items()
        if name not in given and parameter.default is not parameter.empty
        if is_stage(parameter.default)
    }


def _is_outside(stage: Any) -> bool:
    """Return whether a function, or part of one, is of no program: what Numba knows by itself.

    So are those of lanes, and those of a solver that is not compiled.
    """
    function = stage.func if isinstance(stage, functools.partial) else stage
    if getattr(function, "__module__", None) == lanes.__name__:
        return True
    module = sys.modules.get(getattr(function, "__module__", None) or "")
    return bool(getattr(getattr(module, "SOLVER", None), "never_compiled", ""))


def _is_ours(function: Any) -> bool:
    """Return whether a function belongs to this project."""
    return str(function.__module__).startswith(PROJECT)


def _local_names(code: types.CodeType) -> set[str]:
    """Return the names that a function gives values to, also within its comprehensions."""
    inner = (part for part in code.co_consts if isinstance(part, types.CodeType))
    return {*code.co_varnames, *code.co_cellvars}.union(*map(_local_names, inner))


@functools.cache
def _functions_of(module: str) -> dict[str, str]:
    """Return the source of each of a module's functions, without decorators."""
    text = inspect.getsource(sys.modules[module])
    return {found[1]: found[0].rstrip() for found in FUNCTION.finditer(text)}


@functools.cache
def _original(text: str) -> ast.FunctionDef:
    """Return the tree of a function's source, which nobody changes."""
    return _definition(text)


def _definition(text: str) -> ast.FunctionDef:
    """Return the tree of a function's source."""
    (tree,) = ast.parse(text).body
    if not isinstance(tree, ast.FunctionDef):  # pragma: no cover - it was found as one
        raise TypeError(f"{text.splitlines()[0]} must define a function")
    return tree


def _are_alike(one: Any, other: Any) -> bool:
    """Return whether two trees, or parts of them, say the same."""
    if type(one) is not type(other):
        return False
    if isinstance(one, ast.AST):
        return all(_are_alike(getattr(one, f), getattr(other, f)) for f in one._fields)
    if isinstance(one, list):
        return len(one) == len(other) and all(map(_are_alike, one, other))
    return bool(one == other)


@functools.cache
def _parameters_of(function: Any) -> Mapping[str, inspect.Parameter]:
    """Return a function's parameters by name."""
    return inspect.signature(inspect.unwrap(function)).parameters


def _text(value: Any) -> str:
    """Return a constant as source; infinities have no literals of their own."""
    if isinstance(value, tuple):
        return "(" + "".join(f"{_text(part)}, " for part in value) + ")"
    is_infinite = isinstance(value, float) and math.isinf(value)
    return f"float('{value}')" if is_infinite else repr(value)
