"""Bounds on a processor's time that hold on a slow machine as on a fast one."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager

from lesson_code.engine.compiled.choice import slowness


@contextmanager
def at_most(seconds: float) -> Iterator[None]:
    """Hold what is done inside to seconds of this process's own processor time.

    They are seconds of the machine that the engine's constants were measured on: a slower one has
    as many more as plain Python takes longer on it. What waits for other processes costs nothing.
    """
    began = time.process_time()
    yield
    took = (time.process_time() - began) / max(slowness(), 1.0)
    assert took < seconds, f"{took:.2f} s of the processor, and {seconds:g} s are allowed"
