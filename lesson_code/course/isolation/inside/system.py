"""The system calls that Python has no name for, or has one from 3.12 on only."""

from __future__ import annotations

import contextlib
import ctypes
import os
import platform
import sys
import time
from functools import cache
from typing import Any

MACHINE = platform.machine()

CLONE_NEWNS, CLONE_NEWUTS, CLONE_NEWIPC = 0x00020000, 0x04000000, 0x08000000
CLONE_NEWUSER, CLONE_NEWPID, CLONE_NEWNET = 0x10000000, 0x20000000, 0x40000000

MS_RDONLY, MS_NOSUID, MS_NODEV, MS_NOEXEC, MS_REMOUNT = 1, 2, 4, 8, 32
MS_BIND, MS_REC, MS_PRIVATE = 4096, 16384, 1 << 18
MNT_DETACH = 2

PR_SET_PDEATHSIG, PR_SET_DUMPABLE, PR_SET_SECCOMP = 1, 4, 22
PR_SET_CHILD_SUBREAPER, PR_SET_NO_NEW_PRIVS = 36, 38

PIVOT_ROOT = {"x86_64": 155, "aarch64": 41}
MOUNT_SETATTR = 442
CLOSE_RANGE = 436
LANDLOCK_CREATE_RULESET, LANDLOCK_ADD_RULE, LANDLOCK_RESTRICT_SELF = 444, 445, 446
"""Numbers of system calls; those above 424 are the same on every machine."""

LARGEST_DESCRIPTOR = 0xFFFF_FFFF

AT_FDCWD, AT_RECURSIVE = -100, 0x8000
MOUNT_ATTR_RDONLY, MOUNT_ATTR_NOSUID, MOUNT_ATTR_NODEV = 1, 2, 4

CAPABILITY_VERSION_3 = 0x20080522

CPUCLOCK_SCHED = 2
"""The clock of a process that counts what it computes, and what the system does for it."""


@cache
def _libc() -> ctypes.CDLL:
    """Return the C library."""
    return ctypes.CDLL(None, use_errno=True)


def _checked(name: str, result: int) -> int:
    """Return what a call returned, or raise what it set errno to."""
    if result < 0:
        number = ctypes.get_errno()
        raise OSError(number, f"{name}: {os.strerror(number)}")
    return result


def syscall(name: str, number: int, *arguments: Any) -> int:
    """Make a system call by its number."""
    longs = [ctypes.c_long(a) if isinstance(a, int) else a for a in arguments]
    return _checked(name, _libc().syscall(ctypes.c_long(number), *longs))


def prctl(option: int, *values: Any) -> int:
    """Change something of this process."""
    longs = [ctypes.c_ulong(v) if isinstance(v, int) else v for v in (*values, 0, 0, 0, 0)[:4]]
    return _checked("prctl", _libc().prctl(option, *longs))


def unshare(flags: int) -> None:
    """Give this process, or its next children, namespaces of their own."""
    _checked("unshare", _libc().unshare(flags))


def setns(descriptor: int, flags: int) -> None:
    """Enter a namespace."""
    _checked("setns", _libc().setns(descriptor, flags))


def mount(source: str, target: str, kind: str, flags: int, data: str = "") -> None:
    """Mount a file system."""
    texts = (text.encode() for text in (source, target, kind))
    _checked("mount", _libc().mount(*texts, ctypes.c_ulong(flags), data.encode()))


def unmount(target: str) -> None:
    """Take a file system off; what still uses it keeps it until it ends."""
    _checked("umount2", _libc().umount2(target.encode(), MNT_DETACH))


def protect_tree(target: str) -> None:
    """Make a mount and all below it read-only, without devices and set-user-ID programs."""
    protect = MOUNT_ATTR_RDONLY | MOUNT_ATTR_NOSUID | MOUNT_ATTR_NODEV
    attributes = (ctypes.c_uint64 * 4)(protect, 0, 0, 0)
    syscall(
        "mount_setattr",
        MOUNT_SETATTR,
        AT_FDCWD,
        target.encode(),
        AT_RECURSIVE,
        attributes,
        ctypes.sizeof(attributes),
    )


def pivot_root(root: str) -> None:
    """Make a mounted folder the root of all paths, and take the old root off."""
    os.chdir(root)
    syscall("pivot_root", PIVOT_ROOT[MACHINE], b".", b".")
    unmount(".")
    os.chdir("/")


def close_from(first: int) -> None:
    """Close every descriptor from a number on, however many are open."""
    try:
        syscall("close_range", CLOSE_RANGE, first, LARGEST_DESCRIPTOR, 0)
    except OSError:  # a kernel before 5.9
        os.closerange(first, os.sysconf("SC_OPEN_MAX"))


def processor_time(process: int) -> float | None:
    """Return the processor time of a process and all its threads, s; None where none can be had.

    The clock is the one of clock_getcpuclockid(3): it needs no /proc, and a process that has ended
    keeps its own until somebody has waited for it.
    """
    clock_gettime = getattr(time, "clock_gettime", None)
    if clock_gettime is None or sys.platform != "linux":
        return None
    with contextlib.suppress(OSError):
        return float(clock_gettime((~process << 3) | CPUCLOCK_SCHED))
    return None


HEADER_OF_CAPABILITIES = (ctypes.c_uint32 * 2)(CAPABILITY_VERSION_3, 0)
NO_CAPABILITIES = (ctypes.c_uint32 * 6)()


def drop_capabilities() -> None:
    """Give up every privilege that root, or the first user of a namespace, has."""
    _checked("capset", _libc().capset(HEADER_OF_CAPABILITIES, NO_CAPABILITIES))
