def elastic_impulse_1d(m1, v1, m2, v2):
    while True:
        pass


def inelastic_1d(m1, v1, m2, v2):
    v = (m1 * v1 + m2 * v2) / (m1 + m2)
    return v, v


def elastic_1d(m1, v1, m2, v2):
    v = (m1 * v1 + m2 * v2) / (m1 + m2)
    return 2 * v - v1, 2 * v - v2
