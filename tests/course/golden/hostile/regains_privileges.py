"""Tries to become root again, to mount, and to leave its root."""

import ctypes
import os

THROUGH = set()


def attempt(name, deed):
    try:
        deed()
    except (OSError, ImportError, AttributeError, KeyError, ValueError, RuntimeError):
        return
    THROUGH.add(name)


CLONE_NEWUSER, CLONE_NEWNS = 0x10000000, 0x00020000


def checked(result):
    if result < 0:
        raise OSError(ctypes.get_errno(), "refused")


def attack():
    libc = ctypes.CDLL(None, use_errno=True)
    attempt("becomes another user", lambda: os.setuid(0 if os.getuid() else 1))
    attempt("changes its root", lambda: os.chroot("/"))
    attempt("mounts", lambda: checked(libc.mount(b"x", b".", b"tmpfs", 0, None)))
    libc.umount2(b".", 2)
    attempt("makes namespaces", lambda: checked(libc.unshare(CLONE_NEWUSER | CLONE_NEWNS)))
    attempt("becomes another group", lambda: os.setgroups([0]))


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
