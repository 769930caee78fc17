"""Right answers in exact numbers, as an array, as a generator of exact decimals."""

from decimal import Decimal
from fractions import Fraction

import numpy as np


def elastic_1d(m1, v1, m2, v2):
    m1, v1, m2, v2 = map(Fraction, (m1, v1, m2, v2))
    v = (m1 * v1 + m2 * v2) / (m1 + m2)
    return [2 * v - v1, 2 * v - v2]


def inelastic_1d(m1, v1, m2, v2):
    return np.full(2, np.average([v1, v2], weights=[m1, m2]), dtype=np.longdouble)


def elastic_impulse_1d(m1, v1, m2, v2):
    m1, v1, m2, v2 = map(Decimal, (m1, v1, m2, v2))
    return np.array(2 * m1 * m2 / (m1 + m2) * (v1 - v2))
