"""Functions within a program: translated, but not optimised one by one.

Numba optimises each function together with all that it calls, and makes machine code of it, so
that it might be called from Python. What lies under ten calls is optimised ten times over. Within a
program nobody calls a function from Python. So here it is translated, and left at that; all of it
is optimised together with the entry, once. The machine code is as fast, and is there in two thirds
of the time.

The hook for this, a compiler of one's own, is Numba's; what is hooked in needs some methods of its
libraries of code that it does not promise to keep. Should they go, every function is optimised.
"""

from __future__ import annotations

from typing import Any

from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import CompilerBase, DefaultPassBuilder
from numba.core.compiler_machinery import FunctionPass, register_pass
from numba.core.typed_passes import NopythonTypeInference

NEEDED = (
    "_ensure_finalized",
    "_finalize_dynamic_globals",
    "_finalize_final_module",
    "_optimize_final_module",
)
"""Methods of Numba's libraries of code without which all is left to Numba."""


class NoEnvironment:
    """Stands where Numba would tell machine code about its module in Python."""

    def set_env(self, _name: str, _environment: Any) -> None:
        """Do nothing: there is no machine code yet."""


class InnerLibrary(JITCodeLibrary):
    """The code of one function: to be linked with its callers', never to be run by itself."""

    codegen = NoEnvironment()

    def _optimize_final_module(self) -> None:
        """Leave it to the entry's library."""

    def _finalize_final_module(self) -> None:
        """Make it ready to be linked, and no machine code."""
        self._finalize_dynamic_globals()
        self._finalized = True

    def get_pointer_to_function(self, _name: str) -> int:
        """Return 0: there is nothing that could be called."""
        self._ensure_finalized()
        return 0


@register_pass(mutates_CFG=False, analysis_only=True)
class TakeInnerLibrary(FunctionPass):
    """Gives the compiler the library that it is to put a function's code into."""

    _name = "take_inner_library"

    def __init__(self) -> None:
        FunctionPass.__init__(self)

    def run_pass(self, state: Any) -> bool:
        """Run before the function is translated; return that nothing about it has changed."""
        state.library = InnerLibrary(state.targetctx.codegen(), state.func_id.func_qualname)
        state.library.enable_object_caching()
        return False


class InnerCompiler(CompilerBase):
    """Numba's compiler with that pass in it."""

    def define_pipelines(self) -> list[Any]:
        """Return the one list of passes."""
        passes = DefaultPassBuilder.define_nopython_pipeline(self.state)
        passes.add_pass_after(TakeInnerLibrary, NopythonTypeInference)
        passes.finalize()
        return [passes]


def inner_options() -> dict[str, Any]:
    """Return what to tell Numba of a function that only compiled functions call."""
    options: dict[str, Any] = {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}
    if all(hasattr(JITCodeLibrary, name) for name in NEEDED):
        options["pipeline_class"] = InnerCompiler
    return options
