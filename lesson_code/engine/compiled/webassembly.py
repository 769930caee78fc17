"""Programs for web pages: the same sources as WebAssembly, which every browser runs.

Numba compiles a program for a processor without any special features, LLVM turns that into
WebAssembly, and its linker makes a module. No operation is reordered, left out or fused on the way,
so a page gets the bits that Python gets. Sine, cosine and exponential are lent by the page: those
of Chromium are the ones of glibc, and in another browser the last bit may differ.

The linker is the package ``ziglang``, which only those need who change a program. A module says
itself what it was made of, in a section named :data:`SECTION`: how its tables lie in memory, what
its functions take, and a sum over its sources, in which any change of a formula shows.
"""

from __future__ import annotations

import ast
import hashlib
import json
import math
import os
import pickle
import platform
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import MISSING, dataclass, fields, replace
from importlib import metadata
from inspect import Parameter, signature, unwrap
from pathlib import Path
from typing import Any, NamedTuple

from lesson_code.engine.compiled.arrays import dtype_of, row_kinds
from lesson_code.engine.compiled.linker import link
from lesson_code.engine.compiled.program import Layout, Program, program_of
from lesson_code.formulas.validation import VECTOR_RULES, polygon_vertices

SECTION = "workbook"
"""The name of the section in which a module says what it was made of."""

LENT = ("cos", "exp", "sin", "sqrt")
"""The functions that a page lends: those of JavaScript's Math. Its sqrt is exact."""

FEATURES = "+bulk-memory,+mutable-globals,+nontrapping-fptoint,+sign-ext"
"""What LLVM may use: every browser since 2021 has these."""

STACK = 1 << 16
"""Bytes for the variables of functions that are under way."""

NUMBA = {
    "NUMBA_CPU_NAME": "generic",
    "NUMBA_CPU_FEATURES": "",
    "NUMBA_LOOP_VECTORIZE": "0",
    "NUMBA_SLP_VECTORIZE": "0",
}
"""Numba's settings, with which it makes the same on every machine."""

HOUSE = Path(__file__).parents[3]
"""Where the package lies."""


@dataclass(frozen=True)
class WebProgram:
    """What goes into one module.

    Attributes
    ----------
    entries : mapping of str to Program
        What can be called, by name.
    about : mapping
        What the page has to know, as JSON can hold it.
    """

    entries: Mapping[str, Program]
    about: Mapping[str, Any]

    def telling(self, **more: Any) -> WebProgram:
        """Return the program with more that the page has to know."""
        return replace(self, about={**self.about, **more})

    @property
    def fingerprint(self) -> str:
        """A sum over all sources: not over comments and docstrings, nor how Python writes them."""
        told = [
            (name, program.entry, list(_words(ast.parse(program.source))))
            for name, program in sorted(self.entries.items())
        ]
        words = json.dumps([told, self.about], sort_keys=True)
        return hashlib.sha256(words.encode()).hexdigest()


# Tables


def table_program(tables: type, *entries: Callable[..., Any], **bound: Any) -> WebProgram:
    """Return a program that works on a named tuple of tables.

    Parameters
    ----------
    tables : type
        The kind of named tuple.
    *entries : callable
        What a page calls: each takes the tables, and perhaps stages that are bound.
    **bound : object
        As :func:`lesson_code.engine.compiled.linker.link` takes them.
    """
    sources = {entry.__name__: link(entry, **bound) for entry in entries}
    whole = program_of("\n".join(sources.values()), "", tables)
    programs = {name: Program(text, name, whole.layout) for name, text in sources.items()}
    return WebProgram(programs, {"tables": described(whole, tables)})


def described(program: Program, tables: type) -> list[dict[str, Any]]:
    """Return how a program's tables lie in memory.

    For each field of a row: the byte that it begins at, its kind as NumPy names it (``f8``), and
    with what it begins, unless that is zero.
    """
    rows = row_kinds(tables)
    return [
        {
            "name": name,
            "single": not is_list,
            "bytes": dtype.itemsize,
            "fields": {
                field: [place[1], place[0].str[1:], *_starts(rows[name])[field]]
                for field, place in (dtype.fields or {}).items()
            },
        }
        for name, dtype, is_list in program.layout
    ]


def _starts(row: Any) -> dict[str, list[Any]]:
    """Return for each field of a row what it begins with, in a list; an empty one for zero."""
    defaults = {field.name: field.default for field in fields(row)}
    return {
        name: [] if value is MISSING or not value else [_number(value)]
        for name, value in defaults.items()
    }


def _number(value: Any) -> Any:
    """Return a number, or its name in JavaScript, where JSON has none for it."""
    return {math.inf: "Infinity", -math.inf: "-Infinity"}.get(value, value)


# Formulas


@dataclass(slots=True)
class NumberRow:
    """A number: first those that a function takes, then those that it returns."""

    value: float = 0.0


@dataclass(slots=True)
class CornerRow:
    """A corner of a polygon that a function takes."""

    x: float = 0.0  # m
    y: float = 0.0


class Numbers(NamedTuple):
    """The tables of formulas."""

    numbers: list[NumberRow]
    corners: list[CornerRow]


def formula_program(formulas: Mapping[str, Callable[..., Any]]) -> WebProgram:
    """Return a program that holds the equations of formulas, by name.

    A page calls them with the arguments that the formulas take in Python.
    """
    entries = {name: _equation(name, formula) for name, formula in formulas.items()}
    told = {
        name: [_told(formula, given) for given in signature(formula).parameters.values()]
        for name, formula in formulas.items()
    }
    tables = described(next(iter(entries.values())), Numbers)
    return WebProgram(entries, {"tables": tables, "functions": told})


def _told(formula: Any, given: Parameter) -> list[Any]:
    """Return an argument's name and kind, and what it is if it is left out."""
    start = [] if given.default is given.empty else [given.default]
    return [given.name, _kind(formula.rules[given.name]), *start]


def _kind(rule: Any) -> str:
    """Return what a page gives for an argument with a rule."""
    return "polygon" if rule is polygon_vertices else "vector" if rule in VECTOR_RULES else "number"


def _equation(name: str, formula: Any) -> Program:
    """Return the program of an equation: it takes its numbers from a table."""
    taken: list[str] = []
    place = 0
    for argument in signature(formula).parameters:
        kind = _kind(formula.rules[argument])
        if kind == "polygon":
            taken.append("tables.corners")
        elif kind == "vector":
            taken.append(f"vector({_at(place)}, {_at(place + 1)})")
        else:
            taken.append(_at(place))
        place += {"polygon": 0, "number": 1, "vector": 2}[kind]
    source = "\n".join(
        [
            link(unwrap(formula)),
            "from lesson_code.engine.compiled.vectors import note, vector",
            "def start(tables):",
            f"    return note(tables.numbers, {name}({', '.join(taken)}))",
        ]
    )
    layout = tuple(Layout(table, dtype_of(row), True) for table, row in row_kinds(Numbers).items())
    return Program(source, "start", layout)


def _at(place: int) -> str:
    """Return a number of the table, as source."""
    return f"tables.numbers[{place}].value"


# Modules


def built(program: WebProgram) -> bytes:
    """Return a program as a WebAssembly module; it takes seconds to a minute.

    Another process makes it, in which Numba is set up for that.

    Raises
    ------
    RuntimeError
        The linker or Numba is not installed, or the program cannot be compiled.
    """
    if missing := [name for name, version in makers().items() if not version]:
        raise RuntimeError(f"{missing[0]} is not installed: pip install -e '.[wasm]'")
    path = os.pathsep.join([str(HOUSE), *filter(None, sys.path)])
    done = subprocess.run(  # noqa: S603 - our own module
        [sys.executable, "-P", "-c", f"from {__name__} import main; main()"],
        input=pickle.dumps(program),
        capture_output=True,
        env=os.environ | NUMBA | {"PYTHONPATH": path},
        check=False,
    )
    if done.returncode:
        raise RuntimeError(f"the program cannot be built here:\n{done.stderr.decode()}")
    return done.stdout + _section(program)


def makers() -> dict[str, str]:
    """Return the versions of all that has a part in a module; "" for what is not installed."""
    found = {"Python": ".".join(platform.python_version_tuple()[:2]), "for": platform.machine()}
    for package in ("numba", "llvmlite", "ziglang"):
        with suppress(metadata.PackageNotFoundError):
            found[package] = metadata.version(package)
        found.setdefault(package, "")
    return found


def main() -> None:
    """Build the program that stands at the input, and write it to the output."""
    program = pickle.load(sys.stdin.buffer)  # noqa: S301 - from our own process
    sys.stdout.buffer.write(_linked(_object_file(program), [*program.entries]))


def told_by(module: bytes) -> dict[str, Any]:
    """Return what a module says that it was made of.

    Raises
    ------
    ValueError
        It has no such section.
    """
    place = len(MAGIC)
    while place < len(module):
        size, start = _read_number(module, place + 1)
        length, name = _read_number(module, start)
        if module[place] == CUSTOM and module[name : name + length] == SECTION.encode():
            about: dict[str, Any] = json.loads(module[name + length : start + size])
            return about
        place = start + size
    raise ValueError(f"the module must have a section named {SECTION}")


MAGIC = b"\0asm\1\0\0\0"
"""With what every module begins."""

CUSTOM = 0
"""The number of sections that are not code."""


def _object_file(program: WebProgram) -> bytes:
    """Return the machine code of all entries, each under its own name."""
    import llvmlite.binding as llvm

    from lesson_code.engine.compiled.machine_code import module_of, needs_of

    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    target = llvm.Target.from_triple("wasm32-unknown-unknown")
    machine = target.create_target_machine(cpu="mvp", features=FEATURES, opt=2)
    whole = llvm.parse_assembly("")
    for name, entry in program.entries.items():
        module = module_of(entry, name, machine)
        whole.triple, whole.data_layout = module.triple, module.data_layout
        whole.link_in(module)
    if missing := set(needs_of(whole)) - set(LENT):
        raise LookupError(f"a page does not lend {', '.join(sorted(missing))}")
    code: bytes = machine.emit_object(whole)
    return code


def _linked(code: bytes, entries: list[str]) -> bytes:
    """Return an object file as a module that exports its entries, its memory and where it ends."""
    with tempfile.TemporaryDirectory() as folder:
        made = Path(folder, "program.wasm")
        Path(folder, "program.o").write_bytes(code)
        words = [sys.executable, "-m", "ziglang", "wasm-ld", "--no-entry", "--strip-all"]
        words += ["--allow-undefined", f"-zstack-size={STACK}", "--export=__heap_base"]
        words += [*(f"--export={name}" for name in entries), "program.o", "-o", made.name]
        subprocess.run(words, cwd=folder, check=True)  # noqa: S603 - no words from outside
        return made.read_bytes()


def _section(program: WebProgram) -> bytes:
    """Return the section in which a module says what it was made of."""
    about = {"sources": program.fingerprint, "makers": makers(), **program.about}
    content = json.dumps(about, separators=(",", ":"), allow_nan=False).encode()
    named = _number_as_bytes(len(SECTION)) + SECTION.encode() + content
    return bytes([CUSTOM]) + _number_as_bytes(len(named)) + named


def _number_as_bytes(number: int) -> bytes:
    """Return a number in seven bits a byte (LEB128), as a module has them."""
    more = number >> 7
    return bytes([number & 127 | (128 if more else 0)]) + (_number_as_bytes(more) if more else b"")


def _read_number(module: bytes, place: int) -> tuple[int, int]:
    """Return the number at a place, and the place after it."""
    number, shift = 0, 0
    while True:
        byte = module[place]
        number, shift, place = number | (byte & 127) << shift, shift + 7, place + 1
        if byte < 128:
            return number, place


def _words(node: Any) -> Iterator[str]:
    """Yield the words of a syntax tree, the same in every version of Python."""
    if isinstance(node, ast.AST):
        yield type(node).__name__
        for name in node._fields:
            if name not in ("ctx", "kind", "type_comment", "type_params", "type_ignores"):
                value = getattr(node, name, None)
                yield from _words(_without_docstring(value) if name == "body" else value)
        yield "."
    elif isinstance(node, list):
        for part in node:
            yield from _words(part)
        yield ";"
    else:
        yield repr(node)


def _without_docstring(body: Any) -> Any:
    """Return a block of statements without the text that it may begin with."""
    if isinstance(body, list) and body and isinstance(body[0], ast.Expr):
        first = body[0].value
        if isinstance(first, ast.Constant) and isinstance(first.value, str):
            return body[1:]
    return body
