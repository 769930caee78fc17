"""Which files a process may reach: those under the folders named, and no others.

The kernel does it, for any process that asks to be restricted (Landlock, Linux 6.2 and later).
"""

from __future__ import annotations

import ctypes
import os
import struct
from collections.abc import Iterable
from functools import cache

from . import system

OLDEST_VERSION = 3
"""Before it, a file could be cut off (truncate) without any right to write it."""

READ_FILE, READ_FOLDER = 1 << 2, 1 << 3
EXECUTE = 1 << 0
READ = EXECUTE | READ_FILE | READ_FOLDER
ALL_WRITES = (1 << 1) | (((1 << 15) - 1) & ~((1 << 4) - 1))
"""Writing and cutting off files; making, removing, renaming and linking whatever there is."""

DEVICE_CONTROL = 1 << 15
TCP = 0b11
SIGNALS_AND_ABSTRACT_SOCKETS = 0b11

RULE_PATH_BENEATH = 1
VERSION_FLAG = 1


@cache
def version() -> int:
    """Return which version of Landlock the kernel offers; 0 if none."""
    try:
        return system.syscall("landlock", system.LANDLOCK_CREATE_RULESET, None, 0, VERSION_FLAG)
    except OSError:
        return 0


def is_strong() -> bool:
    """Return whether the kernel's Landlock keeps files away and lets nobody cut one off."""
    return version() >= OLDEST_VERSION


def ruleset(rules: Iterable[tuple[str, int]]) -> int:
    """Return the descriptor of a set of rules: what is allowed at and beneath each path.

    A path that is not there is passed over.
    """
    made = _empty_ruleset()
    for path, rights in rules:
        _add(made, path, rights)
    return made


def restrict(ruleset: int) -> None:
    """Restrict this process, and all it may start, to what the rules say; there is no way back.

    The set is closed.
    """
    system.prctl(system.PR_SET_NO_NEW_PRIVS, 1)
    system.syscall("landlock", system.LANDLOCK_RESTRICT_SELF, ruleset, 0)
    os.close(ruleset)


def _empty_ruleset() -> int:
    """Return a new set of rules, which also refuses TCP and signals where the kernel can."""
    newest = version()
    files = READ | ALL_WRITES | (DEVICE_CONTROL if newest >= 5 else 0)
    attributes = struct.pack(
        "QQQ",
        files,
        TCP if newest >= 4 else 0,
        SIGNALS_AND_ABSTRACT_SOCKETS if newest >= 6 else 0,
    )
    size = 24 if newest >= 6 else 16 if newest >= 4 else 8
    return system.syscall(
        "landlock", system.LANDLOCK_CREATE_RULESET, ctypes.c_char_p(attributes), size, 0
    )


def _add(ruleset: int, path: str, rights: int) -> None:
    """Add what is allowed at and beneath a path."""
    try:
        descriptor = os.open(path, os.O_PATH | os.O_CLOEXEC)
    except OSError:
        return
    try:
        if not os.path.isdir(path):  # noqa: PTH112 - a path, and nothing else to do with it
            rights &= EXECUTE | READ_FILE | (1 << 1) | (1 << 14)
        rule = struct.pack("=Qi", rights, descriptor)
        system.syscall(
            "landlock",
            system.LANDLOCK_ADD_RULE,
            ruleset,
            RULE_PATH_BENEATH,
            ctypes.c_char_p(rule),
            0,
        )
    finally:
        os.close(descriptor)
