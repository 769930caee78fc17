"""One source, run in two ways: as plain Python on rows, or compiled by Numba on arrays of records.

=============  ==================================================================
module         what it does
=============  ==================================================================
``linker``     puts the functions that a run needs into one module, as source
``known``      works out what is decided before the run
``arrays``     turns tables of rows into arrays of records
``inlining``   decides which functions are compiled in place of their calls, and which are merged
``library``    compiles a module, and keeps the machine code for the next time
``choice``     decides whether a run is worth compiling
=============  ==================================================================

Both ways give the same bits: no operation is reordered or left out. Nothing here is needed to
understand the engine, and without Numba everything runs, only more slowly.
"""

from lesson_code.engine.compiled.arrays import as_arrays, as_numbers, copy_of
from lesson_code.engine.compiled.choice import Choice, choose
from lesson_code.engine.compiled.library import compiled_function
from lesson_code.engine.compiled.linker import link

__all__ = ["Choice", "as_arrays", "as_numbers", "choose", "compiled_function", "copy_of", "link"]
