"""Box2D itself, loaded when it is first used."""

from __future__ import annotations

import warnings
from typing import Any


def box2d() -> Any:
    """Return the module Box2D.

    Raises
    ------
    ModuleNotFoundError
        Box2D is not installed; the message says what to install.
    """
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # where warnings are errors, its own end the process
            import Box2D
    except ModuleNotFoundError as missing:
        raise ModuleNotFoundError(
            'Box2D must be installed to run a scene in it: pip install "Box2D>=2.3.10"',
            name=missing.name,
        ) from missing
    return Box2D
