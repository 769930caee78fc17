"""Fresh Python processes for tests, and whether any are left."""

from __future__ import annotations

import os
import subprocess
import sys
import textwrap
import time
from pathlib import Path

import lesson_code

HOUSE = Path(lesson_code.__file__).parents[1]

PATIENCE = 60.0
"""s, after which what does not happen has failed: far longer than anything takes here."""


def started(code: str, house: Path = HOUSE) -> subprocess.Popen[str]:
    """Start a fresh Python process that finds the package in a house."""
    path = os.pathsep.join([str(house), *filter(None, sys.path)])
    return subprocess.Popen(
        [sys.executable, "-P", "-c", textwrap.dedent(code)],
        env=os.environ | {"PYTHONPATH": path},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def printed(process: subprocess.Popen[str]) -> list[str]:
    """Return the lines that a process has printed when it has ended well."""
    out, error = process.communicate()
    assert process.returncode == 0, error
    return out.splitlines()


def is_gone(number: int, *, within: float = PATIENCE) -> bool:
    """Return whether a process has ended, or ends within some seconds."""
    until = time.monotonic() + within
    while time.monotonic() < until:
        try:
            os.kill(number, 0)
        except ProcessLookupError:
            return True
        time.sleep(0.05)
    return False
