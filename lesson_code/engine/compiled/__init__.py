"""One source, run in two ways: as plain Python on rows, or as machine code on arrays of records.

================  ===============================================================
module            what it does
================  ===============================================================
``linker``        puts the functions that a run needs into one module, as source
``sources``       keeps linked modules for the next time
``known``         works out what is decided before the run
``arrays``        turns tables of rows into arrays of records
``program``       what is compiled: a source, its entry, how its tables lie in memory
``inlining``      decides which functions are compiled in place of their calls, and which are merged
``machine_code``  compiles a program by Numba, into an object file, and links that
``compiler``      does so in a process of its own
``library``       keeps machine code for the next time
``ready_made``    makes machine code of what was compiled before anybody asked
``made_files``    says what is wrong with files that are made of programs
``loader``        loads machine code and calls it, without Numba
``choice``        decides what a run is made in, and changes over on the way
``webassembly``   makes programs for web pages of the same sources
``vectors``       what an equation asks of NumPy's vectors, for these
================  ===============================================================

Both ways give the same bits: no operation is reordered or left out. Nothing here is needed to
understand the engine, and without Numba everything runs, only more slowly.
"""

from lesson_code.engine.compiled.arrays import (
    another,
    as_arrays,
    as_rows,
    column,
    copy_of,
    full_rows,
    new_table,
    write_numbers,
)
from lesson_code.engine.compiled.choice import Code
from lesson_code.engine.compiled.linker import link
from lesson_code.engine.compiled.program import Program, program_of

__all__ = [
    "Code",
    "Program",
    "another",
    "as_arrays",
    "as_rows",
    "column",
    "copy_of",
    "full_rows",
    "link",
    "new_table",
    "program_of",
    "write_numbers",
]
