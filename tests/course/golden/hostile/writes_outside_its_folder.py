"""Writes where it is not at home, and changes what it finds there."""

import os
import sys
from pathlib import Path

THROUGH = set()


def attempt(name, deed):
    try:
        deed()
    except (OSError, ImportError, AttributeError, KeyError, ValueError, RuntimeError):
        return
    THROUGH.add(name)


def write(path):
    path.write_text("left by a submission")
    path.unlink()


def attack():
    for folder in ("/tmp", "/var/tmp", "/dev/shm", str(Path.home().parent), ".."):
        attempt("writes outside", lambda: write(Path(folder) / f"hostile-{os.getpid()}"))
    attempt("writes outside", lambda: write(Path(os.__file__).parent / "hostile.py"))
    attempt("changes modes", lambda: os.chmod("/tmp", 0o1777))
    attempt("changes modes", lambda: os.utime("/tmp"))


TRIED = []


def elastic_1d(m1, v1, m2, v2):
    if not TRIED:
        TRIED.append("once is enough")
        attack()
    total = m1 + m2
    return ((m1 - m2) * v1 + 2 * m2 * v2) / total, ((m2 - m1) * v2 + 2 * m1 * v1) / total


def inelastic_1d(m1, v1, m2, v2):
    v = (m1 * v1 + m2 * v2) / (m1 + m2)
    return v, v


def elastic_impulse_1d(m1, v1, m2, v2):
    return 2 * m1 * m2 / (m1 + m2) * (v1 - v2)


def got_through():
    return sorted(THROUGH)
