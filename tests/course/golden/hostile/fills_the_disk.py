"""Writes files of the largest size allowed until there is no more room."""

import os

THROUGH = set()
BLOCK = b"x" * 1_000_000


def attack():
    written = 0
    try:
        for number in range(60):
            with open(f"{os.getpid()}-{number}", "wb") as file:
                file.write(BLOCK)
            written += 1
    except OSError:
        pass
    if written == 60:
        THROUGH.add("fills the disk")


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
