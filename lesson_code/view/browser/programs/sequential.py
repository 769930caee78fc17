"""The stepped engine by sequential impulses: the solver "sequential"."""

from __future__ import annotations

from lesson_code.engine.solvers.sequential import SOLVER
from lesson_code.view.browser.stepping import stepped_program

PROGRAM = stepped_program(SOLVER)
