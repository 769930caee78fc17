"""Takes code apart into the statements that define answers.

Kept are definitions, imports and assignments, and calls that fill a container
(``SETTINGS.update(...)``). Left out are other bare calls (prints, plots, checks), loops without an
end, what awaits something, imports that are not on the list, and what cannot be without these.

Reading runs no code, but may take any time and memory: it is done in a process of its own.
"""

from __future__ import annotations

import ast
import base64
import codeop
import json
import marshal
import re
import sys
import warnings
from collections.abc import Callable, Collection, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from functools import cache, lru_cache
from typing import Any

from . import files, limits
from .imports import may_be_imported
from .winnowing import fingerprints

MAGIC = re.compile(
    r"^([ \t]*)(?:(?:\w[\w, ]*=[ \t]*)?[%!].*|\?.*|[\w.]+\?{1,2}[ \t]*)$", re.MULTILINE
)
"""Lines that a notebook understands and Python does not: %magic, !command, x = !command, name?."""

FOREIGN = re.compile(
    r"\s*%%(bash|sh|html|javascript|js|latex|markdown|svg|script|writefile|perl)\b"
)
"""How a cell in another language begins."""

INDENT = re.compile(r"(?:[ \t]*\n)*([ \t]*)")
"""The indent of a cell's first line that is not empty."""

DEFINITION = re.compile(r"^[ \t]*def[ \t]+([A-Za-z_]\w*)", re.MULTILINE)
"""Where a function begins in code that cannot be read."""

FILLS = ("update", "append", "extend", "add", "insert", "setdefault", "sort", "reverse")
"""Methods that a bare call may fill a container with."""

LONGEST_LINE = 80
"""Characters of a line with an error in it that are shown."""

SECONDS, MOST_MEMORY = 2, 1_000_000_000
"""Of the processor, and bytes, that one request may take; a chapter's answers take 10 ms."""

UNPARSABLE = (SyntaxError, ValueError, RecursionError, MemoryError)
"""What reading code may end in."""

DEFINITIONS = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)


def parsed(source: str) -> list[ast.stmt]:
    """Return the statements of some code, without a word about its style."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return ast.parse(source).body


def read(sources: Iterable[dict[str, Any]]) -> list[dict[str, Any]]:
    """Return each source as a unit: its code, and which of its statements are kept.

    Statements are named by their place. They stand in groups; a cell is one group, and in a
    program each statement is its own. `lines` says where each statement begins, `left_out` which
    names come from which import or await, `missing` which names stand for nothing once that is
    gone, `uses` which names stand in the definition of another, `prints` the fingerprints of
    functions, and `codes` what is kept, compiled.

    Parameters
    ----------
    sources : iterable of dict
        Each with a ``name``, a ``source``, and whether it ``is_cell``.

    Returns
    -------
    list of dict
        Of a source that cannot be read, why (``unreadable``), and which functions are ``lost``.
    """
    units: list[dict[str, Any]] = []
    bodies: list[list[ast.stmt]] = []
    for given in sources:
        name, source = given["name"], given["source"]
        try:
            code, body = _cell(source) if given["is_cell"] else (source, parsed(source))
        except UNPARSABLE as error:
            lost = DEFINITION.findall(source)
            units.append({"unreadable": _unreadable(name, error), "lost": lost})
            bodies.append([])
        else:
            units.append({"name": name, "source": code, "is_cell": given["is_cell"]})
            bodies.append(body)
    missing = _missing([statement for body in bodies for statement in body])
    compiler = codeop.Compile()  # of which a from __future__ import holds for all that follows
    for unit, body in zip(units, bodies, strict=True):
        if "unreadable" not in unit:
            unit |= _kept_of(body, missing, is_cell=unit.pop("is_cell"))
            unit["codes"] = _codes(unit, body, compiler)
    _named.cache_clear()
    return units


def file(path: str) -> dict[str, Any]:
    """Return what stands in a file that was handed in, its sources read as ``units``."""
    found = files.handed_in(path)
    if "problem" not in found:
        found["units"] = read(found.pop("sources"))
    return found


def _kept_of(body: list[ast.stmt], missing: set[str], *, is_cell: bool) -> dict[str, Any]:
    """Return what a unit holds beside its name and source."""
    prints = fingerprints(body)
    kept = [index for index, part in enumerate(body) if kept_part(part, missing) is not None]
    return {
        "groups": [kept] if is_cell else [[index] for index in kept],
        "lines": [statement.lineno for statement in body],
        "functions": [part.name for part in body if isinstance(part, ast.FunctionDef)],
        "left_out": dict(_left_out(body)),
        "missing": sorted(missing),
        "uses": {name: sorted(used) for name, used in _uses(body).items()},
        "prints": prints,
    }


def _codes(
    unit: dict[str, Any], body: list[ast.stmt], compiler: codeop.Compile
) -> list[str | None]:
    """Return the kept statements compiled, for a child to load; None for all others.

    So no child parses what has been parsed here.
    """
    codes: list[str | None] = [None] * len(body)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for index in (index for group in unit["groups"] for index in group):
            try:
                code = compiled(body[index], unit, compiler)
            except UNPARSABLE:  # a child finds out, too, and says where
                continue
            codes[index] = base64.b64encode(marshal.dumps(code)).decode()
    return codes


def compiled(statement: ast.stmt, unit: dict[str, Any], compiler: codeop.Compile) -> Any:
    """Return what is kept of a statement as code."""
    tree = ast.Module([kept_part(statement, unit["missing"]) or statement], type_ignores=[])
    return compiler(tree, unit["name"], "exec")  # type: ignore[arg-type] # a tree


def _uses(body: Iterable[ast.stmt]) -> dict[str, set[str]]:
    """Return which names each definition and assignment at top level looks up, by its own name."""
    uses: dict[str, set[str]] = {}
    for statement in body:
        if isinstance(statement, DEFINITIONS):
            given = [statement.name]
        elif isinstance(statement, ast.Assign | ast.AnnAssign):
            given = sorted(_named(statement).given)
        else:
            continue
        for name in given:
            uses[name] = uses.get(name, set()) | _names(statement)
    return uses


def kept_sources(unit: dict[str, Any]) -> list[str]:
    """Return the kept statements of each group of a unit, as they were written."""
    body, missing = parsed(unit["source"]), unit["missing"]
    return [
        "\n\n".join(_written(body[index], missing, unit["source"]) for index in group)
        for group in unit["groups"]
    ]


def kept_part(statement: ast.stmt, missing: Collection[str]) -> ast.stmt | None:
    """Return what is kept of a statement: all, the listed ones of its imports, or None.

    A definition is kept without the decorators and annotations that are missing: an answer compiled
    by Numba is called as it is written.
    """
    if isinstance(statement, ast.Import):
        names = [alias for alias in statement.names if may_be_imported(alias.name)]
        return ast.copy_location(ast.Import(names), statement) if names else None
    if isinstance(statement, ast.ImportFrom):
        is_listed = statement.level > 0 or may_be_imported(statement.module or "")
        return statement if is_listed else None
    if isinstance(statement, DEFINITIONS):
        asks = not _names(statement).isdisjoint(missing)
        return _without(statement, set(missing)) if asks else statement
    asks = not _names(statement).isdisjoint(missing)
    return None if asks or _is_left_out(statement) else statement


def _without(definition: Any, missing: set[str]) -> ast.stmt:
    """Return a definition without the decorators and annotations that ask for what is missing."""
    decorators = definition.decorator_list
    definition.decorator_list = [each for each in decorators if not _names(each) & missing]
    for part in _nodes(definition, ast.arg | ast.FunctionDef):
        for field in ("annotation", "returns"):
            said = getattr(part, field, None)
            if said and _names(said) & missing:
                setattr(part, field, None)
    statement: ast.stmt = definition
    return statement


def _missing(statements: Iterable[ast.stmt]) -> set[str]:
    """Return the names that stand for nothing without the imports and awaits that are left out.

    What gets its value from such a name is missing, too: the figure of a plot, and what is drawn
    in it.
    """
    statements = list(statements)
    missing = {name for name, _ in _left_out(statements)}
    missing -= {part.name for part in statements if isinstance(part, DEFINITIONS)}
    missing -= {
        alias.asname or alias.name.partition(".")[0]
        for part in statements
        if isinstance(part, ast.Import | ast.ImportFrom)
        for alias in getattr(kept_part(part, ()), "names", ())
    }
    for statement in statements:
        is_kept = isinstance(statement, ast.Assign | ast.AnnAssign) and not _waits(statement)
        if missing and is_kept:
            bound = _named(statement).given
            if _names(statement) & missing:
                missing |= bound
            else:
                missing -= bound
    return missing


def _left_out(body: Iterable[ast.stmt]) -> Iterator[tuple[str, str]]:
    """Yield what gives a name at top level and is left out, by that name."""
    for statement in body:
        if isinstance(statement, ast.Import | ast.ImportFrom):
            kept = getattr(kept_part(statement, ()), "names", ())
            for alias in statement.names:
                if alias not in kept:
                    module = getattr(statement, "module", None) or alias.name
                    name = (alias.asname or alias.name).partition(".")[0]
                    yield name, f"an import of {module.partition('.')[0]}"
        elif not isinstance(statement, DEFINITIONS) and _waits(statement):
            yield from ((name, AWAITED) for name in sorted(_named(statement).given))


def _nodes(tree: ast.AST, kind: Any) -> Iterator[Any]:
    """Yield the nodes of a kind, in any order."""
    left: list[Any] = [tree]
    while left:
        node = left.pop()
        if isinstance(node, kind):
            yield node
        for name in _with_nodes(node.__class__):
            value = getattr(node, name, None)
            if isinstance(value, ast.AST):
                left.append(value)
            elif isinstance(value, list):
                left += [part for part in value if isinstance(part, ast.AST)]


WITHOUT_NODES = ("ctx", "op", "ops", "id", "arg", "attr", "kind", "type_comment", "module", "level")
"""Fields of a node in which no other stands, but the signs of operators and the like."""


@cache
def _with_nodes(kind: type[ast.AST]) -> tuple[str, ...]:
    """Return the fields of a kind of node in which others may stand."""
    if kind is ast.Constant:
        return ()
    return tuple(name for name in kind._fields if name not in WITHOUT_NODES)


@dataclass(frozen=True)
class _Named:
    """The names in code: whose values it asks for, and which get one; and whether it awaits."""

    asked: set[str]
    given: set[str]
    awaits: bool


AWAITED = "a line with await"

AWAITING = (ast.Await, ast.AsyncFor, ast.AsyncWith)


@lru_cache(maxsize=2 * files.MOST_CELLS)  # a statement is asked several times; `read` forgets them
def _named(tree: ast.AST) -> _Named:
    """Return the names in some code."""
    names: dict[type, set[str]] = {ast.Load: set(), ast.Store: set(), ast.Del: set()}
    awaits = False
    for node in _nodes(tree, (ast.Name, *AWAITING)):
        if type(node) is ast.Name:
            names[type(node.ctx)].add(node.id)
        else:
            awaits = True
    return _Named(names[ast.Load], names[ast.Store], awaits)


def _names(tree: ast.AST) -> set[str]:
    """Return the names whose values some code asks for."""
    return _named(tree).asked


def _cell(source: str) -> tuple[str, list[ast.stmt]]:
    """Return a cell's code and statements.

    If it cannot be read as it is, the indent of its first line is taken off all lines, as IPython
    does, and if need be magics are commented out. A cell in another language is no code at all.
    """
    if FOREIGN.match(source):
        return "", []
    with suppress(*UNPARSABLE):
        return source, parsed(source)
    indent = INDENT.match(source)
    if indent and indent[1]:
        source = re.sub(rf"^{indent[1]}", "", source, flags=re.MULTILINE)
        with suppress(*UNPARSABLE):
            return source, parsed(source)
    code = MAGIC.sub(r"\1pass  # a magic, left out", source)
    return code, parsed(code)


def _unreadable(name: str, error: Exception) -> str:
    """Return in a line where the syntax is wrong."""
    if isinstance(error, SyntaxError):
        line = (error.text or "").strip()[:LONGEST_LINE]
        return f"{name}, line {error.lineno}: {error.msg}{f', in: {line}' if line else ''}"
    return f"{name}: cannot be read ({error or type(error).__name__})"


def _is_left_out(statement: ast.stmt) -> bool:
    """Return whether a statement that imports and defines nothing is no part of an answer."""
    if isinstance(statement, ast.Expr):
        return not _sets_up(statement.value)
    if isinstance(statement, ast.Pass) or _never_ends(statement) or _waits(statement):
        return True
    return isinstance(statement, ast.If) and _asks_for_name(statement.test)


def _sets_up(expression: ast.expr) -> bool:
    """Return whether an expression fills a container of the answer's own: ``SETTINGS.update(a=1)``.

    Any other bare call, such as a print, a plot or a check, is left out.
    """
    match expression:
        case ast.Call(func=ast.Attribute(value=ast.Name(), attr=method)):
            return method in FILLS
    return False


def _never_ends(statement: ast.stmt) -> bool:
    """Return whether a statement is a loop without an end: a demo below the answers."""
    return (
        isinstance(statement, ast.While)
        and isinstance(statement.test, ast.Constant)
        and bool(statement.test.value)
        and not any(_nodes(statement, ast.Break))
    )


def _waits(statement: ast.stmt) -> bool:
    """Return whether a statement awaits something, which only a notebook can do."""
    return _named(statement).awaits


def _asks_for_name(test: ast.expr) -> bool:
    """Return whether a condition looks at ``__name__``."""
    return "__name__" in _names(test)


def _written(statement: ast.stmt, missing: Collection[str], source: str) -> str:
    """Return what is kept of a statement in its own words, decorators included."""
    before = ast.dump(statement)
    kept = kept_part(statement, missing) or ast.Pass()
    if ast.dump(kept) != before:
        return ast.unparse(kept)
    decorators = getattr(statement, "decorator_list", [])
    if decorators:
        statement.lineno, statement.col_offset = decorators[0].lineno, 0
    return ast.get_source_segment(source, statement) or ""


DEEDS: dict[str, Callable[[Any], Any]] = {
    "file": file,
    "sources": files.handed_in,
    "read": read,
    "kept": kept_sources,
    "lost": DEFINITION.findall,
}


def main() -> None:
    """Answer requests, each a line that names a deed and what to do it to.

    One that takes more than its time ends the process.
    """
    limits.lower_memory(MOST_MEMORY)
    for line in sys.stdin.buffer:
        limits.bound_time_from_now(SECONDS)
        deed, given = json.loads(line)
        sys.stdout.buffer.write(json.dumps(DEEDS[deed](given)).encode() + b"\n")
        sys.stdout.buffer.flush()
