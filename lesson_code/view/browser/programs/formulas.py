"""Every equation of ``lesson_code.formulas`` that has a door, and a few others that figures need.

These are products of vectors, which have no door, and a closed form.
"""

from __future__ import annotations

import pkgutil
from collections.abc import Callable
from importlib import import_module
from typing import Any

from lesson_code import formulas
from lesson_code.engine.compiled.webassembly import formula_program
from lesson_code.formulas.arithmetic import cross, dot
from lesson_code.formulas.validation import formula, vector
from lesson_code.reference.closed_forms import rest_time


def with_doors() -> dict[str, Callable[..., Any]]:
    """Return the formulas, by name, from the modules in which they are written."""
    modules = [
        import_module(f"{formulas.__name__}.{module.name}")
        for module in pkgutil.iter_modules(formulas.__path__)
    ]
    found = {
        name: value
        for module in modules
        for name, value in vars(module).items()
        if hasattr(value, "rules") and value.__module__ == module.__name__
    }
    products = {product.__name__: formula(a=vector, b=vector)(product) for product in (cross, dot)}
    return found | products | {"rest_time": rest_time}


PROGRAM = formula_program(with_doors())
