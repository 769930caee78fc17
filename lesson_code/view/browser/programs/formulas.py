"""Every equation of ``lesson_code.formulas`` that has a door of its own."""

from __future__ import annotations

import pkgutil
from collections.abc import Callable
from importlib import import_module
from typing import Any

from lesson_code import formulas
from lesson_code.engine.compiled.webassembly import formula_program


def with_doors() -> dict[str, Callable[..., Any]]:
    """Return the formulas, by name, from the modules in which they are written."""
    modules = [
        import_module(f"{formulas.__name__}.{module.name}")
        for module in pkgutil.iter_modules(formulas.__path__)
    ]
    return {
        name: value
        for module in modules
        for name, value in vars(module).items()
        if hasattr(value, "rules") and value.__module__ == module.__name__
    }


PROGRAM = formula_program(with_doors())
