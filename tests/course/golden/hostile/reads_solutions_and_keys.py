"""Looks for the tasks, the wrong models and the solutions on this machine, and reads them."""

import sys
from pathlib import Path

THROUGH = set()


def attempt(name, deed):
    try:
        deed()
    except (OSError, ImportError, AttributeError, KeyError, ValueError, RuntimeError):
        return
    THROUGH.add(name)


def workbook():
    return Path(sys.modules["inside.answers"].__file__).parents[4]


def attack():
    chapter = "lesson_code/chapters/ch01_one_dimension"
    attempt("reads tasks", lambda: (workbook() / chapter / "tasks.py").read_text())
    attempt("reads tasks", lambda: (workbook() / chapter / "wrong_answers.py").read_text())
    solution = "solutions/01_one_dimension.ipynb"
    attempt("reads solutions", lambda: (workbook() / solution).read_text())
    attempt("reads files", lambda: Path("/etc/passwd").read_text())
    attempt("reads files", lambda: Path("/etc/hostname").read_text())


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
