"""Answers without an end: a generator, a list within itself, a number beyond all floats."""

from itertools import count


def elastic_1d(m1, v1, m2, v2):
    return count()


def inelastic_1d(m1, v1, m2, v2):
    answer = []
    answer.append(answer)
    return answer


def elastic_impulse_1d(m1, v1, m2, v2):
    return 10**400
