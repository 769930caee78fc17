"""Calling machine code: it is loaded, and called at the address of its entry.

A shared library is loaded by the system, in a millisecond. Where none could be made, it is an
object file, which LLVM loads; LLVM's own import takes .04 s. Numba is not needed.
"""

from __future__ import annotations

import ctypes
import os
from typing import Any, NamedTuple

import numpy as np

from lesson_code.engine.compiled.program import Layout, Program

SYMBOL = "program_entry"
"""What the entry is called in every object file."""

CALL = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p)
"""The entry of a function that Numba compiles: where its result and its error go, and its argument.
It returns 0, or that it has failed."""


class ObjectFile(NamedTuple):
    """Machine code as a file that can be loaded."""

    code: bytes
    needs: tuple[str, ...]  # the functions of the system's libraries that it calls
    is_library: bool = False  # whether it is linked, as a shared library


class MachineCode:
    """Machine code that has been loaded.

    Parameters
    ----------
    file : ObjectFile
        It must be one of ours, whole: whatever it holds is run.

    Raises
    ------
    LookupError
        The system does not have a function that it calls, or cannot load it.
    """

    def __init__(self, file: ObjectFile) -> None:
        load = _by_the_system if file.is_library else _by_llvm
        self._loaded, address = load(file)
        self.function = CALL(address)


def _by_the_system(file: ObjectFile) -> tuple[Any, int]:
    """Load a shared library; return what holds it, and the address of its entry.

    The system takes it from a file in memory, which nobody can change between our look and its own.
    That stays open: a name that comes again would stand for the library of before.
    """
    try:
        held = os.memfd_create(SYMBOL)
        with open(held, "wb", closefd=False) as opened:
            opened.write(file.code)
        library = ctypes.CDLL(f"/proc/self/fd/{held}")
        return library, ctypes.cast(library[SYMBOL], ctypes.c_void_p).value or 0
    except (OSError, AttributeError) as error:
        raise LookupError(f"the system must load the program: {error}") from error


def _by_llvm(file: ObjectFile) -> tuple[Any, int]:
    """Load an object file; return what holds it, and the address of its entry."""
    import llvmlite.binding as llvm

    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), target_machine())
    # LLVM would end the process where a function is missing
    if missing := [name for name in file.needs if not llvm.address_of_symbol(name)]:
        raise LookupError(f"the system must have the function {missing[0]}")
    engine.add_object_file(llvm.ObjectFileRef.from_data(file.code))
    engine.finalize_object()
    return engine, engine.get_function_address(SYMBOL)


def linked(file: ObjectFile) -> ObjectFile:
    """Return an object file as a shared library, if there is a linker and the system can load it.

    A process then needs neither LLVM nor time to load it.
    """
    import shutil
    import subprocess
    import tempfile
    from pathlib import Path

    linker = shutil.which("cc")
    if linker is None or not hasattr(os, "memfd_create"):
        return file
    with tempfile.TemporaryDirectory() as place:
        Path(place, "program.o").write_bytes(file.code)
        words = [linker, "-shared", "-nostartfiles", "-o", "program.so", "program.o", "-lm"]
        if subprocess.run(words, cwd=place, capture_output=True, check=False).returncode != 0:  # noqa: S603 - our own file
            return file
        library = file._replace(code=Path(place, "program.so").read_bytes(), is_library=True)
    try:
        MachineCode(library)
    except LookupError:
        return file
    return library


class Entry:
    """A program that can be called with its tables, and returns what it says as a number.

    Parameters
    ----------
    code : MachineCode
        What is run.
    program : Program
        What it was made of. Tables of another layout are refused: it would write anywhere.
    """

    def __init__(self, code: MachineCode, program: Program) -> None:
        self._code, self.program = code, program
        self._tables: Any = None
        self._result, self._error = ctypes.c_double(), ctypes.c_void_p()
        self._out = ctypes.addressof(self._result), ctypes.addressof(self._error)

    def __call__(self, tables: Any) -> float:
        """Run the program on a named tuple of tables, and return its result.

        Raises
        ------
        TypeError
            A table is not laid out as the program was compiled for.
        RuntimeError
            It has stopped at an error, which only one that was compiled with checks can.
        """
        if tables is not self._tables:
            self._words = _addresses(tables, self.program.layout)
            self._tables = tables  # they are kept as long as their addresses
        if self._code.function(*self._out, self._words.ctypes.data):
            raise RuntimeError("the compiled program has stopped at an error")
        return self._result.value


def target_machine() -> Any:
    """Return what LLVM knows of this processor."""
    import llvmlite.binding as llvm

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    return llvm.Target.from_default_triple().create_target_machine(
        cpu=llvm.get_host_cpu_name(),
        features=llvm.get_host_cpu_features().flatten(),
        opt=3,
        reloc="pic",  # a shared library may lie anywhere
        codemodel="jitdefault",
        jit=True,
    )


def _addresses(tables: Any, layout: tuple[Layout, ...]) -> np.ndarray[Any, np.dtype[np.intp]]:
    """Return the address and the number of records of each table."""
    words = []
    for table, (name, dtype, is_list) in zip(tables, layout, strict=True):
        if table.dtype != dtype:
            raise TypeError(f"{name} must have records of {dtype}, got {table.dtype}")
        held = table if is_list else np.frombuffer(memoryview(table), np.uint8)
        words += [held.ctypes.data, len(table) if is_list else 1]
    return np.array(words, np.intp)
