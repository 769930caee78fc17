"""Ready-made programs: what is the same on every machine is done before anybody needs it.

Of the half minute that a compiler takes, Numba's part and LLVM's passes are the same for every
processor. What they end in, LLVM's bitcode, lies in the folder ``bitcode``, for the few
programs that suit any scene. To make machine code of one takes half a second, and no Numba; then
the library keeps it. So nobody waits for a compiler, nor for plain Python until one is done.

A file begins with a line about it: a sum over the program that it was made of. A program that has
changed since is not found; `workbook regenerate` makes it anew.
"""

from __future__ import annotations

import json
import lzma
from contextlib import suppress
from pathlib import Path
from typing import Any

from lesson_code.engine.compiled import library, made_files
from lesson_code.engine.compiled.loader import (
    SYMBOL,
    Entry,
    ObjectFile,
    linked,
    target_machine,
)
from lesson_code.engine.compiled.program import Program

FOLDER = Path(__file__).with_name("bitcode")
"""Where the files are."""

ENDING = ".bitcode"

TRIPLE, PROCESSOR = "x86_64-unknown-linux-gnu", "x86-64-v2"
"""For what LLVM's passes weigh what pays. Nothing that they write is for this processor alone."""


def load(program: Program) -> Entry | None:
    """Return a program that is kept, or came ready-made; None: it has to be compiled."""
    return library.load(program) or finished(program)


def finished(program: Program) -> Entry | None:
    """Return a program that came ready-made, ready to be called; from now on it is kept.

    It takes half a second. None: there is no file of it, or LLVM cannot read that here.
    """
    for path in FOLDER.glob(f"*{ENDING}"):
        with suppress(ImportError, OSError, RuntimeError, ValueError, LookupError, lzma.LZMAError):
            about, bitcode = _parts(path.read_bytes())
            if about["program"] == library.sum_over(program):
                made = _machine_code(lzma.decompress(bitcode), tuple(about["needs"]))
                library.keep(library.place_to_write(), program, linked(made))
                return library.load(program)
    return None


def _parts(content: bytes) -> tuple[dict[str, Any], bytes]:
    """Return what the first line of a file says, and the bitcode, compressed."""
    first, _, bitcode = content.partition(b"\n")
    return json.loads(first), bitcode


def _machine_code(bitcode: bytes, needs: tuple[str, ...]) -> ObjectFile:
    """Return machine code for this processor."""
    import llvmlite.binding as llvm

    machine = target_machine()
    module = llvm.parse_bitcode(bitcode)
    module.triple, module.data_layout = machine.triple, str(machine.target_data)
    return ObjectFile(machine.emit_object(module), needs)


# Making them


def file_of(name: str) -> Path:
    """Return where a program lies."""
    return FOLDER / f"{name}{ENDING}"


def fault(name: str, program: Program) -> str:
    """Return what is wrong with a program's file, or "" if nothing is."""
    return made_files.fault(file_of(name), _sum_in, library.sum_over(program))


def _sum_in(content: bytes) -> str:
    """Return the sum over the program of which a file was made."""
    about, _ = _parts(content)
    told: str = about["program"]
    return told


def write(name: str, program: Program) -> Path:
    """Make a program's file; it takes some ten seconds.

    Raises
    ------
    RuntimeError
        Numba is not installed.
    """
    if reason := library.why_no_compiler():
        raise RuntimeError(reason)
    import llvmlite.binding as llvm

    from lesson_code.engine.compiled.machine_code import module_of, needs_of

    llvm.initialize_all_targets()
    machine = llvm.Target.from_triple(TRIPLE).create_target_machine(
        cpu=PROCESSOR, opt=3, reloc="pic", codemodel="jitdefault", jit=True
    )
    module = module_of(program, SYMBOL, machine)
    about = {"program": library.sum_over(program), "needs": needs_of(module)}
    content = lzma.compress(module.as_bitcode(), preset=9)
    FOLDER.mkdir(exist_ok=True)
    file_of(name).write_bytes(json.dumps(about).encode() + b"\n" + content)
    return file_of(name)
