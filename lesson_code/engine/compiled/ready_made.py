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
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from lesson_code.engine.compiled import library
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


def finished(program: Program) -> Entry | None:
    """Return a program that came ready-made, ready to be called; from now on it is kept.

    It takes half a second. None: there is no file of it, or LLVM cannot read that here.
    """
    for path in FOLDER.glob(f"*{ENDING}"):
        with suppress(ImportError, OSError, RuntimeError, ValueError, LookupError, lzma.LZMAError):
            first, _, content = path.read_bytes().partition(b"\n")
            about = json.loads(first)
            if about["program"] == library.sum_over(program):
                made = _machine_code(lzma.decompress(content), tuple(about["needs"]))
                library.keep(library.place_to_write(), program, linked(made))
                return library.load(program)
    return None


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
    """Return what is wrong with a program's file, or "" if nothing is; it is not made for that."""
    try:
        with file_of(name).open("rb") as file:
            is_current = json.loads(file.readline())["program"] == library.sum_over(program)
    except FileNotFoundError:
        return "is missing; make it with workbook regenerate"
    except (ValueError, LookupError, TypeError) as error:
        return f"cannot be read ({error})"
    return "" if is_current else "differs from the functions it holds"


def drifted(programs: Mapping[str, Program], root: Path) -> list[str]:
    """Return in a line each what is wrong with the files, one for each of these programs."""
    faults = {file_of(name): fault(name, program) for name, program in programs.items()}
    orphans = {path: "has no source" for path in FOLDER.glob(f"*{ENDING}") if path not in faults}
    lines = sorted((faults | orphans).items())
    return [f"{path.relative_to(root)}: {line}" for path, line in lines if line]


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
