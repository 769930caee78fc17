"""Calling machine code: LLVM loads an object file, and gives the address of its entry.

This takes some milliseconds, and LLVM's own import .06 s. Numba is not needed.
"""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from typing import Any

import numpy as np

from lesson_code.engine.compiled.program import Layout, Program

SYMBOL = "program_entry"
"""What the entry is called in every object file."""

CALL = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p)
"""The entry of a function that Numba compiles: where its result and its error go, and its argument.
It returns 0, or that it has failed."""


class MachineCode:
    """An object file that has been loaded.

    Parameters
    ----------
    code : bytes
        The object file. It must be one of ours, whole: whatever it holds is run.
    needs : sequence of str
        The functions of the system's libraries that it calls.

    Raises
    ------
    LookupError
        The system does not have one of them. (LLVM would end the process.)
    """

    def __init__(self, code: bytes, needs: Sequence[str]) -> None:
        import llvmlite.binding as llvm

        self._engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), target_machine())
        if missing := [name for name in needs if not llvm.address_of_symbol(name)]:
            raise LookupError(f"the system must have the function {missing[0]}")
        self._engine.add_object_file(llvm.ObjectFileRef.from_data(code))
        self._engine.finalize_object()
        self.function = CALL(self._engine.get_function_address(SYMBOL))


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
