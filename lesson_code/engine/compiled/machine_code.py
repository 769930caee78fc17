"""Machine code of a program: Numba compiles it, and LLVM writes an object file.

The entry gets one address: that of a row of whole numbers, with the address and the number of
records of each table. Numba's own entries take seven words for an array, and want Numba to be
called. Nothing in the object file needs Numba or Python. The system's linker, if there is one,
makes a shared library of it; :mod:`loader` loads both.

Compiled programs cannot allocate memory and do not count references: they work on the tables that
they are given. No operation is reordered or left out.

References
----------
Numba documentation, Low-level extension API (`intrinsic`); LLVM Language Reference, Linkage Types.
"""

from __future__ import annotations

import types
from collections import namedtuple
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import llvmlite.binding as llvm
import numba
from numba.core import cgutils, codegen
from numba.core.registry import cpu_target
from numba.extending import intrinsic
from numba.np import arrayobj
from numba.np.numpy_support import as_dtype

import lesson_code.engine.compiled.lane_types  # noqa: F401 - Numba learns from it what lanes are
from lesson_code.engine.compiled.inlining import inlined, merged
from lesson_code.engine.compiled.loader import SYMBOL, ObjectFile, target_machine
from lesson_code.engine.compiled.program import Layout, Program

OPTIONS: dict[str, Any] = {
    "error_model": "numpy",  # 1 / 0 is infinite, as NumPy has it
    "_nrt": False,  # no memory is allocated, no reference counted
    "no_cpython_wrapper": True,
    "no_cfunc_wrapper": True,
}


def object_file(program: Program) -> ObjectFile:
    """Compile a program; it takes seconds.

    Raises
    ------
    numba.core.errors.NumbaError
        It holds what Numba does not compile.
    """
    machine = target_machine()
    module = module_of(program, SYMBOL, machine)
    return ObjectFile(machine.emit_object(module), needs_of(module))


@contextmanager
def not_run_here() -> Iterator[None]:
    """Let Numba stop at LLVM's text of what it compiles meanwhile.

    Else it also optimises each function, with all that the function calls, and makes machine code
    of it, so that it could be run at once: that takes as long as all the rest.
    """
    context = cpu_target.target_context
    context.refresh()  # what Numba itself runs, it must make first
    usual = context._internal_codegen
    context._internal_codegen = _TextAlone("text alone")
    try:
        yield
    finally:
        context._internal_codegen = usual


class _TextAlone(codegen.JITCPUCodegen):
    """What Numba writes LLVM's text with, and no machine code."""

    class _library_class(codegen.JITCodeLibrary):  # noqa: N801 - Numba's name
        """The text of a function and of all that it calls."""

        def get_pointer_to_function(self, _name: str) -> int:
            """Return that there is nothing to run."""
            self._ensure_finalized()
            return 0

        def _optimize_final_module(self) -> None:
            """Leave it to :func:`module_of`, which does it once, for the whole program."""

        def _finalize_specific(self) -> None:
            """Make no machine code."""

    def set_env(self, _name: str, _env: Any) -> None:
        """Tell nothing to a function that is not run."""

    def _add_module(self, _module: Any) -> None:
        """Keep the module from what would run it."""


def module_of(program: Program, name: str, machine: Any) -> Any:
    """Return LLVM's module of a program for a processor: its entry is known outside by a name.

    It is optimised before what the entry does not call is removed: LLVM puts a function that is
    called once and known nowhere else into its caller, stages with their loops too, and a pyramid
    of 20 rows then takes a tenth more time.
    """
    start = _entry(functions_of(program.source)[program.entry], program.layout)
    with not_run_here():
        compiled = numba.njit(numba.float64(numba.types.CPointer(numba.intp)), **OPTIONS)(start)
    result: Any
    (result,) = compiled.overloads.values()
    module = llvm.parse_assembly(str(result.library._final_module))
    module.triple, module.data_layout = machine.triple, str(machine.target_data)
    options = llvm.create_pipeline_tuning_options(speed_level=3)
    builder = llvm.create_pass_builder(machine, options)
    builder.getModulePassManager().run(module, builder)
    keep_only(module, result.fndesc.llvm_func_name, name, machine)
    return module


def needs_of(module: Any) -> tuple[str, ...]:
    """Return the functions that a module calls and does not hold."""
    declared = [f.name for f in module.functions if f.is_declaration]
    return tuple(name for name in declared if not name.startswith("llvm."))


def functions_of(source: str) -> dict[str, Any]:
    """Return the functions of a program, each in the way in which it is to be compiled."""
    module = types.ModuleType("program")
    exec(compile(source, "<program>", "exec"), vars(module))  # noqa: S102 - our own lines
    in_place, merge = inlined(source), merged(source)
    for name, function in list(vars(module).items()):
        if isinstance(function, types.FunctionType) and function.__module__ == module.__name__:
            inline = "always" if name in merge else "never"
            way: dict[str, Any] = {"forceinline": name in in_place, "inline": inline}
            setattr(module, name, numba.njit(**OPTIONS, **way)(function))
    return vars(module)


def _entry(function: Any, layout: tuple[Layout, ...]) -> Callable[[Any], float]:
    """Return a function of the row of addresses that calls another one with the tables.

    It returns what the other one returns as a number; 0 if that returns nothing.
    """
    names: dict[str, Any] = {"table_at": table_at, "function": function}
    names["Tables"] = namedtuple("Tables", [table.name for table in layout])
    tables = []
    for k, (_, dtype, is_list) in enumerate(layout):
        names[f"dtype_{k}"] = dtype
        table = f"table_at(words[{2 * k}], words[{2 * k + 1}], dtype_{k})"
        tables.append(table if is_list else f"{table}[0]")
    call = f"function(Tables({', '.join(tables)}))"
    is_silent = function.py_func.__annotations__.get("return") == "None"
    body = f"{call}\n    return 0.0" if is_silent else f"return 1.0 * {call}"
    exec(f"def start(words):\n    {body}\n", names)  # noqa: S102 - the lines above
    start: Callable[[Any], float] = names["start"]
    return start


@intrinsic
def table_at(_context: Any, address: Any, rows: Any, dtype: Any) -> Any:
    """Return the array of so many records at an address."""
    kind = numba.types.Array(dtype.dtype, 1, "C")

    def build(context: Any, builder: Any, _signature: Any, arguments: Any) -> Any:
        address, rows, _ = arguments
        record = context.get_data_type(dtype.dtype)
        size = context.get_constant(numba.intp, as_dtype(dtype.dtype).itemsize)
        array = arrayobj.make_array(kind)(context, builder)
        arrayobj.populate_array(
            array,
            data=builder.inttoptr(address, record.as_pointer()),
            shape=cgutils.pack_array(builder, [rows]),
            strides=cgutils.pack_array(builder, [size]),
            itemsize=size,
            meminfo=None,
        )
        return array._getvalue()

    return kind(address, rows, dtype), build


def keep_only(module: Any, entry: str, name: str, machine: Any) -> None:
    """Give the entry a name, and remove all that it does not call from the module.

    Of other functions and globals nothing is known outside; what is not used then, is removed.
    """
    for part in [*module.functions, *module.global_variables]:
        if part.name == entry:
            part.name = name
        elif not part.is_declaration:
            part.linkage = "internal"
    passes = llvm.create_new_module_pass_manager()
    passes.add_global_dead_code_eliminate_pass()
    passes.run(module, llvm.create_pass_builder(machine, llvm.create_pipeline_tuning_options()))
