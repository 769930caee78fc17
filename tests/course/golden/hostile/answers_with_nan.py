"""Numbers that make every comparison false, or true."""

import math


class Equal(float):
    """Equal to everything, and further from nothing than zero."""

    def __eq__(self, other):
        return True

    def __sub__(self, other):
        return 0.0

    __rsub__ = __sub__
    __hash__ = float.__hash__


def elastic_1d(m1, v1, m2, v2):
    return math.nan, math.nan


def inelastic_1d(m1, v1, m2, v2):
    return Equal(math.inf), Equal(math.nan)


def elastic_impulse_1d(m1, v1, m2, v2):
    return Equal(0.0)
