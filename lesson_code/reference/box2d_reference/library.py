"""Box2D itself, loaded when it is first used."""

from __future__ import annotations

from typing import Any


def box2d() -> Any:
    """Return the module pyb2d3.

    Raises
    ------
    ModuleNotFoundError
        Box2D is not installed; the message says what to install.
    """
    try:
        import pyb2d3
    except ModuleNotFoundError as missing:
        raise ModuleNotFoundError(
            'Box2D must be installed to run a scene in it: pip install "pyb2d3>=0.11"',
            name=missing.name,
        ) from missing
    return pyb2d3
