import re


def elastic_impulse_1d(m1, v1, m2, v2):
    return re.match(r"(a|a)*b", "a" * 60)


def inelastic_1d(m1, v1, m2, v2):
    v = (m1 * v1 + m2 * v2) / (m1 + m2)
    return v, v


def elastic_1d(m1, v1, m2, v2):
    v = (m1 * v1 + m2 * v2) / (m1 + m2)
    return 2 * v - v1, 2 * v - v2
