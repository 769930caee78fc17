"""Raises errors that nobody can describe: nested, endless, of classes that lie."""


class Long(Exception):
    def __str__(self):
        return "x" * 300_000_000


class Ring(Exception):
    def __str__(self):
        raise self


class Nameless(Exception):
    pass


def nested(depth):
    error = ExceptionGroup("1.1 elastic_1d: 4/4 points", [Long(), Ring()])
    for _ in range(depth):
        error = ExceptionGroup("nested", [error])
    return error


def elastic_1d(m1, v1, m2, v2):
    if m1 > m2:
        raise nested(5_000)
    error = Nameless()
    error.__cause__ = error
    Nameless.__name__ = "x" * 1_000_000
    Nameless.__module__ = "\x1b[2J"
    raise error from Long()


def inelastic_1d(m1, v1, m2, v2):
    raise Long


def elastic_impulse_1d(m1, v1, m2, v2):
    raise Ring
